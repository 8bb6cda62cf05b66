#include "ShapeFractions.h"

#include "Input/NodeCoordinates.h"
#include "NumpyFields.h"
#include "PythonRuntime.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesText.h"
#include "Surfaces/SurfaceFractions.h"

namespace vfm
{
namespace
{

IndexBox CellsOf(const NodeCoordinates& coordinates)
{
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = coordinates[a];
    if (x.size() < 2 || !std::is_sorted(x.begin(), x.end(), std::less_equal<double>()))
    {
      throw InputError(std::string("The ") + AxisNames[a] +
        " coordinates must have two nodes or more, and increase.");
    }
    cells.Lower[a] = 0;
    cells.Upper[a] = static_cast<Index>(x.size()) - 1;
  }
  return cells;
}

/// Returns numpy arrays of the buffers that compute(cells) returns; it runs without the GIL.
template <class Compute>
nanobind::list RunToNumpy(
  const NodeCoordinates& coordinates, PythonRuntime& runtime, const Compute& compute)
{
  std::vector<Buffer<double>> fractions;
  runtime.Run([&] { fractions = compute(CellsOf(coordinates)); });
  nanobind::list arrays;
  for (Buffer<double>& values : fractions)
  {
    arrays.append(ToNumpy(values));
  }
  return arrays;
}

std::vector<Shape> MakeShapes(const std::string& text, const NodeCoordinates& coordinates)
{
  Vector3 lower, upper;
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = coordinates[a].front();
    upper[a] = coordinates[a].back();
  }
  std::vector<Shape> shapes = ParseShapes(text, lower, upper);
  if (shapes.empty())
  {
    throw InputError("There is no shape.");
  }
  return shapes;
}

} // namespace

nanobind::list FractionsOfText(const std::string& text, const NodeCoordinates& coordinates,
  double tolerance, PythonRuntime& runtime)
{
  return RunToNumpy(coordinates, runtime,
    [&](const IndexBox& cells)
    {
      return FractionArraysOfShapes(
        coordinates, cells, MakeShapes(text, coordinates), tolerance, runtime);
    });
}

nanobind::list FractionsInside(
  const InputSurfaces& surfaces, const NodeCoordinates& coordinates, PythonRuntime& runtime)
{
  return RunToNumpy(coordinates, runtime,
    [&](const IndexBox& cells)
    { return FractionsOfSurfaces(coordinates, cells, surfaces, runtime); });
}

} // namespace vfm
