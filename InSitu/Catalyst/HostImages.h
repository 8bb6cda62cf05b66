/**
 * HostImages: converts a HostGrid to VTK data without a copy.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkMultiBlockDataSet;

namespace vfm
{

/// Makes one image per box of this rank. Its origin is the origin of the grid, and its extent
/// counts the nodes of its level in the whole grid. Coordinates are therefore bitwise identical on
/// all ranks and on all levels that have the node. Cell arrays are the memory of the simulation.
/// @param first  block number of the first box of this rank
/// @param total  number of blocks; blocks of other ranks are null
/// @throws InputError  same conditions as CheckHostGrid
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(
  const HostGrid& grid, unsigned int first, unsigned int total);

/// Makes one block per box of all ranks, numbered by rank; blocks of other ranks are null. Cells
/// below boxes of finer levels are hidden (vtkGhostType, HIDDENCELL), so that ParaView neither
/// draws nor sums them twice. Only boxes with such cells get the array; it contains the marks of
/// the simulation, if any.
/// @throws InputError  same conditions as CheckHostGrid
/// @pre Collective
vtkSmartPointer<vtkMultiBlockDataSet> MakeAllBlocks(const HostGrid& grid, Ranks& ranks);

} // namespace vfm
