/**
 * WriteEquations: periodic conditions for Abaqus and CalculiX.
 *
 * The displacement u of a copy of a point is that of its partner plus that of a reference node per
 * period between them: u(copy) = u(partner) + n_x u(REF_X) + n_y u(REF_Y) + n_z u(REF_Z). The
 * displacement of REF_X is thus the change of the vector between opposite points of the sides
 * x_min and x_max: the mean gradient of the displacement along x times the period.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes reference nodes, their sets REF_X to REF_Z along periodic axes, and the equations; the
/// main file includes this file. Writes nothing if the mesh is not periodic.
/// @param mesh  whole mesh; nodes have the numbers 1, 2, 3, ..
/// @return whether the file was written
/// @throws InputError  if FindPeriodicPairs does, or the file cannot be written
bool WriteEquations(const MeshData& mesh, const std::string& path, OutputSet& files);

} // namespace vfm
