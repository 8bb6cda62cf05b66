#include "ShapeFractions.h"

#include "Input/InputLevels.h"
#include "Input/NodeCoordinates.h"
#include "Levels/LevelSets.h"
#include "NumpyFields.h"
#include "Options/SetOptions.h"
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

/// Returns the values of an array of doubles in contiguous memory.
Buffer<double> CopyOf(const BlockArray& array)
{
  Buffer<double> values(array.Tuples);
  std::copy_n(static_cast<const double*>(array.Memory), array.Tuples, values.data());
  return values;
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

nanobind::list FractionsOfArrays(const std::vector<std::pair<std::string, NumpyArray>>& arrays,
  const NodeCoordinates& coordinates, const std::string& rule, const std::string& inside,
  PythonRuntime& runtime)
{
  MesherOptions options;
  SetOption(options, "LevelSets", rule);
  SetOption(options, "LevelSetInside", inside);
  LevelSetSource source{ {}, options.LevelSets, options.LevelSetInside == LevelSetSign::Positive };
  for (const auto& array : arrays)
  {
    source.Arrays.push_back(array.first);
  }
  return RunToNumpy(coordinates, runtime,
    [&](const IndexBox& cells)
    {
      InputBlock block;
      block.Coordinates = coordinates;
      FinishBlock(block, -1, runtime.Group());
      block.Arrays = MakeBlockArrays(cells.NumberOfCells(), arrays);
      CollectedBlocks collected;
      collected.Blocks.push_back(std::move(block));
      const InputLevels levels = FindInputLevels(std::move(collected), runtime.Group());
      const auto found = FractionsOfLevelSets(levels.Levels, source, runtime);
      std::vector<Buffer<double>> fractions;
      for (const std::string& name : source.Arrays)
      {
        fractions.push_back(CopyOf(*found[0].Blocks[0].Arrays->Find(name)));
      }
      return fractions;
    });
}

} // namespace vfm
