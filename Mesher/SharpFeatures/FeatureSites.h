/**
 * FeatureSites: surface points for which a rank needs models: points at its own nodes, and nearby
 * points whose models are tried there.
 */
#pragma once

#include "Base/Partition.h"
#include "SharpFeatures/FeatureSearch.h"

#include <memory>

namespace vfm
{

using LabelPair = std::pair<int, int>;
/// Returns whether a pair is selected; empty: all are.
using PairFilter = std::function<bool(const LabelPair&)>;

/// A surface point and its node, as positions in Interface::Points() and Nodes().
struct FeatureSite
{
  Index Node, Point;
  bool operator<(const FeatureSite& other) const { return this->Point < other.Point; }
  bool operator==(const FeatureSite& other) const { return this->Point == other.Point; }
};
using SiteList = std::vector<FeatureSite>; // ascending

/// Model of each surface point, or nullptr.
using FoundFeatures = std::vector<std::unique_ptr<const FittedFeature>>;

/// Surface points near the owned nodes of a rank. Keeps references to the
/// interface and the partition.
class FeatureSites
{
public:
  /// Largest distance, in nodes along each axis, between a point and another where
  /// its model is tried.
  static constexpr Index Spread = 2;

  /// @param isSought  pairs that have sites
  FeatureSites(
    const Interface& interface, const Partition& partition, const PairFilter& isSought = {});

  Ranks& Group() const { return this->Parts.Group(); }

  Index3 PositionOf(const FeatureSite& site) const
  {
    return this->Source.Grid().Position(this->Source.Nodes()[site.Node]);
  }
  /// Returns the key of the node, equal on all ranks.
  Index KeyOf(const FeatureSite& site) const
  {
    return this->Source.Grid().NodeKey(this->PositionOf(site));
  }
  LabelPair PairOf(const FeatureSite& site) const
  {
    const SurfacePoint& point = this->Source.Points()[site.Point];
    return { point.First, point.Second };
  }
  bool IsOwned(const FeatureSite& site) const
  {
    return this->Parts.OwnsNode(this->PositionOf(site));
  }
  /// Returns whether the node is on one of every three diagonal planes; those
  /// points are searched first.
  bool IsFirst(const FeatureSite& site) const
  {
    const Index3 p = this->PositionOf(site);
    return (p[0] + p[1] + p[2]) % 3 == 0;
  }

  /// Returns all sites at owned nodes and within Spread of them.
  const SiteList& Near() const { return this->TheNear; }
  /// Returns the owned sites of a list.
  SiteList ListOwned(const SiteList& sites) const;
  /// Returns the owned sites of the same pair within Spread of a site.
  SiteList ListAround(const FeatureSite& site) const;
  /// Returns the site of a pair at the node with a key; its Point is -1 if there is no such site.
  FeatureSite Find(Index key, const LabelPair& pair) const;

  /// Replaces the models at sites of other ranks by the models that their owners have found.
  /// @pre Collective among peers.
  void Share(FoundFeatures& found) const;

private:
  const Interface& Source;
  const Partition& Parts;
  SiteList TheNear;
};

} // namespace vfm
