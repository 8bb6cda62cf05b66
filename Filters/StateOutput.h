/**
 * StateOutput: adds the state of a mesh as VTK arrays.
 */
#pragma once

#include "State/OutputState.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Adds cell arrays, and a point array of nodal velocities. Takes over their memory without a copy.
void SetStateOutput(OutputState& state, vtkUnstructuredGrid* mesh);

/// Adds point arrays in the same way.
void AddPointArrays(std::vector<TransferredArray>& arrays, vtkUnstructuredGrid* mesh);

} // namespace vfm
