/**
 * RecogniseGrid: finds the Cartesian grid that the hexahedra of an unstructured or structured
 * grid form.
 *
 * Cells may have any order and need not fill a box, as in a part of a decomposed mesh. The
 * positions of cells follow from the coordinates of their eight corners. Cells are divided into
 * boxes: rows along x, which are joined along y and then z.
 */
#pragma once

#include "Input/InputBlocks.h"

class vtkPointSet;

namespace vfm
{

/// Returns the boxes as blocks with Arrays, Marks and FirstCell. Not collective.
/// Cells of less than three dimensions and ghost cells (DUPLICATECELL) are ignored; the result may
/// be empty.
/// @param number,name number and name of all blocks
/// @throws InputError if cells are not hexahedra or voxels, are not boxes with sides along the
/// axes, lie in the same place, or have nodes of other cells between their nodes
std::vector<InputBlock> RecogniseGrid(vtkPointSet* data, int number, const std::string& name);

} // namespace vfm
