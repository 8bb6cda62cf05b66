#include "ShapeFractions.h"

#include "Input/NodeCoordinates.h"
#include "NumpyFields.h"
#include "PythonRuntime.h"
#include "Shapes/ShapesFractions.h"

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

std::vector<Shape> MakeShapes(const NodeCoordinates& coordinates,
  const std::function<std::vector<Shape>(const Vector3&, const Vector3&)>& make)
{
  Vector3 lower, upper;
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = coordinates[a].front();
    upper[a] = coordinates[a].back();
  }
  std::vector<Shape> shapes = make(lower, upper);
  if (shapes.empty())
  {
    throw InputError("There is no shape.");
  }
  return shapes;
}

} // namespace

nanobind::list ComputeFractions(const NodeCoordinates& coordinates,
  const std::function<std::vector<Shape>(const Vector3&, const Vector3&)>& make, double tolerance,
  PythonRuntime& runtime)
{
  std::vector<Buffer<double>> fractions;
  runtime.Run(
    [&]
    {
      const IndexBox cells = CellsOf(coordinates);
      fractions = FractionArraysOfShapes(
        coordinates, cells, MakeShapes(coordinates, make), tolerance, runtime);
    });
  nanobind::list arrays;
  for (Buffer<double>& values : fractions)
  {
    arrays.append(ToNumpy(values));
  }
  return arrays;
}

} // namespace vfm
