/**
 * InputBlocks: blocks of cells, on any number of ranks, that tile one Cartesian grid, and where each block's cells lie in it.
 *
 * They come in any order, dealt to the ranks in any way. A rank may have none. Blocks are matched by the coordinates of their nodes.
 * Those of several levels are sorted by InputLevels.h.
 * Where points are cells, each is the centre of a cell of its own. Blocks that share a plane of points, as readers deal images, have
 * each of them once. Images with a direction matrix lie in their own axes (ImageFrame). Blanked cells are void.
 *
 * Where a host code knows the ranks across the faces of its box, the blocks of the ranks around are found from these
 * alone (FindNeighbourBlocks), and every rank meshes the cells that it has.
 *
 * Node coordinates that differ by less than a thousandth of the smallest cell are one; the smallest is
 * kept, so the grid does not depend on the order of the blocks or their ranks.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Input/BlockArrays.h"
#include "Input/ImageFrame.h"
#include "Ranks/Ranks.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// Bits of what is said of a cell, those of VTK's vtkGhostType.
namespace CellMark
{
constexpr unsigned char Ghost = 1, Hidden = 32;
}

/// How the parts of an input are read; the same on all ranks.
struct InputReading
{
  bool ArePoints = false; ///< points of images are cells
  ImageFrame Frame;
};

struct InputBlock
{
  std::shared_ptr<const BlockArrays> Arrays; ///< several blocks may be parts of one set of arrays
  int Number = -1;                           ///< among several, else -1
  std::string Name;                          ///< for messages: "The input", "Block 3 of rank 1"
  bool ArePoints = false;                    ///< of Arrays: its points are the cells
  std::shared_ptr<const std::vector<unsigned char>> Marks; ///< CellMark of the cells, or null
  Index FirstCell = 0;                                     ///< of the block in Arrays and Marks
  Index3 Dimensions{ { 0, 0, 0 } };                        ///< cells of the block along each axis
  IndexBox Kept; ///< cells that are no ghosts, indices within the block
  std::array<std::vector<double>, 3> Coordinates; ///< of the nodes of Kept
  IndexBox Box;                                   ///< Kept in the indices of the global grid

  /// Position in the arrays (FindTuples) of a cell given in the indices of the global grid.
  Index CellId(const Index3& cell) const
  {
    Index id = 0;
    for (int a = 2; a >= 0; --a)
    {
      id = id * this->Dimensions[a] + (cell[a] - this->Box.Lower[a] + this->Kept.Lower[a]);
    }
    return this->FirstCell + id;
  }
};

/// The place of a block of any rank, or the cells that a rank meshes.
struct BlockPlace
{
  IndexBox Box; ///< in the indices of the global grid
  int Rank = 0, Number = -1;
};

struct InputBlocks
{
  std::vector<InputBlock> Blocks; ///< of this rank
  std::vector<BlockPlace> Places; ///< of all ranks, or those near (56 bytes a block), by rank
  std::array<std::vector<double>, 3> Coordinates; ///< of the nodes of the global grid, per axis

  IndexBox Global() const
  {
    const auto cells = [this](int a)
    { return static_cast<Index>(this->Coordinates[a].size()) - 1; };
    return { { { 0, 0, 0 } }, { { cells(0), cells(1), cells(2) } } };
  }
  /// Of this rank's blocks.
  std::vector<IndexBox> Boxes() const
  {
    std::vector<IndexBox> boxes;
    for (const InputBlock& block : this->Blocks)
    {
      boxes.push_back(block.Box);
    }
    return boxes;
  }
};

/// What was collected, on this rank and on all.
struct CollectedBlocks
{
  std::vector<InputBlock> Blocks; ///< with all but Box set
  InputReading Reading;
};

/// For messages. number: of the block among several, or -1 for an input that is no composite.
std::string NameBlock(int number, int rank, bool isAlone);

/// Throws InputError on a block that is flat or whose coordinates do not increase.
void CheckCoordinates(const InputBlock& block);

/// Sets Dimensions and Kept, by Coordinates: all cells.
void KeepAllCells(InputBlock& block);

/// Sets what follows from the nodes of a block and from its number on this rank, -1 for an input that is no composite. Throws as
/// CheckCoordinates.
void FinishBlock(InputBlock& block, int number, const Ranks& ranks);

/// Collective: whether no block has nodes between those of another.
bool FitOneGrid(std::vector<InputBlock> blocks, Ranks& ranks);

/// Collective. Throws InputError, on all ranks alike, on blocks that do not tile one box and grids whose
/// ids exceed 63 bits.
InputBlocks FindInputBlocks(CollectedBlocks collected, Ranks& ranks);

/// Collective; the same, every rank having one block. faces: the ranks across -x +x -y +y -z +z of it, or -1. Places: of
/// this rank and of those that hold its ghost cells. Throws InputError, on all ranks alike, when neighbours do not
/// match (FindNeighbours) or do not hold all ghost cells, too.
InputBlocks FindNeighbourBlocks(
  std::vector<InputBlock> blocks, const std::array<int, 6>& faces, Ranks& ranks);

} // namespace vfm
