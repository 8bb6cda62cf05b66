/**
 * StateOutput: values of the input that a mesh has, as arrays of VTK.
 */
#pragma once

#include "State/CarryState.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Cell arrays and, of nodes, a point array. Their memory is adopted, not copied.
void SetStateOutput(OutputState& state, vtkUnstructuredGrid* mesh);

} // namespace vfm
