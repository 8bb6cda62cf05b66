/**
 * SharpPairs: finds the pairs of labels whose interfaces have edges, from a sample of the points
 * where one surface does not explain the fractions.
 *
 * Solids with edges have models at more than half of these points. Drops, waves, bodies that touch,
 * thin films and noise have models at two fifths or fewer.
 */
#pragma once

#include "SharpFeatures/FeatureSites.h"

#include <map>
#include <set>

namespace vfm
{

/// Pairs of labels with edges, equal on all ranks.
class SharpPairs
{
public:
  /// Starts without pairs; all: the sites of the interface, must outlive this object.
  explicit SharpPairs(const FeatureSites& all) : All(all) {}

  /// Selects the sample.
  /// @param strong  points where one surface does not suffice, owned and nearby
  /// @pre Collective.
  void Sample(const SiteList& strong);
  /// Returns the owned points of the sample.
  const SiteList& Chosen() const { return this->Sampled; }
  /// Adds the pairs with models at enough points of the sample.
  /// @param found  models by surface point
  /// @pre Collective.
  void Classify(const FoundFeatures& found);

  /// Returns whether the pair of a site has edges.
  bool Contains(const FeatureSite& site) const
  {
    return this->Sharp.count(this->All.PairOf(site)) > 0;
  }

private:
  const FeatureSites& All;
  SiteList Sampled;
  std::set<LabelPair> Sharp;
};

} // namespace vfm
