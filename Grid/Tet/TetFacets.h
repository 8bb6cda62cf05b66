/**
 * The faces of a tetrahedral mesh that matter: those on interfaces and on sides of the domain.
 */
#pragma once

#include "Tet/TetTopology.h"

namespace vfm
{

/// A triangle between two materials, or on a side of the domain.
struct TetFacet
{
  std::array<Index, 3> Points; ///< normal out of Inner
  Index Inner;                 ///< the tet of the larger material, or the only one
  Index Outer;                 ///< the tet beyond; -1: none
  int DomainSide;              ///< -1, or 0..5
};

struct TetFaces
{
  std::vector<TetFacet> Facets;
  std::vector<std::array<Index, 2>>
    Joined; ///< tets of one material on both sides of a face whose points may lie on interfaces
};

TetFaces FindTetFaces(const TetTopology& topology, const CartesianGrid& grid);

/// The boundary of some tets of a mesh, normals outward.
std::vector<std::array<Index, 3>> FindBoundary(const Mesh& mesh, const std::vector<Index>& tets);

} // namespace vfm
