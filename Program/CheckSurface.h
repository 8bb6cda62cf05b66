/**
 * CheckSurface: checks whether the elements of a mesh conform, by the faces of only one element.
 */
#pragma once

#include "Report/MeshData.h"

namespace vfm
{

/// Topology of the surface of a mesh.
struct SurfaceCheck
{
  /// No face is on more than two elements, and each edge of the surface is on two of its faces.
  bool IsConforming = true;
  int Pieces = 0;  ///< number of pieces of the surface, connected over edges
  int Spheres = 0; ///< number of pieces without holes or handles (Euler characteristic 2)
};

/// Checks the surface of a whole mesh. A crack between elements, or a hanging node, gives a further
/// piece or an edge that is not on two faces.
/// @param mesh  hexahedra or tetrahedra, with global ids of their points
SurfaceCheck CheckSurface(const MeshData& mesh);

} // namespace vfm
