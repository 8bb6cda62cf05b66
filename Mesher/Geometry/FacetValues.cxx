#include "Geometry/FacetValues.h"

#include "Elements/PeriodicIds.h"

namespace vfm
{
namespace
{

struct KeyedFacet
{
  FacetKey Key;
  int Number;
  bool operator<(const KeyedFacet& other) const { return this->Key < other.Key; }
};

/// Returns the number of a facet in a sorted list, or -1.
int Find(const std::vector<KeyedFacet>& owned, const FacetKey& key)
{
  const auto at = std::lower_bound(owned.begin(), owned.end(), KeyedFacet{ key, 0 });
  return at != owned.end() && at->Key == key ? at->Number : -1;
}

} // namespace

FacetKey KeyOfFacet(const Mesh& mesh, const Facet& facet)
{
  FacetKey key;
  std::transform(facet.Points.begin(), facet.Points.end(), key.begin(),
    [&mesh](Index p) { return IdOfOwner(mesh, mesh.PointIds[p]); });
  std::sort(key.begin(), key.end());
  return key;
}

FacetValues::FacetValues(const std::vector<int>& selected, const std::vector<Facet>& facets,
  const Mesh& mesh, const Partition& partition) :
  Parts(partition), Requested(partition.Peers().size()), ToSend(partition.Peers().size())
{
  std::vector<KeyedFacet> owned;
  std::vector<FacetKey> keys; // of the others
  std::vector<int> others;
  for (int f : selected)
  {
    const FacetKey key = KeyOfFacet(mesh, facets[f]);
    if (facets[f].IsOwned)
    {
      owned.push_back({ key, f });
    }
    else
    {
      keys.push_back(key);
      others.push_back(f);
    }
  }
  std::sort(owned.begin(), owned.end());
  const std::size_t peers = partition.Peers().size();
  const std::vector<std::vector<int>> found =
    MapLists(partition.Exchange(std::vector<std::vector<FacetKey>>(peers, keys)),
      [&owned](const FacetKey& key) { return Find(owned, key); });
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    std::copy_if(found[peer].begin(), found[peer].end(), std::back_inserter(this->ToSend[peer]),
      [](int f) { return f >= 0; });
  }
  const std::vector<std::vector<int>> answers = partition.Exchange(found);
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (std::size_t i = 0; i < answers[peer].size(); ++i)
    {
      if (answers[peer][i] >= 0)
      {
        this->Requested[peer].push_back(others[i]);
      }
    }
  }
}

} // namespace vfm
