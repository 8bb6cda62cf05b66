#include "Elements/Tet/LatticeFaults.h"

#include "Base/DisjointSets.h"
#include "Elements/Tet/NonManifoldNodes.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

struct Work
{
  const Mesh& Tets;
  const LatticeNodes& Nodes;
  const CartesianGrid& Grid;
  const Partition& Parts;
  std::vector<Index> ToSettle{};
};

/// Lattice tet of the finest grid: number `Tet` at the face of the grid across `Axis` whose lowest
/// corner is `Block`.
struct Place
{
  Index3 Block;
  int Axis, Tet;
};

Place PlaceOf(const Work& work, Index tet)
{
  const Index id = work.Tets.ElementIds[tet] - 1;
  const int slot = static_cast<int>(id % TetIds.ElementSlots / PiecesPerTet);
  return { work.Grid.NodeOfKey(id / TetIds.ElementSlots), slot / 4, slot % 4 };
}

bool IsOwned(const Work& work, Index tet)
{
  const Index id = work.Tets.ElementIds[tet];
  return work.Parts.OwnsCell(CellOfElement(work.Grid, work.Tets, id)) &&
    !IsCoarseTet(*work.Tets.Levels, id, TetIds.ElementSlots);
}

/// Returns whether the face of a tet is on the domain boundary or a flat seam: the tet belongs to
/// one cell.
bool IsHalf(const Work& work, const Place& place)
{
  const Index at = place.Block[place.Axis];
  return at == 0 || at == work.Grid.Global().Upper[place.Axis] ||
    work.Grid.IsOnFlatSeam(place.Block, place.Axis);
}

/// Returns the cells around the corners of the face of a tet.
IndexBox CellsAroundFace(const Work& work, const Place& place)
{
  const Index3& b = place.Block;
  IndexBox cells{ { { b[0] - 1, b[1] - 1, b[2] - 1 } }, { { b[0] + 2, b[1] + 2, b[2] + 2 } } };
  --cells.Upper[place.Axis];
  return Intersect(cells, work.Grid.Global());
}

/// Returns the cells around the ends of the edge of a tet that lies on the grid. A half has the
/// whole face instead.
IndexBox CellsAroundEdge(const Work& work, const Place& place)
{
  IndexBox cells = CellsAroundFace(work, place);
  if (IsHalf(work, place))
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
bool Meet(const Work& work, const IndexBox& box, int a, int b)
{
  const LabelArray& cells = work.Nodes.Cells();
  bool found = false;
  ForCells(box,
    [&](const Index3& p)
    {
      const Index n = work.Grid.Linear(p);
      const int label = cells[n];
      for (int axis = 0; !found && (label == a || label == b) && axis < 3; ++axis)
      {
        found = p[axis] + 1 < box.Upper[axis] &&
          cells[n + work.Grid.Stride(axis)] == (label == a ? b : a);
      }
    });
  return found;
}

/// Returns whether the cells of a label in a box are connected by faces.
bool AreConnected(const Work& work, const IndexBox& box, int label)
{
  const LabelArray& cells = work.Nodes.Cells();
  std::vector<Index> parent = MakeSets(box.NumberOfCells());
  std::vector<Index> own; // indices in the box
  ForCells(box,
    [&](const Index3& p)
    {
      if (cells[work.Grid.Linear(p)] != label)
      {
        return;
      }
      own.push_back(IndexInBox(box, p));
      for (int axis = 0; axis < 3; ++axis)
      {
        Index3 before = p;
        --before[axis];
        if (box.Contains(before) && cells[work.Grid.Linear(before)] == label)
        {
          Join(parent, own.back(), IndexInBox(box, before));
        }
      }
    });
  return std::all_of(own.begin(), own.end(),
    [&](Index cell) { return FindRoot(parent, cell) == FindRoot(parent, own[0]); });
}

void Settle(Work& work, LatticeNodes::Kind kind, const Index3& position)
{
  work.ToSettle.push_back(work.Nodes.IdOf({ kind, position }));
}

/// Settles the snapped centres of a box. Returns whether there are any.
bool SettleCentres(Work& work, const IndexBox& box)
{
  bool found = false;
  ForCells(box,
    [&](const Index3& cell)
    {
      if (work.Nodes.Labels(LatticeNodes::Centre)[work.Grid.Linear(cell)] == LatticeNodes::Snapped)
      {
        Settle(work, LatticeNodes::Centre, cell);
        found = true;
      }
    });
  return found;
}

void CheckFacet(Work& work, const TetFace& facet)
{
  const int label = work.Tets.Material[facet.Inner];
  const int other = facet.Outer < 0 ? 0 : work.Tets.Material[facet.Outer];
  const Place place = PlaceOf(work, facet.Inner);
  const IndexBox around = CellsAroundEdge(work, place);
  if (Meet(work, around, label, other) || SettleCentres(work, around))
  {
    return;
  }
  for (int c = 0; c < 4; ++c)
  {
    Index3 p = place.Block;
    p[(place.Axis + 1) % 3] += c & 1;
    p[(place.Axis + 2) % 3] += c >> 1;
    Settle(work, LatticeNodes::Vertex, p);
  }
}

void CheckJoint(Work& work, const std::array<Index, 2>& tets)
{
  const Place place = PlaceOf(work, tets[0]), other = PlaceOf(work, tets[1]);
  if (place.Block != other.Block || place.Axis != other.Axis || IsHalf(work, place))
  {
    return;
  }
  const LabelArray& cells = work.Nodes.Cells();
  const int label = work.Tets.Material[tets[0]];
  const Index above = work.Grid.Linear(place.Block);
  IndexBox pair = BoxOfCell(place.Block);
  --pair.Lower[place.Axis];
  if (cells[above] != label && cells[above - work.Grid.Stride(place.Axis)] != label &&
    !AreConnected(work, CellsAroundFace(work, place), label))
  {
    SettleCentres(work, pair);
  }
}

/// Settles a non-manifold node. At a mixed vertex, this ends nothing: all nodes around are settled.
void SettleNonManifold(Work& work, Index id)
{
  work.ToSettle.push_back(id);
  const Index3 p = NodeOfPoint(work.Grid, work.Tets, id);
  const Index n = work.Grid.Linear(p);
  if (SlotOfPoint(id) == CentreSlot || !IsMixedStar(StarOfNode(work.Grid, work.Nodes.Cells(), n)))
  {
    return;
  }
  const IndexBox cells = Intersect({ CellOfStar(p, 0), CornerOfCell(p, 7) }, work.Grid.Global());
  ForCells(cells, [&](const Index3& cell) { Settle(work, LatticeNodes::Centre, cell); });
  ForCells(NodesOf(cells), [&](const Index3& v) { Settle(work, LatticeNodes::Vertex, v); });
}

} // namespace

std::vector<Index> FindLatticeFaults(const TetTopology& topology, const TetFaces& faces,
  const LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition)
{
  Work work{ topology.Tets, nodes, grid, partition };
  for (const TetFace& face : faces.Faces)
  {
    if (face.DomainSide < 0 && IsOwned(work, face.Inner))
    {
      CheckFacet(work, face);
    }
  }
  for (const std::array<Index, 2>& pair : faces.Joined)
  {
    if (IsOwned(work, pair[0]) && IsOwned(work, pair[1]))
    {
      CheckJoint(work, pair);
    }
  }
  for (Index id : FindNonManifoldNodes(topology, faces, grid, partition))
  {
    SettleNonManifold(work, id);
  }
  return std::move(work.ToSettle);
}

} // namespace vfm
