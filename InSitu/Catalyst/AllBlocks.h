/**
 * AllBlocks: the boxes of all ranks as one composite data set, as ParaView wants to see a grid of several levels.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkMultiBlockDataSet;

namespace vfm
{

/// Collective: the boxes of all ranks, numbered by rank; those of other ranks are null. Cells below boxes of finer levels are hidden
/// (vtkGhostType, HIDDENCELL), so that ParaView neither draws nor sums them twice; a box has such an array where it has such
/// cells, a copy where the host has one of its own. Throws InputError as CheckHostGrid does.
vtkSmartPointer<vtkMultiBlockDataSet> MakeAllBlocks(const HostGrid& grid, Ranks& ranks);

} // namespace vfm
