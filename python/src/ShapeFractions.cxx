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
        " coordinates must be those of two nodes or more, and increase.");
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

std::vector<Buffer<double>> Fill(const NodeCoordinates& coordinates,
  const std::vector<Shape>& shapes, double tolerance, Runtime& runtime)
{
  const IndexBox all = CellsOf(coordinates);
  std::vector<Buffer<double>> fractions;
  for (int m = 0; m < CountMaterials(shapes); ++m)
  {
    fractions.emplace_back(all.NumberOfCells(), 0.0);
  }
  const auto write = [&](const IndexBox& box, const std::vector<FractionField::Part>& parts)
  {
    for (const FractionField::Part& part : parts)
    {
      double* values = fractions[part.Material - 1].data();
      Runtime alone;
      ForRows(alone, box,
        [&](Index j, Index k, Index)
        {
          const Index row = IndexInBox(all, { { box.Lower[0], j, k } });
          std::fill_n(values + row, box.Size(0), part.Fraction);
        });
    }
  };
  runtime.Progress(0.0, "Computing fractions");
  ComputeShapeFractions(coordinates, all, shapes, tolerance, runtime, write);
  return fractions;
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
      CellsOf(coordinates);
      fractions = Fill(coordinates, MakeShapes(coordinates, make), tolerance, runtime);
    });
  nanobind::list arrays;
  for (Buffer<double>& values : fractions)
  {
    arrays.append(ToNumpy(values));
  }
  return arrays;
}

} // namespace vfm
