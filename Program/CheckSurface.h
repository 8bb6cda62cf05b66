/**
 * CheckSurface: whether the elements of a mesh conform, told by the faces that are on one element alone.
 */
#pragma once

#include "Summary/MeshData.h"

namespace vfm
{

struct SurfaceCheck
{
  bool IsConforming =
    true; ///< no face is on more than two elements, no edge of the surface on other than two of its faces
  int Pieces = 0;  ///< of the surface, connected over edges
  int Spheres = 0; ///< of these, without holes or handles (Euler characteristic 2)
};

/// Of hexahedra or tetrahedra with global ids of their points. A crack between elements, or a node that hangs on a face, is a piece more or an edge of other than two faces.
SurfaceCheck CheckSurface(const MeshData& mesh);

} // namespace vfm
