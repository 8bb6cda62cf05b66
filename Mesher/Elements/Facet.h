/**
 * Facet: a face of a mesh on an interface or on a side of the domain. HexFacets and TetFacets list
 * the facets once by topology; geometry, attachment and volumes use the list.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Face of elements between two materials or on a side of the domain. The normal points from the
/// element behind the facet to the element before it.
struct Facet
{
  /// Points of the mesh or of its active part. Triangles repeat the last one.
  std::array<Index, 4> Points;
  std::array<int, 2> Materials; ///< material behind and before; 0: void or outside the domain
  std::array<int, 2> Fragments; ///< fragment behind and before; 0: not meshed or outside the domain
  int DomainSide;               ///< -1, or 0..5 for -x +x -y +y -z +z
  bool IsOwned;                 ///< true on the one rank that writes and measures the facet
};

/// Returns the number of corners of a facet. Triangles repeat the last point.
template <class Point>
int CornersOf(const std::array<Point, 4>& points)
{
  return points[2] == points[3] ? 3 : 4;
}

/// Returns the two sides of a facet, the smaller first: a fragment, 0 if not meshed, or
/// -1 - DomainSide outside the domain.
inline std::array<int, 2> SurfaceOf(const Facet& facet)
{
  const int before = facet.DomainSide < 0 ? facet.Fragments[1] : -1 - facet.DomainSide;
  return { { std::min(before, facet.Fragments[0]), std::max(before, facet.Fragments[0]) } };
}

} // namespace vfm
