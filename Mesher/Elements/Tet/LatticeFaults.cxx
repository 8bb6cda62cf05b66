#include "Elements/Tet/LatticeFaults.h"

#include "Base/DisjointSets.h"
#include "Elements/Tet/NonManifoldNodes.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

using Ids = std::vector<Index>; // of lattice nodes (LatticeNodes::IdOf)

/// Lattice tet of the finest grid: number `Tet` at the face of the grid across `Axis` whose lowest
/// corner is `Block`.
struct Place
{
  Index3 Block;
  int Axis, Tet;
};

Place PlaceOf(const CartesianGrid& grid, const Mesh& tets, Index tet)
{
  const Index id = tets.ElementIds[tet] - 1;
  const int slot = static_cast<int>(id % TetIds.ElementSlots / PiecesPerTet);
  return { grid.NodeOfKey(id / TetIds.ElementSlots), slot / 4, slot % 4 };
}

bool IsOwned(const CartesianGrid& grid, const Partition& partition, const Mesh& tets, Index tet)
{
  const Index id = tets.ElementIds[tet];
  return partition.OwnsCell(CellOfElement(grid, tets, id)) &&
    !IsCoarseTet(*tets.Levels, id, TetIds.ElementSlots);
}

/// Returns whether the face of a tet is on the domain boundary or a flat seam: the tet belongs to
/// one cell.
bool IsHalf(const CartesianGrid& grid, const Place& place)
{
  const Index at = place.Block[place.Axis];
  return at == 0 || at == grid.Global().Upper[place.Axis] ||
    grid.IsOnFlatSeam(place.Block, place.Axis);
}

/// Returns the cells around the corners of the face of a tet.
IndexBox CellsAroundFace(const CartesianGrid& grid, const Place& place)
{
  const Index3& b = place.Block;
  IndexBox cells{ { { b[0] - 1, b[1] - 1, b[2] - 1 } }, { { b[0] + 2, b[1] + 2, b[2] + 2 } } };
  --cells.Upper[place.Axis];
  return Intersect(cells, grid.Global());
}

/// Returns the cells around the ends of the edge of a tet that lies on the grid. A half has the
/// whole face instead.
IndexBox CellsAroundEdge(const CartesianGrid& grid, const Place& place)
{
  IndexBox cells = CellsAroundFace(grid, place);
  if (IsHalf(grid, place))
  {
    return cells;
  }
  // Edges t = 0..3 of a face are on its lower v, upper u, upper v and lower u side.
  const int u = (place.Axis + 1) % 3, v = (place.Axis + 2) % 3;
  const int across = place.Tet % 2 == 0 ? v : u;
  const Index at = place.Block[across] + (place.Tet == 1 || place.Tet == 2);
  cells.Lower[across] = std::max(cells.Lower[across], at - 1);
  cells.Upper[across] = std::min(cells.Upper[across], at + 1);
  return cells;
}

/// Returns whether cells of two labels share a face in a box.
bool Meet(const CartesianGrid& grid, const LabelArray& cells, const IndexBox& box, int a, int b)
{
  bool found = false;
  ForCells(box,
    [&](const Index3& p)
    {
      const Index n = grid.Linear(p);
      const int label = cells[n];
      for (int axis = 0; !found && (label == a || label == b) && axis < 3; ++axis)
      {
        found =
          p[axis] + 1 < box.Upper[axis] && cells[n + grid.Stride(axis)] == (label == a ? b : a);
      }
    });
  return found;
}

/// Returns whether the cells of a label in a box are connected by faces.
bool AreConnected(
  const CartesianGrid& grid, const LabelArray& cells, const IndexBox& box, int label)
{
  std::vector<Index> parent = MakeSets(box.NumberOfCells());
  std::vector<Index> own; // indices in the box
  ForCells(box,
    [&](const Index3& p)
    {
      if (cells[grid.Linear(p)] != label)
      {
        return;
      }
      own.push_back(IndexInBox(box, p));
      for (int axis = 0; axis < 3; ++axis)
      {
        Index3 before = p;
        --before[axis];
        if (box.Contains(before) && cells[grid.Linear(before)] == label)
        {
          Join(parent, own.back(), IndexInBox(box, before));
        }
      }
    });
  return std::all_of(own.begin(), own.end(),
    [&](Index cell) { return FindRoot(parent, cell) == FindRoot(parent, own[0]); });
}

void AddNode(const LatticeNodes& nodes, LatticeNodes::Kind kind, const Index3& position, Ids& ids)
{
  ids.push_back(nodes.IdOf({ kind, position }));
}

