/**
 * GatherGeometry: the surfaces, curves or vertices of all ranks on rank 0.
 */
#pragma once

#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace vfm
{

/// Collective. part: this rank's cells of one kind, as the filters make them: points have global ids; numbers: the cell array with the id
/// of the surface, curve or vertex. On rank 0 all cells in the order of these ids, then of their points, and the points in the order of
/// their ids, each once: the same from any number of ranks. Null on other ranks, and without any cells.
vtkSmartPointer<vtkPolyData> GatherGeometry(vtkPolyData* part, const char* numbers, Ranks& ranks);

} // namespace vfm
