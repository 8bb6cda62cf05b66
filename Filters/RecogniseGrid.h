/**
 * RecogniseGrid: finds the Cartesian grid that the hexahedra of an unstructured or structured
 * grid of VTK form.
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
/// @throws InputError if cells are not hexahedra or voxels, or as FindHexBoxes does
std::vector<InputBlock> RecogniseGrid(vtkPointSet* data, int number, const std::string& name);

} // namespace vfm
