#include "Summary/PointCounts.h"

#include "Ranks/ExchangeAll.h"

#include <algorithm>

namespace vfm
{
namespace
{

struct PartPoint
{
  Index Part, Id;
  bool operator<(const PartPoint& other) const
  {
    return this->Part != other.Part ? this->Part < other.Part : this->Id < other.Id;
  }
  bool operator==(const PartPoint& other) const
  {
    return this->Part == other.Part && this->Id == other.Id;
  }
};

void Tidy(std::vector<PartPoint>& points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

std::vector<PartPoint> FindOwnPoints(const MeshData& mesh, const std::vector<int>& partOf)
{
  std::vector<PartPoint> found;
  for (std::size_t e = 0; e < partOf.size(); ++e)
  {
    const Index* points = mesh.Element(static_cast<Index>(e));
    for (int c = 0; c < mesh.Corners; ++c)
    {
      found.push_back({ partOf[e], mesh.PointIds[points[c]] });
    }
  }
  Tidy(found);
  return found;
}

/// The points whose ids are this rank's to count.
std::vector<PartPoint> DealPoints(const std::vector<PartPoint>& own, Ranks& ranks)
{
  std::vector<std::vector<PartPoint>> shares(ranks.Count());
  for (const PartPoint& point : own)
  {
    shares[point.Id % ranks.Count()].push_back(point);
  }
  auto mine = JoinItems<PartPoint>(ExchangeAll(PackLists(shares), ranks));
  Tidy(mine);
  return mine;
}

} // namespace

std::vector<Index> CountPoints(
  const MeshData& mesh, const std::vector<int>& partOf, std::size_t numberOfParts, Ranks& ranks)
{
  std::vector<std::int64_t> counts(numberOfParts, 0);
  for (const PartPoint& point : DealPoints(FindOwnPoints(mesh, partOf), ranks))
  {
    ++counts[point.Part];
  }
  ranks.Sum(counts);
  return counts;
}

} // namespace vfm
