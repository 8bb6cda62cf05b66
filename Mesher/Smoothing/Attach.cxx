#include "Smoothing/Attach.h"

#include "Base/Groups.h"

#include <numeric>

namespace vfm
{
namespace
{

constexpr Index PointsOfBlock = 1024; // points per task

/// Pair of labels that meet at a point, the smaller first, and their fragments there.
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

/// Calls visit(point) for the active points of a facet, if it is on an interface.
template <class Visitor>
void ForMoving(const Facet& facet, const ActiveMesh& active, const Visitor& visit)
{
  const int corners = CornersOf(facet.Points);
  for (int c = 0; facet.DomainSide < 0 && c < corners; ++c)
  {
    const int point = active.PointOf[facet.Points[c]];
    if (point >= 0 && active.IsActive[point])
    {
      visit(point);
    }
  }
}

/// Returns the facets at each active point.
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

/// Finds the distinct pairs of labels of some facets, ascending, each with its smallest fragments.
void FindPairs(
  const std::vector<Facet>& facets, const int* begin, const int* end, std::vector<Pair>& pairs)
{
  pairs.clear();
  std::for_each(begin, end, [&](int facet) { pairs.push_back(PairOf(facets[facet])); });
  std::sort(pairs.begin(), pairs.end());
  const auto haveSameLabels = [](const Pair& a, const Pair& b) { return a.Labels == b.Labels; };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), haveSameLabels), pairs.end());
}

} // namespace

void AttachToFacets(const std::vector<Facet>& facets, const FindTarget& findTarget,
  Runtime& runtime, ActiveMesh& active)
{
  const Groups<int> at = FindFacetsAt(facets, active);
  const Index points = static_cast<Index>(active.X.size());
  std::vector<std::vector<Attachment>> found((points + PointsOfBlock - 1) / PointsOfBlock);
  active.AttachmentOffset.assign(points + 1, 0);
  ForEach(runtime, found.size(),
    [&](Index block)
    {
      std::vector<Pair> pairs;
      const Index first = block * PointsOfBlock;
      for (Index point = first; point < std::min(points, first + PointsOfBlock); ++point)
      {
        FindPairs(
          facets, at.Items.data() + at.Begin[point], at.Items.data() + at.Begin[point + 1], pairs);
        for (const Pair& pair : pairs)
        {
          const Index target = findTarget(static_cast<int>(point), pair.Labels);
          if (target >= 0)
          {
            found[block].push_back({ static_cast<int>(target), pair.Fragments });
            ++active.AttachmentOffset[point + 1];
          }
        }
      }
    });
  std::partial_sum(active.AttachmentOffset.begin(), active.AttachmentOffset.end(),
    active.AttachmentOffset.begin());
  active.Attachments = Joined(found);
}

/// Stores facets between the same fragments in sequence, so that Measure needs few sums.
void SetFacets(const std::vector<Facet>& facets, Runtime& runtime, ActiveMesh& active)
{
  std::vector<int> measured;
  int most = 0;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    if (facets[f].DomainSide < 0 && facets[f].IsOwned)
    {
      measured.push_back(static_cast<int>(f));
      most = std::max(most, facets[f].Fragments[0]);
    }
  }
  Groups<int> ordered = MakeGroups<int>(most + 1,
    [&](const auto& visit)
    {
      std::for_each(
        measured.begin(), measured.end(), [&](int f) { visit(facets[f].Fragments[0], f); });
    });
  for (int fragment = 0; fragment <= most; ++fragment)
  {
    const auto begin = ordered.Items.begin() + ordered.Begin[fragment];
    const auto end = ordered.Items.begin() + ordered.Begin[fragment + 1];
    const auto isLess = [&](int a, int b)
    { return facets[a].Fragments[1] < facets[b].Fragments[1]; };
    if (!std::is_sorted(begin, end, isLess)) // most fragments have few neighbours
    {
      std::stable_sort(begin, end, isLess);
    }
  }
  active.Facets.resize(ordered.Items.size());
  ForEach(runtime, ordered.Items.size(),
    [&](Index f)
    {
      const Facet& facet = facets[ordered.Items[f]];
      active.Facets[f].Fragments = facet.Fragments;
      std::transform(facet.Points.begin(), facet.Points.end(), active.Facets[f].Points.begin(),
        [&](Index point) { return active.PointOf[point]; });
    });
}

} // namespace vfm
