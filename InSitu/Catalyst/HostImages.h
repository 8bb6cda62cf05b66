/**
 * HostImages: a HostGrid as VTK data, without a copy.
 */
#pragma once

#include "HostGrid.h"

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkMultiBlockDataSet;

namespace vfm
{

/// The box as an image whose extent counts the nodes of its level in the whole grid and whose origin is the grid's: coordinates are
/// the same bits on every rank, and on every level that has the node. Its cell arrays are the host's memory. Throws InputError as CheckHostGrid does.
vtkSmartPointer<vtkImageData> MakeImage(const HostGrid& grid, const HostBox& box);

/// All boxes as blocks first, first + 1, ... of total blocks; the others, those of other ranks, are null.
/// Throws InputError as CheckHostGrid does.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(
  const HostGrid& grid, unsigned int first, unsigned int total);

} // namespace vfm
