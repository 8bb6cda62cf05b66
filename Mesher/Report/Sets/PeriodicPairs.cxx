#include "Report/Sets/PeriodicPairs.h"

#include "Report/DomainSides.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace vfm
{

Index3 CountPeriods(const Vector3& from, const Vector3& to, const std::vector<double>& lengths)
{
  Index3 periods{ { 0, 0, 0 } };
  for (int a = 0; a < 3; ++a)
  {
    periods[a] = lengths[a] > 0.0 ? std::llround((to[a] - from[a]) / lengths[a]) : 0;
  }
  return periods;
}

std::vector<PeriodicPair> FindPeriodicPairs(const MeshData& mesh)
{
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  std::vector<PeriodicPair> pairs;
  if (!mesh.PeriodicPartner || lengths.size() != 3)
  {
    return pairs;
  }
  std::unordered_map<Index, Index> places; // of partners
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    if (mesh.PeriodicPartner[point] == mesh.PointIds[point])
    {
      places[mesh.PointIds[point]] = point;
    }
  }
  const ImageFrame frame = FrameOfDomain(mesh);
  const auto positionOf = [&](Index point) { return frame.ToOwn(mesh.PointAt(point)); };
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    const Index id = mesh.PeriodicPartner[point];
    if (id == mesh.PointIds[point])
    {
      continue;
    }
    const auto partner = places.find(id);
    if (partner == places.end())
    {
      throw InputError("Point " + std::to_string(id) +
        ", a PeriodicPartner, is not in the mesh: the whole mesh is needed.");
    }
    pairs.push_back({ point, partner->second,
      CountPeriods(positionOf(partner->second), positionOf(point), lengths) });
  }
  return pairs;
}

} // namespace vfm
