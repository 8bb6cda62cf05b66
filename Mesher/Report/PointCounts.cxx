#include "Report/PointCounts.h"

#include "Base/Sorted.h"
#include "Ranks/AskRanks.h"

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

/// Returns the points whose ids this rank counts.
std::vector<PartPoint> DistributePoints(const std::vector<PartPoint>& own, Ranks& ranks)
{
  const auto rankOf = [&ranks](const PartPoint& point) { return point[1] % ranks.Count(); };
  auto mine = JoinItems<PartPoint>(SendItems(own, rankOf, ranks));
  SortUnique(mine);
  return mine;
}

} // namespace

std::vector<Index> CountPoints(
  const MeshData& mesh, const std::vector<int>& partOf, std::size_t numberOfParts, Ranks& ranks)
{
  std::vector<std::int64_t> counts(numberOfParts, 0);
  for (const PartPoint& point : DistributePoints(FindOwnPoints(mesh, partOf), ranks))
  {
    ++counts[point[0]];
  }
  ranks.Sum(counts);
  return counts;
}

} // namespace vfm
