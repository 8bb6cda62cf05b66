#include "Tet/ActiveTets.h"

#include <iterator>

namespace vfm
{
namespace
{

bool HasPoint(const Mesh& mesh, Index tet, const std::vector<unsigned char>& flags)
{
  const Index* points = mesh.Elements.data() + 4 * tet;
  return flags[points[0]] | flags[points[1]] | flags[points[2]] | flags[points[3]];
}

/// Of each point: whether it belongs to a tet with a flagged point.
std::vector<unsigned char> Spread(const Mesh& mesh, const std::vector<unsigned char>& flags)
{
  std::vector<unsigned char> near(flags.size(), 0);
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    if (HasPoint(mesh, static_cast<Index>(t), flags))
    {
      std::for_each(mesh.Elements.data() + 4 * t, mesh.Elements.data() + 4 * t + 4,
        [&](Index p) { near[p] = 1; });
    }
  }
  return near;
}

bool IsOwned(
  const CartesianGrid& grid, const Mesh& mesh, const Partition& partition, std::size_t point)
{
  return partition.OwnsNode(NodeOfPoint(grid, mesh, mesh.PointIds[point]));
}

/// Asks the owners which of the points within two tets of owned moving points move too: at the rim not all
/// tets of a point are here. Collective among peers.
void LearnMoving(const CartesianGrid& grid, const Mesh& mesh, const Partition& partition,
  std::vector<unsigned char>& moving)
{
  if (partition.Peers().empty())
  {
    return;
  }
  std::vector<unsigned char> near = moving;
  for (std::size_t p = 0; p < near.size(); ++p)
  {
    near[p] = near[p] && IsOwned(grid, mesh, partition, p);
  }
  near = Spread(mesh, Spread(mesh, near));
  std::vector<std::vector<Index>> wanted(partition.Peers().size());
  for (std::size_t p = 0; p < near.size(); ++p)
  {
    if (near[p] && !moving[p] && !IsOwned(grid, mesh, partition, p))
    {
      wanted[partition.PeerOfNode(NodeOfPoint(grid, mesh, mesh.PointIds[p]))].push_back(
        mesh.PointIds[p]);
    }
  }
  const Index* ids = mesh.PointIds.data();
  const auto placeOf = [&](Index id)
  { return std::lower_bound(ids, ids + mesh.PointIds.size(), id) - ids; };
  std::vector<std::vector<Index>> found;
  for (const std::vector<Index>& asked : partition.Request(wanted))
  {
    found.emplace_back();
    std::copy_if(asked.begin(), asked.end(), std::back_inserter(found.back()),
      [&](Index id) { return moving[placeOf(id)]; });
  }
  for (const std::vector<Index>& answered : partition.Request(found))
  {
    for (Index id : answered)
    {
      moving[placeOf(id)] = 1;
    }
  }
}

/// One group a block, all its points in order: they may share tets.
void AddGroups(
  const CartesianGrid& grid, const Mesh& mesh, const Partition& partition, ActiveTets& active)
{
  const int count = static_cast<int>(active.X.size());
  const auto blockOf = [&](int p)
  { return (mesh.PointIds[active.MeshPoint[p]] - 1) / mesh.Ids.PointSlots; };
  for (int first = 0, last = 0; first < count; first = last)
  {
    bool moves = false;
    for (last = first; last < count && blockOf(last) == blockOf(first); ++last)
    {
      moves = moves || active.IsActive[last];
    }
    const Index3 node = NodeOfPoint(grid, mesh, mesh.PointIds[active.MeshPoint[first]]);
    if (moves && partition.OwnsNode(node))
    {
      active.Colours[CartesianGrid::Colour(node)].push_back({ first, last });
    }
  }
}

} // namespace

ActiveTets MakeActiveTets(
  const TetTopology& topology, const CartesianGrid& grid, const Partition& partition)
{
  const Mesh& mesh = topology.Tets;
  std::vector<unsigned char> moving(mesh.PointIds.size());
  for (std::size_t p = 0; p < moving.size(); ++p)
  {
    moving[p] = topology.Positions[p] == PointPosition::OnInterface;
  }
  moving = Spread(mesh, moving);
  LearnMoving(grid, mesh, partition, moving);
  const std::vector<unsigned char> used = Spread(mesh, moving);
  ActiveTets active;
  active.Corners = 4;
  active.PointOf.assign(mesh.PointIds.size(), -1);
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    if (used[p])
    {
      active.PointOf[p] = static_cast<int>(active.X.size());
      active.AddPoint(grid, mesh, static_cast<Index>(p), moving[p]);
    }
  }
  const bool uniform = IsUniform(grid);
  active.Widths.assign(uniform, CellWidths(grid, grid.Global().Lower));
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    if (!HasPoint(mesh, static_cast<Index>(t), moving))
    {
      continue;
    }
    active.MeshElement.push_back(static_cast<Index>(t));
    for (int c = 0; c < 4; ++c)
    {
      active.Elements.push_back(active.PointOf[mesh.Elements[4 * t + c]]);
    }
    if (!uniform)
    {
      active.Widths.push_back(CellWidths(grid, CellOfElement(grid, mesh, mesh.ElementIds[t])));
    }
  }
  active.FixOnDomain(grid, mesh);
  AddGroups(grid, mesh, partition, active);
  active.ListCorners();
  return active;
}

} // namespace vfm
