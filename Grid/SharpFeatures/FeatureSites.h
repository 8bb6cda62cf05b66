/**
 * FeatureSites: the surface points that a rank finds models of: those of its nodes, and others near, whose models are tried there.
 */
#pragma once

#include "Base/Partition.h"
#include "SharpFeatures/FeatureSearch.h"

#include <memory>

namespace vfm
{

using LabelPair = std::pair<int, int>;

/// A surface point and its node, as positions in the interface.
struct FeatureSite
{
  Index Node, Point;
  bool operator<(const FeatureSite& other) const { return this->Point < other.Point; }
  bool operator==(const FeatureSite& other) const { return this->Point == other.Point; }
};
using SiteList = std::vector<FeatureSite>; // ascending

/// Models by surface point; nullptr: none.
using FoundFeatures = std::vector<std::unique_ptr<const FittedFeature>>;

class FeatureSites
{
public:
  /// Nodes along each axis between a point and one where its model is tried.
  static constexpr Index Spread = 2;

  FeatureSites(const Interface& interface, const Partition& partition);

  Ranks& Group() const { return this->Parts.Group(); }

  Index3 PositionOf(const FeatureSite& site) const
  {
    return this->Source.Grid().Position(this->Source.Nodes()[site.Node]);
  }
  /// The same on all ranks.
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
  /// One diagonal of nodes in three: those are searched first.
  bool IsFirst(const FeatureSite& site) const
  {
    const Index3 p = this->PositionOf(site);
    return (p[0] + p[1] + p[2]) % 3 == 0;
  }

  /// All at owned nodes and within Spread of these.
  const SiteList& Near() const { return this->TheNear; }
  /// The owned ones among sites.
  SiteList ListOwned(const SiteList& sites) const;
  /// The owned ones of the same pair within Spread of a site.
  SiteList ListAround(const FeatureSite& site) const;
  /// The site of a pair at the node of a key; Point -1: none.
  FeatureSite Find(Index key, const LabelPair& pair) const;

  /// Replaces the models near the owned ones by those that the other ranks have found there. Collective among peers.
  void Share(FoundFeatures& found) const;

private:
  const Interface& Source;
  const Partition& Parts;
  SiteList TheNear;
};

} // namespace vfm
