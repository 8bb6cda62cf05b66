#include "LevelBlocks.h"

#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkOverlappingAMR.h"

#include <cmath>

namespace vfm
{
namespace testing
{
namespace
{

constexpr Vector3 Origin{ { -1.0, 0.5, 2.0 } };

/// Returns whether a point, in cells of level 0, is in the ball.
bool IsInBall(const Vector3& x)
{
  const Vector3 centre{ { 3.1, 2.0, 2.4 } };
  double distance = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    distance += (x[a] - centre[a]) * (x[a] - centre[a]);
  }
  return distance < 1.44;
}

/// Returns the fractions of a cell in the ball and in the plate below it, from samples.
std::array<double, 2> PartsOf(const Index3& cell, int level)
{
  constexpr int samples = 4;
  constexpr double height = 1.6;
  std::array<int, 2> inside{ { 0, 0 } };
  for (int s = 0; s < samples * samples * samples; ++s)
  {
    const int at[3] = { s % samples, s / samples % samples, s / (samples * samples) };
    Vector3 x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = std::ldexp(static_cast<double>(cell[a]) + (at[a] + 0.5) / samples, -level);
    }
    const bool isInBall = IsInBall(x);
    inside[0] += isInBall;
    inside[1] += !isInBall && x[2] < height;
  }
  return { { inside[0] / 64.0, inside[1] / 64.0 } };
}

template <class Array, class Value>
void AddArray(vtkDataSet* grid, const char* name, const std::vector<Value>& values, int components)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  grid->GetCellData()->AddArray(array);
}

vtkSmartPointer<vtkUniformGrid> MakeUniformGrid(const LevelBlock& block)
{
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  double spacing[3];
  for (int a = 0; a < 3; ++a)
  {
    spacing[a] = (block.Bounds[3 + a] - block.Bounds[a]) / block.Intervals[a];
  }
  grid->SetOrigin(block.Bounds.data());
  grid->SetSpacing(spacing);
  grid->SetDimensions(block.Intervals[0] + 1, block.Intervals[1] + 1, block.Intervals[2] + 1);
  AddArray<vtkDoubleArray>(grid, "ball", block.Ball, 1);
  AddArray<vtkDoubleArray>(grid, "plate", block.Plate, 1);
  AddArray<vtkDoubleArray>(grid, "velocity", block.Velocity, 3);
  AddArray<vtkIntArray>(grid, "id", block.Labels, 1);
  return grid;
}

} // namespace

LevelBlock::LevelBlock(int level, const IndexBox& cells, const Vector3& spacing) :
  Level(level), Cells(cells)
{
  for (int a = 0; a < 3; ++a)
  {
    const double width = std::ldexp(spacing[a], -level);
    this->Intervals[a] = static_cast<int>(cells.Size(a));
    this->Bounds[a] = Origin[a] + width * static_cast<double>(cells.Lower[a]);
    this->Bounds[3 + a] = Origin[a] + width * static_cast<double>(cells.Upper[a]);
  }
  ForCells(cells,
    [&](const Index3& cell)
    {
      const std::array<double, 2> parts = PartsOf(cell, level);
      this->Ball.push_back(parts[0]);
      this->Plate.push_back(parts[1]);
      this->Labels.push_back(parts[0] + parts[1] < 0.5 ? 0 : parts[0] >= parts[1] ? 1 : 2);
      for (Index x : cell)
      {
        this->Velocity.push_back(static_cast<double>(x + 100 * level));
      }
    });
}

std::vector<Place> NestedPlaces()
{
  return { { 0, { { { 0, 0, 0 } }, BaseCells } }, { 1, { { { 2, 0, 2 } }, { { 6, 8, 8 } } } },
    { 1, { { { 6, 0, 2 } }, { { 10, 8, 8 } } } }, { 2, { { { 8, 4, 8 } }, { { 16, 12, 16 } } } } };
}

std::vector<Place> CutPlaces()
{
  std::vector<Place> places;
  for (const Place& place : NestedPlaces())
  {
    const Index middle = (place.Cells.Lower[0] + place.Cells.Upper[0]) / 2;
    places.insert(places.end(), 2, place);
    places[places.size() - 2].Cells.Upper[0] = middle;
    places.back().Cells.Lower[0] = middle;
  }
  return places;
}

std::vector<Place> LeafPlaces()
{
  return { { 0, { { { 0, 0, 0 } }, { { 2, 4, 5 } } } }, { 0, { { { 5, 0, 0 } }, BaseCells } },
    { 1, { { { 4, 0, 0 } }, { { 10, 8, 10 } } } } };
}

LevelGrids MakeGrids(const std::vector<Place>& places, const Vector3& spacing, int rank, int ranks)
{
  LevelGrids grids;
  int number = 0;
  for (const Place& place : places)
  {
    grids.resize(std::max<std::size_t>(grids.size(), place.Level + 1));
    const bool isOwn = number++ % ranks == rank;
    grids[place.Level].push_back(
      isOwn ? MakeUniformGrid(LevelBlock(place.Level, place.Cells, spacing)) : nullptr);
  }
  return grids;
}

vtkSmartPointer<vtkOverlappingAMR> MakeOverlapping(
  const std::vector<Place>& places, const Vector3& spacing, int rank, int ranks)
{
  auto data = vtkSmartPointer<vtkOverlappingAMR>::New();
  const LevelGrids grids = MakeGrids(places, spacing);
  SetGrids(MakeGrids(places, spacing, rank, ranks), data.Get());
  data->SetOrigin(Origin.data());
  for (unsigned int level = 0; level < grids.size(); ++level)
  {
    data->SetSpacing(level, grids[level][0]->GetSpacing());
    data->SetRefinementRatio(level, 2);
    for (unsigned int i = 0; i < grids[level].size(); ++i)
    {
      vtkUniformGrid* grid = grids[level][i];
      data->SetAMRBox(level, i,
        vtkAMRBox(grid->GetOrigin(), grid->GetDimensions(), grid->GetSpacing(), Origin.data()));
    }
  }
  data->GenerateParentChildInformation();
  return data;
}

} // namespace testing
} // namespace vfm
