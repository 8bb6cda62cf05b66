#include "SharpFeatures/FeatureSites.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Model that an owner returns for a requested site.
struct Answer
{
  Index Place; // position of the site in the request
  FittedFeature Found;
};

constexpr std::size_t KeyLength = 3; // key of the node, labels of the pair

} // namespace

FeatureSites::FeatureSites(
  const Interface& interface, const Partition& partition, const PairFilter& isSought) :
  Source(interface), Parts(partition)
{
  const CartesianGrid& grid = interface.Grid();
  const IndexBox nodes = NodesOf(Grow(grid.Owned(), Spread, grid.Global()));
  for (Index n = 0; n < static_cast<Index>(interface.Nodes().size()); ++n)
  {
    if (nodes.Contains(grid.Position(interface.Nodes()[n])))
    {
      for (Index p = interface.PointOffset(n); p < interface.PointOffset(n + 1); ++p)
      {
        const FeatureSite site{ n, p };
        if (!isSought || isSought(this->PairOf(site)))
        {
          this->TheNear.push_back(site);
        }
      }
    }
  }
}

SiteList FeatureSites::ListOwned(const SiteList& sites) const
{
  SiteList owned;
  std::copy_if(sites.begin(), sites.end(), std::back_inserter(owned),
    [this](const FeatureSite& site) { return this->IsOwned(site); });
  return owned;
}

SiteList FeatureSites::ListAround(const FeatureSite& site) const
{
  const CartesianGrid& grid = this->Source.Grid();
  const std::vector<Index>& nodes = this->Source.Nodes();
  const LabelPair pair = this->PairOf(site);
  IndexBox box;
  const Index3 p = this->PositionOf(site);
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] = p[a] - Spread;
    box.Upper[a] = p[a] + Spread + 1;
  }
  box = Intersect(box, NodesOf(grid.Local()));
  SiteList around;
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      auto at = std::lower_bound(nodes.begin(), nodes.end(), first);
      for (; at != nodes.end() && *at < first + box.Size(0); ++at)
      {
        const Index node = at - nodes.begin();
        const SurfacePoint* point = this->Source.FindPoint(node, pair.first, pair.second);
        if (point && this->Parts.OwnsNode(grid.Position(*at)))
        {
          around.push_back({ node, point - this->Source.Points().data() });
        }
      }
    });
  return around;
}

FeatureSite FeatureSites::Find(Index key, const LabelPair& pair) const
{
  const CartesianGrid& grid = this->Source.Grid();
  const Index node = this->Source.Find(grid.Linear(grid.NodeOfKey(key)));
  const SurfacePoint* point =
    node < 0 ? nullptr : this->Source.FindPoint(node, pair.first, pair.second);
  return { node, point ? point - this->Source.Points().data() : -1 };
}

void FeatureSites::Share(FoundFeatures& found) const
{
  const std::size_t peers = this->Parts.Peers().size();
  std::vector<SiteList> sites(peers);
  std::vector<std::vector<Index>> requested(peers);
  for (const FeatureSite& site : this->Near())
  {
    if (!this->IsOwned(site))
    {
      const LabelPair pair = this->PairOf(site);
      const int peer = this->Parts.PeerOfNode(this->PositionOf(site));
      sites[peer].push_back(site);
      requested[peer].insert(requested[peer].end(),
        { this->KeyOf(site) - this->Parts.NodeKeyShift(peer), pair.first, pair.second });
      found[site.Point].reset();
    }
  }
  std::vector<std::vector<Answer>> answers;
  for (const std::vector<Index>& keys : this->Parts.Exchange(requested))
  {
    answers.emplace_back();
    for (std::size_t i = 0; i < keys.size(); i += KeyLength)
    {
      const FeatureSite site =
        this->Find(keys[i], { static_cast<int>(keys[i + 1]), static_cast<int>(keys[i + 2]) });
      if (site.Point >= 0 && found[site.Point])
      {
        answers.back().push_back({ static_cast<Index>(i / KeyLength), *found[site.Point] });
      }
    }
  }
  answers = this->Parts.Exchange(answers);
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (const Answer& answer : answers[peer])
    {
      found[sites[peer][answer.Place].Point] = std::make_unique<const FittedFeature>(answer.Found);
    }
  }
}

} // namespace vfm
