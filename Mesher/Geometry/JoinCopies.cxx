#include "Geometry/JoinCopies.h"

#include "Elements/SelectPoints.h"
#include "Octree/LevelIds.h"
#include "Ranks/MergeByKey.h"

#include <numeric>

namespace vfm
{
namespace
{

/// A copy of a point: its id before joining and its position.
struct Copy
{
  Index Id;
  Vector3 Place;
};

Copy LowestOf(const Copy& a, const Copy& b)
{
  return a.Id < b.Id ? a : b;
}

/// Returns whether a point may have copies: not a corner of hexes whose node is inside the domain.
/// Points of tets can have the node of a cell next to the side. Points that TetGen or layers added
/// have no node.
bool MayHaveCopies(const Mesh& mesh, Index point)
{
  const Index id = mesh.PointIds[point];
  const CartesianGrid& domain = mesh.Levels->Finest();
  return mesh.Corners != 8 || mesh.PeriodicPartner[point] != id ||
    id >= EndOfPointIds(*mesh.Levels, mesh.Ids.PointSlots) ||
    domain.DomainSides(NodeOfPoint(domain, mesh, id)) != 0;
}

/// The points of this rank that may have copies, by their ids after joining, and for each one the
/// copy of all ranks with the lowest id.
struct JoinedPoints
{
  std::vector<Index> Ids; // ascending
  std::vector<Copy> Lowest;
};

/// Collective.
JoinedPoints FindLowestCopies(const Mesh& mesh, Ranks& ranks)
{
  std::vector<Index> ids;
  std::vector<Copy> copies;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const auto point = static_cast<Index>(p);
    if (MayHaveCopies(mesh, point))
    {
      ids.push_back(mesh.PeriodicPartner[p]);
      copies.push_back({ mesh.PointIds[p], mesh.PointAt(point) });
    }
  }
  copies = MergeByKey(ids, copies, LowestOf, ranks);
  JoinedPoints joined;
  for (std::size_t place : OrderOf(ids))
  {
    joined.Ids.push_back(ids[place]);
    joined.Lowest.push_back(copies[place]);
  }
  return joined;
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
  const JoinedPoints joined = FindLowestCopies(mesh, runtime.Group());
  mesh.PointIds = std::move(mesh.PeriodicPartner);
  std::vector<Index> numbers;
  const std::vector<Index> kept = OrderPoints(mesh.PointIds, numbers);
  SelectPoints(kept, numbers, runtime, mesh);
  for (std::size_t p = 0; p < kept.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    const auto found = std::lower_bound(joined.Ids.begin(), joined.Ids.end(), id);
    if (found != joined.Ids.end() && *found == id)
    {
      const Copy& lowest = joined.Lowest[found - joined.Ids.begin()];
      mesh.SetPoint(static_cast<Index>(p), lowest.Place, id);
    }
  }
  SortGeometry(mesh);
  return kept;
}

} // namespace vfm
