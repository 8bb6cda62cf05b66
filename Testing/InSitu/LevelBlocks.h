/**
 * LevelBlocks: what a host code with a refined grid would hand over: a ball on a plate on three
 * levels, in any number of blocks, and the same as vtkOverlappingAMR.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "VtkVersions.h"

#include "vtkSmartPointer.h"
#include "vtkUniformGrid.h"

class vtkOverlappingAMR;

namespace vfm
{
namespace testing
{

constexpr Index3 BaseCells{ { 6, 4, 5 } }; // of level 0

/// Fields on a block of the grid. What coarse cells below finer blocks hold is wrong: nobody may
/// look at it.
struct LevelBlock
{
  LevelBlock(int level, const IndexBox& cells, const Vector3& spacing);

  int Level;
  IndexBox Cells; ///< of its level
  std::array<double, 6> Bounds;
  std::array<int, 3> Intervals;
  std::vector<double> Ball, Plate, Velocity; ///< 1, 1, 3 components
  std::vector<int> Labels;                   ///< 0 void, 1 ball, 2 plate
};

struct Place
{
  int Level;
  IndexBox Cells;
};

/// Three levels: the coarsest everywhere.
std::vector<Place> NestedPlaces();
/// The same, each place cut into two along x.
std::vector<Place> CutPlaces();
/// Two levels, with none of the coarser one below the finer.
std::vector<Place> LeafPlaces();

/// Of each level the blocks at the places, built from their fields and not from HostGrid; dealt in
/// turn to the ranks, null where another has a block. spacing: of level 0.
using LevelGrids = std::vector<std::vector<vtkSmartPointer<vtkUniformGrid>>>;
LevelGrids MakeGrids(
  const std::vector<Place>& places, const Vector3& spacing, int rank = 0, int ranks = 1);

/// The same in one data set, which knows the boxes of all ranks.
vtkSmartPointer<vtkOverlappingAMR> MakeOverlapping(
  const std::vector<Place>& places, const Vector3& spacing, int rank = 0, int ranks = 1);

/// The grids and boxes of other kinds of refined grids. Amr: vtkUniformGridAMR or what derives from
/// it.
template <class Amr>
void SetGrids(const LevelGrids& grids, Amr* data)
{
  std::vector<unsigned int> counts;
  for (const auto& level : grids)
  {
    counts.push_back(static_cast<unsigned int>(level.size()));
  }
  SetNumberOfBoxes(data, counts);
  for (unsigned int level = 0; level < grids.size(); ++level)
  {
    for (unsigned int i = 0; i < grids[level].size(); ++i)
    {
      if (vtkUniformGrid* grid = grids[level][i])
      {
        data->SetDataSet(level, i, grid);
      }
    }
  }
}

} // namespace testing
} // namespace vfm
