/**
 * StateOutput: adds the state of a mesh as VTK arrays.
 */
#pragma once

#include "State/OutputState.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace vfm
{

/// Adds cell arrays, and a point array of nodal velocities. Takes over their memory without a copy.
void SetStateOutput(OutputState& state, vtkUnstructuredGrid* mesh);

/// Adds point arrays in the same way.
void AddPointArrays(std::vector<TransferredArray>& arrays, vtkUnstructuredGrid* mesh);

/// Fills an output with particles: a vertex each, with the point arrays of ViewParticles. The state
/// is adopted, not copied.
/// @param fields  field data of the mesh, of which the output gets the names and ids of materials
void SetParticleOutput(
  Particles& particles, const std::vector<FieldArray>& fields, vtkPolyData* output);

} // namespace vfm
