/**
 * MeshFacet: a face of an element on an interface of materials or at the end of the mesh.
 */
#pragma once

#include "Base/IndexBox.h"

namespace vfm
{

constexpr int NothingBehind = -1;

/// GeometryDimension of points on a surface, and inside a volume.
constexpr int DimensionOfSurfaces = 2, DimensionOfVolumes = 3;

struct MeshFacet
{
  Index Element;  ///< of this rank, from 0
  int Side;       ///< of the element, as vtkHexahedron and vtkTetra number their faces, from 0
  int Behind;     ///< material of the element on the other side, on any rank, or NothingBehind
  int Surface;    ///< smooth side of the interface, from 1 over all ranks; 0 where it has only one
  int DomainSide; ///< -1, or 0..5 for -x +x -y +y -z +z
};

} // namespace vfm