/// Lists the snapped centres of a box. Returns whether there are any.
bool ListCentres(
  const CartesianGrid& grid, const LatticeNodes& nodes, const IndexBox& box, Ids& ids)
{
  bool found = false;
  ForCells(box,
    [&](const Index3& cell)
    {
      if (nodes.Labels(LatticeNodes::Centre)[grid.Linear(cell)] == LatticeNodes::Snapped)
      {
        AddNode(nodes, LatticeNodes::Centre, cell, ids);
        found = true;
      }
    });
  return found;
}

/// Lists the nodes to settle at a facet whose labels do not meet in the cells around it.
void CheckFacet(const CartesianGrid& grid, const LatticeNodes& nodes, const Mesh& tets,
  const TetFace& facet, Ids& ids)
{
  const int label = tets.Material[facet.Inner];
  const int other = facet.Outer < 0 ? 0 : tets.Material[facet.Outer];
  const Place place = PlaceOf(grid, tets, facet.Inner);
  const IndexBox around = CellsAroundEdge(grid, place);
  if (Meet(grid, nodes.Cells(), around, label, other) || ListCentres(grid, nodes, around, ids))
  {
    return;
  }
  for (int c = 0; c < 4; ++c)
  {
    Index3 p = place.Block;
    p[(place.Axis + 1) % 3] += c & 1;
    p[(place.Axis + 2) % 3] += c >> 1;
    AddNode(nodes, LatticeNodes::Vertex, p, ids);
  }
}

/// Lists the snapped centres beside a face over which two tets of one label are joined, if its
/// cells have other labels and the cells of the label around it are not connected.
void CheckJoint(const CartesianGrid& grid, const LatticeNodes& nodes, const Mesh& tets,
  const std::array<Index, 2>& pair, Ids& ids)
{
  const Place place = PlaceOf(grid, tets, pair[0]), other = PlaceOf(grid, tets, pair[1]);
  if (place.Block != other.Block || place.Axis != other.Axis || IsHalf(grid, place))
  {
    return;
  }
  const LabelArray& cells = nodes.Cells();
  const int label = tets.Material[pair[0]];
  const Index above = grid.Linear(place.Block);
  IndexBox both = BoxOfCell(place.Block);
  --both.Lower[place.Axis];
  if (cells[above] != label && cells[above - grid.Stride(place.Axis)] != label &&
    !AreConnected(grid, cells, CellsAroundFace(grid, place), label))
  {
    ListCentres(grid, nodes, both, ids);
  }
}

/// Lists a non-manifold node. At a mixed vertex, settling it ends nothing: all nodes around are
/// listed.
void CheckNonManifold(
  const CartesianGrid& grid, const LatticeNodes& nodes, const Mesh& tets, Index id, Ids& ids)
{
  ids.push_back(id);
  const Index3 p = NodeOfPoint(grid, tets, id);
  const Index n = grid.Linear(p);
  if (SlotOfPoint(id) == CentreSlot || !IsMixedStar(StarOfNode(grid, nodes.Cells(), n)))
  {
    return;
  }
  const IndexBox cells = Intersect({ CellOfStar(p, 0), CornerOfCell(p, 7) }, grid.Global());
  ForCells(cells, [&](const Index3& cell) { AddNode(nodes, LatticeNodes::Centre, cell, ids); });
  ForCells(NodesOf(cells), [&](const Index3& v) { AddNode(nodes, LatticeNodes::Vertex, v, ids); });
}

} // namespace

std::vector<Index> FindLatticeFaults(const TetTopology& topology, const TetFaces& faces,
  const LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition)
{
  Ids ids;
  for (const TetFace& face : faces.Faces)
  {
    if (face.DomainSide < 0 && IsOwned(grid, partition, topology.Tets, face.Inner))
    {
      CheckFacet(grid, nodes, topology.Tets, face, ids);
    }
  }
  for (const std::array<Index, 2>& pair : faces.Joined)
  {
    if (IsOwned(grid, partition, topology.Tets, pair[0]) &&
      IsOwned(grid, partition, topology.Tets, pair[1]))
    {
      CheckJoint(grid, nodes, topology.Tets, pair, ids);
    }
  }
  for (Index id : FindNonManifoldNodes(topology, faces, grid, partition))
  {
    CheckNonManifold(grid, nodes, topology.Tets, id, ids);
  }
  return ids;
}

} // namespace vfm
