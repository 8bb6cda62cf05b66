#include "Elements/PeriodicIds.h"

#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

/// Returns the key of the copy of a lattice node that is some cells of a level lower.
Index KeyBelow(const OctreeKeys& lattice, Index key, const Index3& cells, int level)
{
  const OctreeKeys::LevelIndex node = Below(lattice.NodeOfKey(key), cells, level);
  return lattice.NodeKey(node.Level, node.At, node.Slot);
}

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
  const OctreeKeys& lattice = levels.Lattice();
  if (IsCoarseCentre(levels, id, slots))
  {
    const OctreeKeys::LevelIndex cell =
      Below(CellOfCoarseCentre(levels, id, slots), cells, levels.NumberOfRefinements());
    return CentreId(levels, lattice.HexKey(cell.Level, cell.At, cell.Slot), slots);
  }
  const Index key =
    KeyBelow(lattice, KeyOfPoint(levels, id, slots), cells, levels.NumberOfRefinements());
  return CoarsePointId(levels, key, slots, static_cast<int>((id - 1) % slots));
}

} // namespace

OctreeKeys::LevelIndex Below(OctreeKeys::LevelIndex at, const Index3& cells, int level)
{
  for (int a = 0; a < 3; ++a)
  {
    at.At[a] -= level > at.Level ? cells[a] >> (level - at.Level)
                                 : cells[a] * (Index(1) << (at.Level - level));
  }
  return at;
}

bool HasCopies(const CartesianGrid& grid, const Index3& node)
{
  const Index3 owned = grid.CanonicalNode(node);
  bool hasCopies = node != owned;
  for (int a = 0; a < 3; ++a)
  {
    hasCopies = hasCopies || (grid.Period(a) > 0 && owned[a] == grid.Domain().Upper[a]);
  }
  return hasCopies;
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

MoverCopies CopiesOfMovers(const Mesh& mesh, int halvings)
{
  const double width = mesh.Levels->Finest().MeanWidth();
  const Index factor = Index(1) << halvings;
  return { [&mesh, factor](Index id, const Index3& cells)
    {
      return IdBelow(mesh, id, { { cells[0] * factor, cells[1] * factor, cells[2] * factor } });
    },
    { { width, width, width } } };
}

MoverCopies CopiesOfAnchors(const OctreeKeys& lattice, const Vector3& unit)
{
  return { [&lattice](Index key, const Index3& cells) { return KeyBelow(lattice, key, cells, 0); },
    unit };
}

} // namespace vfm
