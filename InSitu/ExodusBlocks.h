/**
 * ExodusBlocks: the mesh as vtkIOSSWriter wants it, one element block a material.
 */
#pragma once

#include "Ranks.h"

#include "vtkSmartPointer.h"

class vtkPartitionedDataSetCollection;
class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: the blocks of the materials that have elements on any rank, named as the materials, the same on all ranks.
/// Node and element ids are GlobalPointIds and GlobalCellIds.
vtkSmartPointer<vtkPartitionedDataSetCollection> MakeExodusBlocks(
  vtkUnstructuredGrid* mesh, Ranks& ranks);

} // namespace vfm
