/**
 * InputLevels: the blocks of an input, sorted by the levels of a refined grid (AMR), and where their cells lie in the grid of
 * their level.
 *
 * Level 0 has the widest cells; each level halves the cells of the one before along every axis (OctreeKeys.h). The level of
 * a block follows from its cells' widths alone, so any composite data set serves, and blocks of ratio 4 lie two levels up;
 * levels between may have no blocks. Blocks of several levels have cells of equal widths; those of one level may be graded.
 *
 * Level 0 and the finer ones together fill a box. Where there are finer blocks, coarser ones may lie below (vtkOverlappingAMR)
 * or not (vtkNonOverlappingAMR): what they hold there is ignored, whatever vtkGhostType says. A cell is covered by finer
 * blocks in whole or not at all.
 *
 * The nodes of level 0 are those of its blocks, and beyond them of the coarsest blocks that have them; finer ones are halves.
 * Blocks must agree with them to a thousandth of a cell.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <optional>

namespace vfm
{

struct InputLevels
{
  std::vector<InputBlocks>
    Levels; ///< from the coarsest on; Coordinates are those of the level's whole grid

  InputReading Reading;

  int Finest() const { return static_cast<int>(this->Levels.size()) - 1; }
};

/// Of all places.
std::vector<BlockPlace> ChangeLevel(std::vector<BlockPlace> places, int levels);

/// The cells of a box of some level that hold data of that level or of a finer one.
class LevelCover
{
public:
  LevelCover(const InputLevels& input, int level, const IndexBox& box);

  bool Has(const Index3& cell) const { return this->Covered[IndexInBox(this->Box, cell)]; }
  /// Whether there is none.
  bool IsEmpty() const
  {
    return std::find(this->Covered.begin(), this->Covered.end(), true) == this->Covered.end();
  }

private:
  IndexBox Box;
  std::vector<bool> Covered;
};

/// Collective. Throws InputError, on all ranks alike, as FindInputBlocks does; of several levels, when widths differ by no power of two, blocks do not lie on the grid of their
/// level, blocks of one level overlap, or ids exceed 63 bits, and when arrays of points are chosen. Gaps are found by CheckCover.
InputLevels FindInputLevels(CollectedBlocks collected, Ranks& ranks);

/// Collective; the same of an input of one level, every rank having one block (FindNeighbourBlocks).
/// Refuses arrays of points, too.
InputLevels FindNeighbourLevels(
  CollectedBlocks collected, const std::array<int, 6>& faces, Ranks& ranks);

/// Collective: the one or the other, by neighbours where every rank knows them. Throws InputError when some ranks do alone.
InputLevels FindLevels(
  CollectedBlocks collected, const std::optional<std::array<int, 6>>& faces, Ranks& ranks);

/// Throws InputError when, in a box of cells of level 0, some are in no block, or finer blocks cover a part of a cell. Of a
/// single level nothing is checked: it has no gaps.
void CheckCover(const InputLevels& input, const IndexBox& box);

} // namespace vfm
