/**
 * GatherMesh: the mesh of all ranks as one on rank 0.
 */
#pragma once

#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: on rank 0 the whole mesh, points and cells in the order of their global ids, points between ranks once, also
/// those of pieces that one rank read: the mesh of one rank, with its time. On other ranks null. Rank 0 needs the memory of the mesh three times.
vtkSmartPointer<vtkUnstructuredGrid> GatherMesh(vtkUnstructuredGrid* mesh, Ranks& ranks);

} // namespace vfm
