/**
 * RecogniseGrid: finds the Cartesian grid whose cells the hexahedra of an unstructured or structured grid are.
 *
 * The cells may come in any order and need not fill a box (a part of a decomposed mesh does not): they are cut into boxes,
 * rows along x first, which then grow along y and z. No file says where a cell lies in the grid; the coordinates
 * of its eight corners do.
 */
#pragma once

#include "Input/InputBlocks.h"

class vtkPointSet;

namespace vfm
{

/// The boxes as blocks of that number and name, with Arrays, Marks and FirstCell set. Cells of less than three dimensions
/// and ghost cells (DUPLICATECELL) are left out; none when nothing remains. Nothing here communicates. Throws InputError on
/// cells that are no hexahedra or voxels, or no boxes with sides along the axes, that lie in the same place, or that have nodes of
/// other cells between their own.
std::vector<InputBlock> RecogniseGrid(vtkPointSet* data, int number, const std::string& name);

} // namespace vfm
