#include "Geometry/JoinCopies.h"

#include "Elements/SelectPoints.h"
#include "Ranks/Agreement.h"

#include <numeric>
#include <tuple>

namespace vfm
{
namespace
{

struct Copy
{
  Index Joined, Id; // id after joining, and id of the copy
  Vector3 Place;
  bool operator<(const Copy& other) const
  {
    return std::tie(this->Joined, this->Id) < std::tie(other.Joined, other.Id);
  }
  bool operator==(const Copy& other) const
  {
    return this->Joined == other.Joined && this->Id == other.Id;
  }
};

/// Collective. Returns the copies of all ranks of points whose id changes, and of the points that
/// have this id before, ascending.
std::vector<Copy> GatherCopies(const Mesh& mesh, Ranks& ranks)
{
  std::vector<Index> joined;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    if (mesh.PeriodicPartner[p] != mesh.PointIds[p])
    {
      joined.push_back(mesh.PeriodicPartner[p]);
    }
  }
  joined = UnionOverRanks(ranks, std::move(joined));
  std::vector<Copy> copies;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Index id = mesh.PeriodicPartner[p];
    if (std::binary_search(joined.begin(), joined.end(), id))
    {
      copies.push_back({ id, mesh.PointIds[p], mesh.PointAt(static_cast<Index>(p)) });
    }
  }
  return UnionOverRanks(ranks, std::move(copies));
}

/// Returns the points with the lowest number of each id, ascending by id, and numbers[p], the
/// position in this list of the point that replaces point p.
std::vector<Index> OrderPoints(const Buffer<Index>& ids, std::vector<Index>& numbers)
{
  std::vector<Index> order(ids.size()), kept;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&ids](Index a, Index b) { return ids[a] < ids[b]; });
  numbers.resize(ids.size());
  for (Index point : order)
  {
    if (kept.empty() || ids[kept.back()] != ids[point])
    {
      kept.push_back(point);
    }
    numbers[point] = static_cast<Index>(kept.size()) - 1;
  }
  return kept;
}

} // namespace

std::vector<Index> JoinCopies(Runtime& runtime, Mesh& mesh)
{
  const std::vector<Copy> copies = GatherCopies(mesh, runtime.Group());
  mesh.PointIds = std::move(mesh.PeriodicPartner);
  std::vector<Index> numbers;
  const std::vector<Index> kept = OrderPoints(mesh.PointIds, numbers);
  SelectPoints(kept, numbers, runtime, mesh);
  for (std::size_t p = 0; p < kept.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    const auto lowest = std::partition_point(
      copies.begin(), copies.end(), [id](const Copy& copy) { return copy.Joined < id; });
    if (lowest != copies.end() && lowest->Joined == id)
    {
      mesh.SetPoint(static_cast<Index>(p), lowest->Place, id);
    }
  }
  SortGeometry(mesh);
  return kept;
}

} // namespace vfm
