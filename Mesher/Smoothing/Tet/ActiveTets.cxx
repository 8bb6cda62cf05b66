#include "Smoothing/Tet/ActiveTets.h"

#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Elements/Tet/LeafNodes.h"
#include "Elements/Tet/TetTopology.h"
#include "Octree/LevelIds.h"
#include "Smoothing/ActiveMeshBuilder.h"

namespace vfm
{
namespace
{

/// Returns whether a tet has a flagged point.
bool HasPoint(const Mesh& mesh, Index tet, const std::vector<unsigned char>& flags)
{
  const Index* points = mesh.Elements.data() + 4 * tet;
  return flags[points[0]] | flags[points[1]] | flags[points[2]] | flags[points[3]];
}

/// Returns flags of the points of all tets that have a flagged point.
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

/// Returns whether a point stays in place because it is in tets of larger cells: points of these
/// cells, and corners of finest cells that may share such a tet with a point of their colour.
bool IsFixed(const Mesh& mesh, Index id)
{
  const RefinedGrid& levels = *mesh.Levels;
  if (!levels.HasFineInterfaces())
  {
    return false;
  }
  if (levels.IsUniform() || IsCoarsePoint(levels, id, mesh.Ids.PointSlots))
  {
    return !levels.IsUniform();
  }
  const Index3 node = NodeOfPoint(levels.Finest(), mesh, id);
  return SlotOfPoint(id) == VertexSlot && !levels.IsFineAround(node) &&
    IsNearDistantVertex(levels, node);
}

/// Receives from the owners which ghost points move, among those within two tets of owned moving
/// points. At the rim, this rank lacks some tets of a point and
/// cannot decide. Collective among peers.
void ReceiveMoving(const CartesianGrid& grid, const Mesh& mesh, const Partition& partition,
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
  std::vector<std::vector<Index>> requested(partition.Peers().size()), ids(requested.size());
  for (std::size_t p = 0; p < near.size(); ++p)
  {
    if (near[p] && !moving[p] && !IsFixed(mesh, mesh.PointIds[p]) &&
      !IsOwned(grid, mesh, partition, p))
    {
      const int peer = partition.PeerOfNode(NodeOfPoint(grid, mesh, mesh.PointIds[p]));
      requested[peer].push_back(static_cast<Index>(p));
      ids[peer].push_back(IdAtPeer(mesh, partition, peer, mesh.PointIds[p]));
    }
  }
  const auto answers =
    partition.Query(ids, [&](Index id) { return moving[FindSorted(mesh.PointIds, id)]; });
  for (std::size_t peer = 0; peer < requested.size(); ++peer)
  {
    for (std::size_t i = 0; i < requested[peer].size(); ++i)
    {
      moving[requested[peer][i]] = answers[peer][i];
    }
  }
}

/// Returns a mover. If interfaces cross levels, its colour is one of its level: a vertex has the
/// level of its coarsest cells and moves with the centre below which it is. A tet has points of
/// different nodes of one level only at neighbouring nodes.
Mover MoverOf(const Mesh& mesh, const CartesianGrid& grid, Index point)
{
  const Index id = mesh.PointIds[point], slots = mesh.Ids.PointSlots;
  const Index3 node = NodeOfPoint(grid, mesh, id);
  const RefinedGrid& levels = *mesh.Levels;
  if (levels.HasFineInterfaces())
  {
    return { point, id, (id - 1) / slots, node, grid.Colour(node) };
  }
  OctreeKeys::LevelIndex at{ levels.NumberOfRefinements(), node, 0 };
  if (IsCoarsePoint(levels, id, slots) && IsCoarseCentre(levels, id, slots))
  {
    at = CellOfCoarseCentre(levels, id, slots);
    at.At = CornerOfCell(at.At, 7);
  }
  else if (SlotOfPoint(id) == VertexSlot)
  {
    at = levels.Lattice().NodeOfKey(KeyOfPoint(levels, id, slots));
  }
  return { point, id, levels.Lattice().NodeKey(at.Level, at.At, 0), node,
    8 * at.Level + CartesianGrid::Parities(at.At) };
}

/// Returns the points that may lie on interfaces, and all points of the tets around them, except
/// fixed ones. Points of one block may share tets, so they move one after another.
std::vector<Mover> FindMovers(const Mesh& mesh, const std::vector<PointPosition>& positions,
  const CartesianGrid& grid, const Partition& partition)
{
  std::vector<unsigned char> moving(mesh.PointIds.size());
  for (std::size_t p = 0; p < moving.size(); ++p)
  {
    moving[p] = positions[p] == PointPosition::OnInterface;
  }
  moving = Spread(mesh, moving);
  for (std::size_t p = 0; p < moving.size(); ++p)
  {
    moving[p] = moving[p] && !IsFixed(mesh, mesh.PointIds[p]);
  }
  ReceiveMoving(grid, mesh, partition, moving);
  std::vector<Mover> movers;
  for (std::size_t p = 0; p < moving.size(); ++p)
  {
    if (moving[p])
    {
      movers.push_back(MoverOf(mesh, grid, static_cast<Index>(p)));
    }
  }
  return movers;
}

} // namespace

ActiveMesh MakeActiveTets(const Mesh& mesh, const std::vector<PointPosition>& positions,
  const BarrierElements& barrier, const std::vector<unsigned char>& isThin,
  const CartesianGrid& grid, const Partition& partition, Runtime& runtime)
{
  ActiveMeshBuilder builder(4, mesh.PointIds.size(), FindMovers(mesh, positions, grid, partition));
  std::vector<Index> tets = builder.AddAround(mesh, runtime);
  const RefinedGrid& levels = *mesh.Levels;
  const int numberOfLevels = levels.HasFineInterfaces() ? 1 : levels.NumberOfRefinements() + 1;
  ActiveMesh active =
    builder.Finish(partition, CopiesOfMovers(mesh), grid.NumberOfColours() * numberOfLevels);
  active.MeshElement = std::move(tets);
  active.Widths = levels.HasFineInterfaces() ? WidthsOfCells(grid, mesh, active.MeshElement)
                                             : WidthsOfLeaves(levels, mesh, active.MeshElement);
  active.SetBarrier(mesh, barrier, active.MeshElement);
  active.SetYielding(mesh, isThin, active.MeshElement);
  active.PlacePoints(grid, mesh);
  return active;
}

} // namespace vfm
