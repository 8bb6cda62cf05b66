/**
 * HostImages: a HostGrid as VTK data, without a copy.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkMultiBlockDataSet;

namespace vfm
{

/// The boxes as blocks first, first + 1, ... of total blocks; the others, those of other ranks, are null. Each is an image whose extent counts
/// the nodes of its level in the whole grid and whose origin is the grid's: coordinates are the same bits on every rank, and on
/// every level that has the node. Its cell arrays are the host's memory. Throws InputError as CheckHostGrid does.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(
  const HostGrid& grid, unsigned int first, unsigned int total);

/// Collective: the boxes of all ranks, numbered by rank; those of other ranks are null. Cells below boxes of finer levels are hidden
/// (vtkGhostType, HIDDENCELL), so that ParaView neither draws nor sums them twice; a box has such an array where it has such
/// cells, a copy where the host has one of its own. Throws InputError as CheckHostGrid does.
vtkSmartPointer<vtkMultiBlockDataSet> MakeAllBlocks(const HostGrid& grid, Ranks& ranks);

} // namespace vfm
