/**
 * InputLevels: the blocks of an input, sorted by the levels of a refined grid (AMR), and their
 * positions in the grid of their level.
 *
 * Level 0 has the widest cells; each further level halves the cells along all axes (OctreeKeys.h).
 * The cell width of a block determines its level, so any composite data set is accepted. A block of
 * ratio 4 is two levels higher, and levels may have no blocks. If there are several levels, blocks
 * have cells of equal width; a single level may be graded.
 *
 * All levels together fill a box. Below finer blocks, coarser blocks may exist (vtkOverlappingAMR)
 * or not (vtkNonOverlappingAMR); their values there are ignored, independent of vtkGhostType. Finer
 * blocks cover a cell completely or not at all.
 *
 * The nodes of level 0 come from its blocks, elsewhere from the coarsest blocks that have them.
 * Nodes of finer levels are midpoints. Nodes of blocks must match to 1e-3 of a cell.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <optional>

namespace vfm
{

/// The levels of an input.
struct InputLevels
{
  /// Levels from the coarsest to the finest; Coordinates belong to the whole grid of a level.
  std::vector<InputBlocks> Levels;

  InputReading Reading;

  int Finest() const { return static_cast<int>(this->Levels.size()) - 1; }
};

/// Converts boxes to another level; levels: number of levels, negative for coarser ones.
std::vector<BlockPlace> ChangeLevel(std::vector<BlockPlace> places, int levels);

/// Cells in a box of a level that contain data of that level or of a finer one.
class LevelCover
{
public:
  LevelCover(const InputLevels& input, int level, const IndexBox& box);
  /// Marks the local cells of a grid of the level, which may be periodic.
  LevelCover(const InputLevels& input, int level, const CartesianGrid& grid);

  bool Has(const Index3& cell) const { return this->Covered[IndexInBox(this->Box, cell)]; }
  /// Returns whether no cell contains such data.
  bool IsEmpty() const
  {
    return std::find(this->Covered.begin(), this->Covered.end(), true) == this->Covered.end();
  }

private:
  void Add(const IndexBox& box);

  IndexBox Box;
  std::vector<bool> Covered;
};

/// Sorts blocks by level. Does not find gaps between several levels (CheckCover).
/// @throws InputError if FindInputBlocks does (one level); on all ranks. If there are several
/// levels, also if cell widths do not differ by powers of two, or if blocks of a level overlap or
/// do not lie on its grid. Ids must fit into 63 bits, and point arrays must not be selected.
/// @pre Collective
InputLevels FindInputLevels(CollectedBlocks collected, Ranks& ranks);

/// Finds the positions of the blocks of an input of one level from face neighbours; each rank has
/// one block.
/// @param faces ranks across -x +x -y +y -z +z of the block, or -1
/// @throws InputError if FindNeighbourBlocks does, or if point arrays are selected; on all ranks
/// @pre Collective
InputLevels FindNeighbourLevels(
  CollectedBlocks collected, const std::array<int, 6>& faces, Ranks& ranks);

/// Calls FindNeighbourLevels if all ranks give face neighbours, or FindInputLevels if none does.
/// @throws InputError as they do, and if only some ranks give face neighbours
/// @pre Collective
InputLevels FindLevels(
  CollectedBlocks collected, const std::optional<std::array<int, 6>>& faces, Ranks& ranks);

/// Checks that blocks cover a box of cells of level 0. A single level is not checked again.
/// @throws InputError if a cell is in no block, or if finer blocks cover only a part of a cell
void CheckCover(const InputLevels& input, const IndexBox& box);

} // namespace vfm
