/**
 * GatherGeometry: the surfaces, curves and vertices of all ranks on rank 0.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// Facets, edges or points as the elements of a mesh.
struct GeometryPart
{
  std::string Name; ///< Surfaces, Curves or Vertices
  StoredMesh Cells; ///< Corners: 4 or 3, 2, 1
};

/// Collective. Returns on rank 0 the parts that have cells. Cells are in the order of their SurfaceId, CurveId or VertexId, then of their
/// points; points have GlobalPointIds and are in their order: the same from any number of ranks. Surfaces also have MaterialPair and
/// DomainSide. The fields are those of ListSurfaces, ListCurves and ListVertices.
std::vector<GeometryPart> GatherGeometry(const Mesh& mesh, Ranks& ranks);

} // namespace vfm
