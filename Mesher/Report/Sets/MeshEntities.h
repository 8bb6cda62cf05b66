/**
 * MeshEntities: the volumes, surfaces, curves and vertices of a whole mesh, from its facets.
 *
 * The definitions are those of ClassifyGeometry (Grid), which a mesh from a file no longer has. The
 * numbers of surfaces, curves and vertices are equal to SurfaceId, CurveId and VertexId of the
 * mesher if the mesh is complete and not periodic: sides of periodic meshes are surfaces here only.
 * Copies of a point at split interfaces count as one point.
 */
#pragma once

#include "Report/Sets/MeshSets.h"

namespace vfm
{

/// Faces between two volumes, or between a volume and a side of the domain or nothing.
struct SurfaceEntity
{
  std::array<int, 2> Volumes;     ///< volume of the elements in Sides, and behind; 0: nothing
  std::array<int, 2> Materials;   ///< their materials; 0: void or nothing
  int DomainSide;                 ///< 0..5 for -x +x -y +y -z +z, or NoSide
  int SmoothSide;                 ///< MeshFacet::Surface
  bool IsInterface;               ///< whether elements are on both sides
  std::vector<ElementSide> Sides; ///< each face once, ascending
};

/// Edges of faces where the same surfaces meet.
struct CurveEntity
{
  std::vector<int> Surfaces;               ///< from 1, ascending
  std::vector<int> Vertices;               ///< ends, from 1, ascending; empty if it is closed
  std::vector<std::array<Index, 2>> Edges; ///< points of the mesh
};

struct MeshEntities
{
  std::vector<int> Volumes;            ///< volume of each element: its fragment, from 1
  std::vector<SurfaceEntity> Surfaces; ///< surfaces 1, 2, ...
  std::vector<CurveEntity> Curves;     ///< curves 1, 2, ...
  std::vector<Index> Vertices;         ///< points of vertices 1, 2, ...
  /// Lowest-dimensional entity with each point: 3 volume to 0 vertex, and its number.
  std::vector<int> PointDimension, PointEntity;
};

/// Finds the entities of a whole mesh. Without the array FragmentId, volumes are materials, and the
/// void gets FindVoidId().
/// @param mesh  mesh of one rank, with Facets and Material
MeshEntities FindMeshEntities(const MeshData& mesh);

} // namespace vfm
