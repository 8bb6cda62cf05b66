/**
 * InputBlocks: the blocks of a VTK data object that tile one Cartesian grid, and where each block's
 * cells lie in it.
 *
 * Taken are vtkImageData, vtkUniformGrid, vtkRectilinearGrid and composite data sets of them, in any
 * order; a vtkUniformGridAMR when only one of its levels holds blocks. Blocks are matched by the
 * coordinates of their nodes, so extents may restart at 0 in every block. Ghost cells
 * (vtkGhostType, DUPLICATECELL) are dropped: they may only form layers on the sides of a block. Blanked
 * cells (HIDDENCELL) stay and are void.
 *
 * Node coordinates that differ by less than a thousandth of the smallest cell are one; the smallest is
 * kept, so the grid does not depend on the order of the blocks.
 */
#pragma once

#include "CartesianGrid.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkUnsignedCharArray;

namespace vfm
{

struct InputBlock
{
  vtkDataSet* Data = nullptr;
  std::string Name;                               ///< for messages: "The input", "Block 3"
  vtkUnsignedCharArray* GhostTypes = nullptr;     ///< of all cells of Data, or null
  Index3 Dimensions{ { 0, 0, 0 } };               ///< cells of Data along each axis
  IndexBox Kept;                                  ///< cells that are no ghosts, indices within Data
  std::array<std::vector<double>, 3> Coordinates; ///< of the nodes of Kept
  IndexBox Box;                                   ///< Kept in the indices of the global grid

  /// Position in Data's cell arrays of a cell given in the indices of the global grid.
  Index CellId(const Index3& cell) const
  {
    Index id = 0;
    for (int a = 2; a >= 0; --a)
    {
      id = id * this->Dimensions[a] + (cell[a] - this->Box.Lower[a] + this->Kept.Lower[a]);
    }
    return id;
  }
};

struct InputBlocks
{
  std::vector<InputBlock> Blocks;
  std::array<std::vector<double>, 3> Coordinates; ///< of the nodes of the global grid, per axis
  /// Per layer of cells along z, the blocks that reach into it.
  std::vector<std::vector<int>> Layers;
};

/// Throws InputError on data of another kind, flat or empty grids, rotated images, coordinates that do
/// not increase, blocks that do not tile one box, and grids whose ids exceed 63 bits.
InputBlocks FindInputBlocks(vtkDataObject* input);

} // namespace vfm
