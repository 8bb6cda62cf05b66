#include "Report/PointCounts.h"

#include "Base/Sorted.h"
#include "Ranks/KeyMerge.h"

#include <algorithm>

namespace vfm
{
namespace
{

using PartPoint = std::array<Index, 2>; // part and global id

std::vector<PartPoint> FindOwnPoints(const MeshData& mesh, const std::vector<int>& partOf)
{
  std::vector<PartPoint> found;
  for (std::size_t e = 0; e < partOf.size(); ++e)
  {
    const Index* points = mesh.Element(static_cast<Index>(e));
    for (int c = 0; c < mesh.Corners; ++c)
    {
      found.push_back({ { partOf[e], mesh.PointIds[points[c]] } });
    }
  }
  SortUnique(found);
  return found;
}

} // namespace

std::vector<Index> CountPoints(
  const MeshData& mesh, const std::vector<int>& partOf, std::size_t numberOfParts, Ranks& ranks)
{
  std::vector<std::int64_t> counts(numberOfParts, 0);
  // A point of several ranks is counted at its home.
  const KeyMerge<PartPoint> ways(FindOwnPoints(mesh, partOf), ranks);
  for (const PartPoint& point : ways.HomeKeys())
  {
    ++counts[point[0]];
  }
  ranks.Sum(counts);
  return counts;
}

PointsOfFragments CountFragmentPoints(const MeshData& mesh, Ranks& ranks)
{
  const std::vector<int> partOf(mesh.Fragment, mesh.Fragment + mesh.NumberOfElements);
  const KeyMerge<PartPoint> ways(FindOwnPoints(mesh, partOf), ranks);
  PointsOfFragments found;
  for (const PartPoint& point : ways.HomeKeys())
  {
    if (found.Fragments.empty() || found.Fragments.back() != point[0])
    {
      found.Fragments.push_back(static_cast<int>(point[0]));
      found.Counts.push_back(0);
    }
    ++found.Counts.back();
  }
  return found;
}

} // namespace vfm
