/**
 * InputBlocks: the blocks of a VTK data object, on any number of ranks, that tile one Cartesian grid, and where
 * each block's cells lie in it.
 *
 * Taken are vtkImageData, vtkUniformGrid, vtkRectilinearGrid, vtkUnstructuredGrid and vtkStructuredGrid whose cells are
 * those of a Cartesian grid (RecogniseGrid), and composite data sets of them, in any order, dealt to the ranks in any way. A rank
 * may have none. Blocks are matched by the coordinates of their nodes, so extents may restart at 0 in every block. Those of
 * several levels are sorted by InputLevels.h.
 * Where point data of images are chosen, each point is the centre of a cell of its own: the grid begins half a spacing lower, and has a
 * cell more along each axis than the image. Blocks that share a plane of points, as readers deal images, have each of them once.
 * Images with a direction matrix lie in their own axes (ImageFrame).
 * Ghost cells (vtkGhostType, DUPLICATECELL) are dropped: in images and rectilinear grids they may only form layers on the
 * sides of a block. Blanked cells (HIDDENCELL) stay and are void.
 *
 * Where a host code knows the ranks across the faces of its box, the blocks of the ranks around are found from these
 * alone (FindNeighbourBlocks), and every rank meshes the cells that it has.
 *
 * Node coordinates that differ by less than a thousandth of the smallest cell are one; the smallest is
 * kept, so the grid does not depend on the order of the blocks or their ranks.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Base/Ranks.h"
#include "ChosenArray.h"
#include "ImageFrame.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;

namespace vfm
{

class CellOrder;

/// How the parts of an input are read; the same on all ranks.
struct InputReading
{
  int Association = vtkDataObject::CELL; ///< of the arrays; POINT: points of images are cells
  ImageFrame Frame;
};

/// A data set, or of one that does not lie in the order of a grid one of the boxes that it was cut into.
struct InputBlock
{
  vtkDataSet* Data = nullptr;
  int Number = -1;                       ///< in a composite data set, else -1
  std::string Name;                      ///< for messages: "The input", "Block 3 of rank 1"
  int Association = vtkDataObject::CELL; ///< of Data's arrays; POINT: its points are the cells
  vtkSmartPointer<vtkUnsignedCharArray> GhostTypes; ///< of all cells, in Order, or null
  std::shared_ptr<CellOrder> Order;                 ///< of the cells of Data; null: as they are
  Index FirstCell = 0;                              ///< of the block in that order
  Index3 Dimensions{ { 0, 0, 0 } };                 ///< cells of the block along each axis
  IndexBox Kept; ///< cells that are no ghosts, indices within the block
  std::array<std::vector<double>, 3> Coordinates; ///< of the nodes of Kept
  IndexBox Box;                                   ///< Kept in the indices of the global grid

  /// Of the arrays of Data.
  Index NumberOfTuples() const { return this->Data->GetNumberOfElements(this->Association); }

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

/// Collective; data: this rank's part, null for none. Throws InputError, on all ranks alike, on data of another kind, flat or empty grids,
/// direction matrices that differ or are sheared, points of grids that are no images, arrays of points beside those of cells, coordinates that do not increase, hexahedra that
/// are no cells of a Cartesian grid.
CollectedBlocks CollectAllBlocks(vtkDataObject* data, const ArraysToRead& arrays, Ranks& ranks);

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
