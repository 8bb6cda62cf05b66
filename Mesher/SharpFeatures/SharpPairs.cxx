#include "SharpFeatures/SharpPairs.h"

#include "Base/PairSums.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

constexpr double SampleSize = 128.0; // points per pair, at most about this many
// least share of points with a model, for a pair that has edges
constexpr double SmallestShare = 0.45;

/// Returns a hash of the key of a node, which does not depend on its place in a regular way.
Index Shuffle(Index key)
{
  return static_cast<Index>((static_cast<std::uint64_t>(key) * 0x9E3779B97F4A7C15u) >> 32);
}

/// Returns the sums of value(site) per pair of labels, over all ranks.
template <class Value>
std::vector<PairSum> SumByPair(const FeatureSites& all, const SiteList& sites, const Value& value)
{
  PairSumMap sums;
  for (const FeatureSite& site : sites)
  {
    sums[all.PairOf(site)].Add(value(site));
  }
  return GatherPairSums(sums, all.Group());
}

} // namespace

void SharpPairs::Sample(const SiteList& strong)
{
  SiteList first = this->All.ListOwned(strong);
  first.erase(std::remove_if(first.begin(), first.end(),
                [this](const FeatureSite& site) { return !this->All.IsFirst(site); }),
    first.end());
  std::map<LabelPair, Index> stride;
  for (const PairSum& sum : SumByPair(this->All, first, [](const FeatureSite&) { return 1.0; }))
  {
    stride[{ sum.First, sum.Second }] =
      static_cast<Index>(std::ceil(sum.Value.Value() / SampleSize));
  }
  std::copy_if(first.begin(), first.end(), std::back_inserter(this->Sampled),
    [&](const FeatureSite& site)
    { return Shuffle(this->All.KeyOf(site)) % stride.at(this->All.PairOf(site)) == 0; });
}

void SharpPairs::Classify(const FoundFeatures& found)
{
  const auto value = [&found](const FeatureSite& site)
  { return (found[site.Point] ? 1.0 : 0.0) - SmallestShare; };
  for (const PairSum& sum : SumByPair(this->All, this->Sampled, value))
  {
    if (sum.Value.Value() > 0.0)
    {
      this->Sharp.insert({ sum.First, sum.Second });
    }
  }
}

} // namespace vfm
