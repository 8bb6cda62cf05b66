#include "Smoothing/Attach.h"

#include "Base/Groups.h"

namespace vfm
{
namespace
{

/// A pair of labels that meets at a point, the smaller first, and the fragments there.
struct Pair
{
  std::array<int, 2> Labels, Fragments;
  bool operator<(const Pair& other) const
  {
    return this->Labels != other.Labels ? this->Labels < other.Labels
                                        : this->Fragments < other.Fragments;
  }
};

Pair PairOf(const Facet& facet)
{
  Pair pair{ facet.Materials, facet.Fragments };
  if (pair.Labels[0] > pair.Labels[1])
  {
    std::swap(pair.Labels[0], pair.Labels[1]);
    std::swap(pair.Fragments[0], pair.Fragments[1]);
  }
  return pair;
}

/// Calls visit(point) for the points of a facet of an interface that move.
template <class Visitor>
void ForMoving(const Facet& facet, const ActiveMesh& active, const Visitor& visit)
{
  const std::size_t corners = facet.Points[2] == facet.Points[3] ? 3 : 4;
  for (std::size_t c = 0; facet.DomainSide < 0 && c < corners; ++c)
  {
    const int point = active.PointOf[facet.Points[c]];
    if (point >= 0 && active.IsActive[point])
    {
      visit(point);
    }
  }
}

/// The facets at each point that moves.
Groups<int> FindFacetsAt(const std::vector<Facet>& facets, const ActiveMesh& active)
{
  return MakeGroups<int>(active.X.size(),
    [&](const auto& visit)
    {
      for (std::size_t f = 0; f < facets.size(); ++f)
      {
        ForMoving(facets[f], active, [&](int point) { visit(point, static_cast<int>(f)); });
      }
    });
}

/// The distinct pairs of labels of some facets, ascending, each with its smallest fragments.
void FindPairs(
  const std::vector<Facet>& facets, const int* begin, const int* end, std::vector<Pair>& pairs)
{
  pairs.clear();
  std::for_each(begin, end, [&](int facet) { pairs.push_back(PairOf(facets[facet])); });
  std::sort(pairs.begin(), pairs.end());
  const auto alike = [](const Pair& a, const Pair& b) { return a.Labels == b.Labels; };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), alike), pairs.end());
}

} // namespace

void AttachToFacets(
  const std::vector<Facet>& facets, const FindTarget& findTarget, ActiveMesh& active)
{
  const Groups<int> at = FindFacetsAt(facets, active);
  std::vector<Pair> pairs;
  active.AttachmentOffset.assign(1, 0);
  for (int point = 0; point < static_cast<int>(active.X.size()); ++point)
  {
    FindPairs(
      facets, at.Items.data() + at.Begin[point], at.Items.data() + at.Begin[point + 1], pairs);
    for (const Pair& pair : pairs)
    {
      const Index target = findTarget(point, pair.Labels);
      if (target >= 0)
      {
        active.Attachments.push_back({ target, pair.Fragments });
      }
    }
    active.AttachmentOffset.push_back(static_cast<Index>(active.Attachments.size()));
  }
}

void SetFacets(const std::vector<Facet>& facets, ActiveMesh& active)
{
  active.Facets.clear();
  for (const Facet& facet : facets)
  {
    if (facet.DomainSide >= 0 || !facet.IsOwned)
    {
      continue;
    }
    InterfaceFacet measured{ {}, facet.Fragments };
    std::transform(facet.Points.begin(), facet.Points.end(), measured.Points.begin(),
      [&](Index point) { return active.PointOf[point]; });
    active.Facets.push_back(measured);
  }
}

} // namespace vfm
