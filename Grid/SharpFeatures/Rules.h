/**
 * Rules: which points of a mesh carry the edges and corners of its interfaces. All rules look at the facets of one pair of labels, quads or
 * triangles, and at all points at once, so that no order matters; after each a rank tells the others what has become of the points it owns.
 *
 * - Corner: of the points within three facets, the nearest to it.
 * - Cover: of two points on different sides that a mesh edge joins, the one nearer to its edge becomes a carrier. So no mesh edge
 *   joins two sides, and the chain of carriers has no gaps. In tets so does, then, a point on a side that is none of those of a carrier beside it.
 * - Zigzag, in hexes: of a quad that has carriers on one diagonal alone, the nearer of the others becomes one too, unless a quad would then have four: edges of
 *   interfaces run along mesh edges rather than across quads.
 * - Chains: carriers in pieces of fewer than nine, each beside the next with about the same angle between its surfaces, are none.
 * - Sides without a carrier within three facets are none.
 */
#pragma once

#include "Base/Vector3.h"
#include "Mesh/Facet.h"
#include "Mesh/FeatureKind.h"
#include "Mesh/PointExchange.h"

namespace vfm
{

/// The surface points of a mesh of hexes or tets, and the pairs of labels that meet at each. Points of the whole mesh have an index here, or none.
struct SurfacePairs
{
  bool IsOfHexes;
  const std::vector<Vector3>& Places; ///< of each point, grid coordinates
  const std::vector<Index>& Offset;   ///< of each point: its pairs are [Offset[p], Offset[p + 1])
  const std::vector<int>& PointOf;    ///< of each point of the mesh: its index here, or -1
  const PointExchange& Exchange;      ///< of the points
  std::vector<Index> Ids;             ///< of each point, the same on all ranks
  std::vector<unsigned char> IsOwned; ///< of each point: this rank moves it
  std::vector<Index> SurfacePoint;    ///< of each pair: position in Interface::Points(), or -1
  std::vector<std::array<int, 2>>
    Labels; ///< of each pair, the smaller first; -1 where SurfacePoint is
};

/// What is known of a point and a pair of labels from the model there. Distances in cells, from acute edges and their corners less: times their bluntness, because cells
/// beside these have less than half of the label, so its interface starts farther away.
struct FeaturePoint
{
  FeatureKind Kind = FeatureKind::None;
  Vector3 Normal{};                     ///< of the side
  bool IsSheet = false;                 ///< a thin gap or film: it needs no edge near
  double EdgeDistance = 1e30;           ///< of the nearest edge
  std::array<Vector3, 2> EdgeNormals{}; ///< of the surfaces that meet there
  Vector3 Corner{};                     ///< grid coordinates
  double CornerDistance = 1e30;         ///< such: there is none
};

/// Changes the kinds of the points of some pairs; those at points of other ranks are taken from these. Collective among peers.
void ApplyFeatureRules(
  const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<FeaturePoint>& points);

} // namespace vfm
