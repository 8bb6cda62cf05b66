/**
 * SharpPairs: the pairs of labels whose interfaces have edges, told by a sample of the points where one surface does not explain the fractions.
 *
 * Solids with edges have models at more than half of these points; drops and waves, bodies that touch, thin films and noise at two fifths or
 * fewer.
 */
#pragma once

#include "SharpFeatures/FeatureSites.h"

#include <map>
#include <set>

namespace vfm
{

class SharpPairs
{
public:
  /// No pair has edges, as far as is known.
  explicit SharpPairs(const FeatureSites& all) : All(all) {}

  /// strong: the points where one surface does not do, owned ones and others. Collective.
  void Sample(const SiteList& strong);
  /// The owned points of the sample.
  const SiteList& Chosen() const { return this->Sampled; }
  /// By what was found at the points of the sample. Collective.
  void Classify(const FoundFeatures& found);

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
