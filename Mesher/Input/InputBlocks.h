/**
 * InputBlocks: blocks of cells, on any number of ranks, that tile one Cartesian grid, and their
 * positions in the grid. InputLevels.h sorts blocks of several levels.
 *
 * Blocks may have any order and any distribution over the ranks; a rank may have none. They are
 * matched by the coordinates of their nodes. Node coordinates closer than 1e-3 of the smallest cell
 * width are merged to the smallest of them, so the grid does not depend on order and distribution.
 *
 * If points are used as cells, each point is the centre of a cell. Readers may give a plane of
 * points to both blocks that it separates; it is then used once. Images with a direction matrix are
 * in image axes (ImageFrame). Blanked cells are void.
 *
 * If a host code knows the ranks across the faces of its box, blocks of nearby ranks are found from
 * them (FindNeighbourBlocks), and each rank meshes its own cells.
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

/// Bits of the marks of a cell, as in the VTK array vtkGhostType.
namespace CellMark
{
constexpr unsigned char Ghost = 1, Hidden = 32;
}

/// How the parts of an input are read; equal on all ranks.
struct InputReading
{
  bool ArePoints = false; ///< points of images are used as cells
  ImageFrame Frame;
};

/// A box of cells of the input on this rank. Several blocks may share one set of arrays.
struct InputBlock
{
  std::shared_ptr<const BlockArrays> Arrays;
  int Number = -1;        ///< number among the blocks of a composite data set; -1: not a composite
  std::string Name;       ///< name in messages: "The input", "Block 3 of rank 1"
  bool ArePoints = false; ///< true if the arrays are point data
  std::shared_ptr<const std::vector<unsigned char>> Marks; ///< CellMark of each cell, or null
  Index FirstCell = 0;              ///< position of the first cell in Arrays and Marks
  Index3 Dimensions{ { 0, 0, 0 } }; ///< number of cells along each axis, with ghost cells
  IndexBox Kept;                    ///< cells that are not ghost cells, in indices of the block
  std::array<std::vector<double>, 3> Coordinates; ///< nodes of Kept along each axis
  IndexBox Box;                                   ///< Kept in indices of the global grid

  /// Returns the position in the arrays (FindTuples) of a cell in indices of the global grid.
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

/// A block of any rank, or the cells that a rank meshes.
struct BlockPlace
{
  IndexBox Box; ///< cells in indices of the global grid
  int Rank = 0, Number = -1;
};

/// The blocks of one grid, or of one level of a refined grid.
struct InputBlocks
{
  std::vector<InputBlock> Blocks; ///< blocks of this rank
  /// Blocks of this rank and of others near its blocks or cells (FindPlaces, FindOwners), by rank.
  std::vector<BlockPlace> Places;
  std::array<std::vector<double>, 3> Coordinates; ///< nodes of the global grid along each axis

  IndexBox Global() const
  {
    const auto cells = [this](int a)
    { return static_cast<Index>(this->Coordinates[a].size()) - 1; };
    return { { { 0, 0, 0 } }, { { cells(0), cells(1), cells(2) } } };
  }
  /// Returns the boxes of the blocks of this rank.
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

/// Blocks before their positions in the grid are known.
struct CollectedBlocks
{
  std::vector<InputBlock> Blocks; ///< blocks of this rank, all members set except Box
  InputReading Reading;
};

/// Returns the name of a block in messages.
/// @param number number of the block; -1 if the input is not a composite data set
/// @param isAlone whether there is only one rank; the name then has no rank
std::string NameBlock(int number, int rank, bool isAlone);

/// Checks the node coordinates of a block.
/// @throws InputError if the block is flat, or if coordinates do not increase or are not finite
void CheckCoordinates(const InputBlock& block);

/// Sets Dimensions and Kept to all cells between Coordinates.
void KeepAllCells(InputBlock& block);

/// Sets Number, Name, Dimensions and Kept of a block without ghost cells.
/// @param number number of the block; -1 if the input is not a composite data set
/// @throws InputError as CheckCoordinates does
void FinishBlock(InputBlock& block, int number, const Ranks& ranks);

/// Returns whether all blocks fit one grid: no block has nodes between the nodes of another.
/// @pre Collective
bool FitOneGrid(std::vector<InputBlock> blocks, Ranks& ranks);

/// Finds the positions of all blocks in one grid.
/// @throws InputError if blocks do not tile one box, or ids would exceed 63 bits; on all ranks
/// @pre Collective
InputBlocks FindInputBlocks(CollectedBlocks collected, Ranks& ranks);

/// Finds the positions of blocks in one grid from face neighbours; each rank has one block.
/// @param faces ranks across -x +x -y +y -z +z of the block, or -1
/// @return Places has this rank and the ranks that hold its ghost cells
/// @throws InputError if FindInputBlocks does, or if neighbours do not match (FindNeighbours) or do
/// not hold all ghost cells; on all ranks
/// @pre Collective
InputBlocks FindNeighbourBlocks(
  std::vector<InputBlock> blocks, const std::array<int, 6>& faces, Ranks& ranks);

} // namespace vfm
