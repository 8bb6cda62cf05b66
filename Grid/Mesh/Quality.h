/**
 * Quality of elements as verdict measures it.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Scaled Jacobian of a hex with VTK corner order: the smallest over its 8 corners and its centre of the determinant
/// over the product of the edge lengths, -1..1 (Knupp 2000; verdict's hex_scaled_jacobian).
double HexScaledJacobian(const double* points, const Index* hex);

/// Fills mesh.ScaledJacobian, and minimum and mean over all ranks in the report; of tets the dihedral angles too. Collective.
void ComputeQuality(Mesh& mesh, Runtime& runtime, MeshReport& report);

} // namespace vfm
