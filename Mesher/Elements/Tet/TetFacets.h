/**
 * TetFacets: finds the faces of a tetrahedral mesh on interfaces and on the domain boundary.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Facet.h"
#include "Elements/Tet/TetTopology.h"

namespace vfm
{

/// Triangle between two materials, or on the domain boundary, and its tets.
struct TetFace
{
  std::array<Index, 3> Points; ///< points, with the normal out of Inner
  Index Inner;                 ///< tet of the larger material, or the only tet
  Index Outer;                 ///< tet on the other side, or -1
  int DomainSide;              ///< -1, or 0..5 for -x +x -y +y -z +z
};

struct TetFaces
{
  std::vector<TetFace> Faces;
  /// Pairs of tets of one material that share a face whose points may all be on interfaces.
  std::vector<std::array<Index, 2>> Joined;
};

/// Finds the faces of all tets of this rank.
/// @param positions  TetTopology::Positions
/// @return faces ordered by their points
TetFaces FindTetFaces(const Mesh& mesh, const std::vector<PointPosition>& positions,
  const BarrierElements& barrier, const CartesianGrid& grid);

/// Converts faces to facets.
/// @param mesh  mesh of the faces, with fragments
/// @return one facet per face, in the same order
std::vector<Facet> ListFacets(
  const TetFaces& faces, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh);

/// Joins the two triangles of each quad of a Cells mesh. Those of larger cells stay triangles.
/// @param facets  ListFacets of the faces
/// @return quads, ordered by their face of the grid
std::vector<Facet> JoinTriangles(
  const std::vector<Facet>& facets, const TetFaces& faces, const Mesh& mesh);

/// Returns the boundary of some tets of a mesh as triangles with outward normals.
std::vector<std::array<Index, 3>> FindBoundary(const Mesh& mesh, const std::vector<Index>& tets);

} // namespace vfm
