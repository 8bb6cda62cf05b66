/**
 * LevelBlocks: what a host code with a refined grid would hand over: a ball on a plate on three levels, in any number of blocks,
 * and the same as vtkOverlappingAMR.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include "vtkSmartPointer.h"

class vtkOverlappingAMR;

namespace vfm
{
namespace testing
{

constexpr Index3 BaseCells{ { 6, 4, 5 } }; // of level 0

/// Fields on a block of the grid. What coarse cells below finer blocks hold is wrong: nobody may look at it.
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

/// Blocks at all places, built from their fields and not from HostGrid. spacing: of level 0.
vtkSmartPointer<vtkOverlappingAMR> MakeOverlapping(
  const std::vector<Place>& places, const Vector3& spacing);

} // namespace testing
} // namespace vfm
