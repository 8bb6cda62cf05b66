/**
 * LevelBlocks: data of a simulation with a refined grid: a ball on a plate on three levels, in any
 * number of blocks, also as vtkOverlappingAMR.
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

constexpr Index3 BaseCells{ { 6, 4, 5 } }; // number of cells of level 0

/// Fields on a block of the grid. Values of coarse cells below finer blocks
/// are wrong: they must not be read.
struct LevelBlock
{
  LevelBlock(int level, const IndexBox& cells, const Vector3& spacing);

  int Level;
  IndexBox Cells; ///< in cells of the block's level
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

/// Returns three levels; the coarsest covers the whole domain.
std::vector<Place> NestedPlaces();
/// Returns NestedPlaces with each place cut in two along x.
std::vector<Place> CutPlaces();
/// Returns two levels; no coarse cells lie below the finer ones.
std::vector<Place> LeafPlaces();

/// Blocks of each level, at the given places. They are built from their fields and not by HostGrid,
/// and are distributed to the ranks in turn; null for blocks of other ranks. spacing: of level 0.
using LevelGrids = std::vector<std::vector<vtkSmartPointer<vtkUniformGrid>>>;
LevelGrids MakeGrids(
  const std::vector<Place>& places, const Vector3& spacing, int rank = 0, int ranks = 1);

/// Returns the blocks in one data set, which contains the boxes of all ranks.
vtkSmartPointer<vtkOverlappingAMR> MakeOverlapping(
  const std::vector<Place>& places, const Vector3& spacing, int rank = 0, int ranks = 1);

/// Sets the grids and boxes of another kind of refined grid. Amr: a subclass of
/// vtkUniformGridAMR, or the class itself.
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
