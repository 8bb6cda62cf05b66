/**
 * GatherGeometry: the surfaces, curves and vertices of all ranks on rank 0.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Facets, edges or points as the elements of a mesh.
struct GeometryPart
{
  std::string Name; ///< Surfaces, Curves or Vertices
  StoredMesh Cells; ///< Corners: 4 or 3, 2, 1
};

/// Gathers the surfaces, curves and vertices on rank 0.
/// Cells are ordered by SurfaceId, CurveId or VertexId, then by their points; points are ordered by
/// GlobalPointIds. Surfaces also have MaterialPair and DomainSide. Fields: ListSurfaces, ListCurves
/// and ListVertices; none of tables of which a rank only has its rows. The result does not depend
/// on the number of ranks.
/// @return parts that have cells, on rank 0; an empty list on other ranks
/// @pre Collective
std::vector<GeometryPart> GatherGeometry(const Mesh& mesh, Ranks& ranks);

} // namespace vfm
