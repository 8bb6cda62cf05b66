/**
 * The faces of a tetrahedral mesh that matter: those on interfaces and on sides of the domain.
 */
#pragma once

#include "Base/Partition.h"
#include "Mesh/Facet.h"
#include "Tet/TetTopology.h"

namespace vfm
{

/// A triangle between two materials, or on a side of the domain, and its tets.
struct TetFace
{
  std::array<Index, 3> Points; ///< normal out of Inner
  Index Inner;                 ///< the tet of the larger material, or the only one
  Index Outer;                 ///< the tet beyond; -1: none
  int DomainSide;              ///< -1, or 0..5
};

struct TetFaces
{
  std::vector<TetFace> Faces;
  std::vector<std::array<Index, 2>>
    Joined; ///< tets of one material on both sides of a face whose points may lie on interfaces
};

TetFaces FindTetFaces(const TetTopology& topology, const CartesianGrid& grid);

/// What the faces are once the tets have fragments.
std::vector<Facet> ListFacets(
  const TetFaces& faces, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh);

/// Facets of Cells, the two triangles of each quad joined.
std::vector<Facet> JoinTriangles(
  const std::vector<Facet>& facets, const TetFaces& faces, const Mesh& mesh);

/// The boundary of some tets of a mesh, normals outward.
std::vector<std::array<Index, 3>> FindBoundary(const Mesh& mesh, const std::vector<Index>& tets);

} // namespace vfm
