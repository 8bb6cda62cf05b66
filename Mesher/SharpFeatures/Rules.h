/**
 * Rules: selects the points of a mesh that carry the edges and corners of its interfaces. Each rule
 * reads the facets (quads or triangles) of one pair of labels and acts on all points at once, so
 * the order of points does not matter. After each rule, every rank sends the result at its own
 * points to the other ranks.
 *
 * - Corner: of the points within three facets of a corner, the nearest carries it.
 * - Cover: if a mesh edge joins points on different sides, the point nearer to its interface edge
 *   becomes a carrier. No mesh edge then joins two sides, and the chain of carriers has no gaps. In
 *   tets, a side point next to a carrier becomes a carrier too unless they share a side.
 * - Zigzag, in hexes: if exactly two opposite points of a quad are carriers, the nearer of the
 *   other two becomes a carrier, unless a quad would then have four. Interface edges then run along
 *   mesh edges instead of across quads.
 * - Chains: carriers in a connected chain of fewer than nine are dropped. Adjacent carriers are
 *   connected if the angles between their surfaces are about equal.
 * - Sides: side points without a carrier within three facets are dropped.
 */
#pragma once

#include "Base/Vector3.h"
#include "Elements/Facet.h"
#include "Elements/FeatureKind.h"
#include "Elements/PointExchange.h"

namespace vfm
{

/// Surface points of a mesh of hexes or tets, and the pairs of labels that meet at each. Only
/// surface points of the mesh have an index here.
struct SurfacePairs
{
  bool IsOfHexes;
  const std::vector<Vector3>& Places;       ///< position of each point, grid coordinates
  const std::vector<std::uint32_t>& Offset; ///< the pairs of point p are [Offset[p], Offset[p + 1])
  const std::vector<int>& PointOf;          ///< index here of each point of the mesh, or -1
  const PointExchange& Exchange;            ///< sends values of points to the ranks that share them
  std::vector<Index> Ids;                   ///< id of each point, equal on all ranks
  std::vector<unsigned char> IsOwned;       ///< whether this rank moves each point
  std::vector<Index> Target;                ///< of the surface point of each pair
  /// Labels of each pair, the smaller first; -1 on levels without features.
  std::vector<std::array<int, 2>> Labels;
};

/// Place of a point and a pair of labels relative to the model there. Distances are in cells.
/// Distances from an acute edge and its corners are multiplied by their bluntness: cells next to it
/// are less than half full of the label, so its interface starts farther away.
struct FeaturePoint
{
  FeatureKind Kind = FeatureKind::None;
  Vector3 Normal{}; ///< unit normal of the side
  /// The model is a thin gap or film, which is kept without an edge nearby.
  bool IsSheet = false;
  double EdgeDistance = 1e30; ///< distance to the nearest edge; 1e30: there is no edge
  /// Unit normals of the surfaces that meet at that edge.
  std::array<Vector3, 2> EdgeNormals{};
  Vector3 Corner{};             ///< grid coordinates
  double CornerDistance = 1e30; ///< distance to the corner; 1e30: there is no corner
};

/// Applies the rules to the kinds of all pairs.
/// @param pairs  points of the surfaces and their pairs of labels
/// @param facets  surface facets of this rank; facets on the domain boundary are skipped
/// @param[in,out] points  one per pair, set by the rank that moves the point; other
///   ranks receive its values
/// @pre Collective among peers.
void ApplyFeatureRules(
  const SurfacePairs& pairs, const std::vector<Facet>& facets, std::vector<FeaturePoint>& points);

} // namespace vfm
