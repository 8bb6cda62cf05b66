#include "Mesh/PeriodicIds.h"

#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

/// Returns the id of the copy of a point that is some cells of the finest grid lower.
Index IdBelow(const Mesh& mesh, Index id, const Index3& cells)
{
  if (cells == Index3{})
  {
    return id;
  }
  const RefinedGrid& levels = *mesh.Levels;
  const Index slots = mesh.Ids.PointSlots;
  if (!IsCoarsePoint(levels, id, slots))
  {
    return id - slots * levels.Finest().NodeKey(cells);
  }
  const Index key =
    KeyBelow(levels.Lattice(), KeyOfPoint(levels, id, slots), cells, levels.NumberOfRefinements());
  return PointId(levels, key, slots, static_cast<int>((id - 1) % slots));
}

} // namespace

Index KeyBelow(const OctreeKeys& lattice, Index key, const Index3& cells, int level)
{
  OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
  for (int a = 0; a < 3; ++a)
  {
    node.At[a] -= level > node.Level ? cells[a] >> (level - node.Level)
                                     : cells[a] * (Index(1) << (node.Level - level));
  }
  return lattice.NodeKey(node.Level, node.At, node.Slot);
}

Index IdAtPeer(const Mesh& mesh, const Partition& partition, std::size_t peer, Index id)
{
  return IdBelow(mesh, id, partition.ShiftOf(peer));
}

Index IdOfOwner(const Mesh& mesh, Index id)
{
  const CartesianGrid& grid = mesh.Levels->Finest();
  if (!grid.IsPeriodic())
  {
    return id;
  }
  const Index3 node = NodeOfPoint(grid, mesh, id), owned = grid.CanonicalNode(node);
  return IdBelow(mesh, id, { { node[0] - owned[0], node[1] - owned[1], node[2] - owned[2] } });
}

MoverCopies CopiesOfMovers(const Mesh& mesh)
{
  const double width = mesh.Levels->Finest().MeanWidth();
  return { [&mesh](Index id, const Index3& cells) { return IdBelow(mesh, id, cells); },
    { { width, width, width } } };
}

} // namespace vfm
