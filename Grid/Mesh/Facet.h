/**
 * The faces of a mesh that matter: those on interfaces and on sides of the domain. They are found once, by topology (HexFacets,
 * TetFacets); what needs interfaces of the mesh reads the list: geometry, attachment, volumes.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// A face of elements between two materials, or on a side of the domain. "Behind" and "before" it: where its normal comes from and
/// where it points.
struct Facet
{
  std::array<Index, 4> Points;  ///< of the mesh or its active part; the last twice in triangles
  std::array<int, 2> Materials; ///< behind and before it; 0: void, or beyond the domain
  std::array<int, 2> Fragments; ///< the same; 0: not meshed, or beyond the domain
  int DomainSide;               ///< -1, or 0..5 for -x +x -y +y -z +z
  bool IsOwned;                 ///< one rank writes it and measures with it
};

/// What lies on the two sides of a facet, the smaller first: fragments, 0 not meshed, -1 - side beyond a side of the domain.
inline std::array<int, 2> SurfaceOf(const Facet& facet)
{
  const int before = facet.DomainSide < 0 ? facet.Fragments[1] : -1 - facet.DomainSide;
  return { { std::min(before, facet.Fragments[0]), std::max(before, facet.Fragments[0]) } };
}

} // namespace vfm
