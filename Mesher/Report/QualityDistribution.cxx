#include "Report/QualityDistribution.h"

#include "Ranks/Agreement.h"
#include "Report/ElementMoments.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfm
{
namespace
{

constexpr int IntervalsPerUnit = 20;

/// Returns the centroid of an element.
Vector3 FindCentroid(const MeshData& mesh, Index element)
{
  MeshData one;
  one.Corners = mesh.Corners;
  one.NumberOfPoints = mesh.NumberOfPoints;
  one.Points = mesh.Points;
  one.NumberOfElements = 1;
  one.Elements = mesh.Element(element);
  const ElementMoments moments = FindElementMoments(one)[0];
  return (1.0 / moments.Volume) * moments.Moment;
}

/// Returns the worst elements of this rank.
std::vector<RatedElement> FindOwnWorst(
  const MeshData& mesh, const MeshArray& quality, std::size_t count)
{
  std::vector<Index> order(mesh.NumberOfElements);
  std::iota(order.begin(), order.end(), Index{ 0 });
  const auto last = order.begin() + static_cast<Index>(std::min(count, order.size()));
  const auto rank = [&](Index element)
  { return std::pair(ValueAt(quality, element), mesh.ElementIds[element]); };
  std::partial_sort(
    order.begin(), last, order.end(), [&](Index a, Index b) { return rank(a) < rank(b); });
  order.erase(last, order.end());
  std::vector<RatedElement> worst;
  for (Index element : order)
  {
    worst.push_back({ mesh.ElementIds[element], mesh.Material[element], ValueAt(quality, element),
      FindCentroid(mesh, element) });
  }
  return worst;
}

/// Counts the values of this rank in the intervals from -1 to 1.
std::vector<std::int64_t> CountValues(const MeshData& mesh, const MeshArray& quality)
{
  std::vector<std::int64_t> counts(2 * IntervalsPerUnit, 0);
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    const double place = std::floor((ValueAt(quality, element) + 1.0) * IntervalsPerUnit);
    ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, 2.0 * IntervalsPerUnit - 1.0))];
  }
  return counts;
}

/// Returns the intervals of all ranks, without the negative half if it is empty.
Histogram MakeHistogram(std::vector<std::int64_t> counts, Ranks& ranks)
{
  ranks.Sum(counts);
  const auto half = counts.begin() + IntervalsPerUnit;
  const bool isPositive = std::all_of(counts.begin(), half, [](auto count) { return count == 0; });
  return { isPositive ? 0.0 : -1.0, 1.0, { isPositive ? half : counts.begin(), counts.end() } };
}

} // namespace

QualityDistribution FindQualityDistribution(const MeshData& mesh, std::size_t worst, Ranks& ranks)
{
  const MeshArray* quality = FindArray(mesh.ElementArrays, "ScaledJacobian");
  QualityDistribution found;
  if (!ranks.Any(quality && mesh.NumberOfElements > 0))
  {
    return found;
  }
  std::vector<std::int64_t> counts(2 * IntervalsPerUnit, 0);
  WorkTogether(ranks,
    [&]
    {
      Require(mesh.ElementIds, "GlobalCellIds", mesh);
      Require(mesh.Material, "MaterialId", mesh);
      if (mesh.NumberOfElements > 0)
      {
        const MeshArray& values = GetArray(mesh.ElementArrays, "ScaledJacobian");
        counts = CountValues(mesh, values);
        found.Worst = FindOwnWorst(mesh, values, worst);
      }
    });
  found.ScaledJacobian = MakeHistogram(std::move(counts), ranks);
  found.Worst = UnionOverRanks(ranks, std::move(found.Worst), worst);
  return found;
}

} // namespace vfm
