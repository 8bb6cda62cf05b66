#include "Elements/Tet/LatticeRules.h"

#include "Elements/Tet/LatticeNear.h"

#include <tuple>

namespace vfm
{
namespace
{

constexpr int Snapped = LatticeNodes::Snapped;

struct Work
{
  const CartesianGrid& Grid;
  const LabelArray& Cells;
  const LatticeNodes& Nodes;
  const int* Vertices = Nodes.Labels(LatticeNodes::Vertex);
  const int* Centres = Nodes.Labels(LatticeNodes::Centre);
};

bool HasLabel(const Work& work, Index vertex, int label)
{
  const std::array<int, 8> star = StarOfNode(work.Grid, work.Cells, vertex);
  return std::find(star.begin(), star.end(), label) != star.end();
}

/// Returns whether the edge between a vertex and the next one across a face number is a bridge.
bool IsBridge(const Work& work, Index vertex, int face)
{
  const Index other = work.Grid.Neighbour(vertex, face);
  const int label = work.Vertices[vertex], otherLabel = work.Vertices[other];
  if (label == Snapped || otherLabel == Snapped)
  {
    return false;
  }
  if (label != otherLabel)
  {
    return !HasLabel(work, vertex, otherLabel) && !HasLabel(work, other, label);
  }
  const std::array<int, 8> star = StarOfNode(work.Grid, work.Cells, vertex);
  bool found = false;
  for (int c = 0; c < 8; ++c)
  {
    found = found || ((c >> (face / 2) & 1) == (face & 1) && star[c] == label);
  }
  return !found;
}

bool IsAtBridge(const Work& work, Index vertex)
{
  bool found = false;
  for (int face = 0; work.Vertices[vertex] != Snapped && face < 6; ++face)
  {
    found = found || IsBridge(work, vertex, face);
  }
  return found;
}

NearNodes Near(const Work& work, Index cell, int label)
{
  return FindNear(work.Nodes, work.Grid, cell, label);
}

/// Returns the nodes that stand for a cell: its centre, or if that is snapped, the nodes around it
/// that have the label of the cell.
/// @param own  nodes that have this label
NearNodes NodesOfCell(const NearNodes& centre, const NearNodes& own)
{
  return IsEmpty(centre & own) ? NeighboursOf(centre) & own : centre;
}

/// Returns any node of a set that has nodes.
NearNodes AnyOf(const NearNodes& set)
{
  const auto lowest = [](std::uint64_t bits) { return bits & (~bits + 1); };
  return set.Centres ? NearNodes{ 0, lowest(set.Centres) } : NearNodes{ lowest(set.Vertices), 0 };
}

/// Returns whether the nodes that stand for a cell are connected, also to those of its neighbours
/// with its label.
bool IsWhole(const Work& work, Index cell)
{
  const int label = work.Cells[cell];
  const NearNodes own = Near(work, cell, label);
  const NearNodes nodes = NodesOfCell(MiddleCentre(), own);
  const NearNodes connected = ConnectedTo(AnyOf(nodes), own);
  bool isWhole = !IsEmpty(nodes) && IsSubset(nodes, connected);
  for (int face = 0; isWhole && face < 6; ++face)
  {
    isWhole = work.Cells[work.Grid.Neighbour(cell, face)] != label ||
      !IsEmpty(NodesOfCell(CentreAcross(face), own) & connected);
  }
  return isWhole;
}

/// A cell and what is near it.
struct Middle
{
  Middle(const Work& work, Index cell) : Cell(cell), Snapped(Near(work, cell, vfm::Snapped))
  {
    const NearNodes own = Near(work, cell, work.Cells[cell]);
    this->Nodes = ConnectedTo(NodesOfCell(MiddleCentre(), own), own);
  }

  Index Cell;
  NearNodes Nodes; // nodes that stand for the cell, and those connected to them
  NearNodes Snapped;
};

/// Returns whether tets near a cell join the connected nodes of the cell to those of the cell
/// across a face.
bool HasContact(const Work& work, const Middle& middle, int face)
{
  const Index across = work.Grid.Neighbour(middle.Cell, face);
  const NearNodes other = Near(work, middle.Cell, work.Cells[across]);
  const NearNodes there = ConnectedTo(NodesOfCell(CentreAcross(face), other), other);
  return !IsEmpty(NeighboursOf(middle.Nodes) & there) ||
    MeetAtTriangle(middle.Nodes, there, middle.Snapped);
}

bool LosesContact(const Work& work, Index cell)
{
  const Middle middle(work, cell);
  bool loses = false;
  for (int face = 0; !loses && face < 6; ++face)
  {
    const Index other = work.Grid.Neighbour(cell, face);
    loses = work.Cells[other] != work.Cells[cell] && !HasContact(work, middle, face) &&
      !(work.Centres[other] == Snapped && HasContact(work, { work, other }, face ^ 1));
  }
  return loses;
}

bool IsBroken(const Work& work, Index cell)
{
  return !IsWhole(work, cell) || LosesContact(work, cell);
}

/// Returns whether the edges of a face of the grid include one between snapped vertices.
/// @param block  linear index of the lowest corner of the face
bool HasSnappedEdge(const Work& work, Index block, int axis)
{
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const auto isSnapped = [&](int corner)
  { return work.Vertices[work.Grid.NodeOfCell(block, corner)] == Snapped; };
  return (isSnapped(0) || isSnapped(u | v)) && (isSnapped(u) || isSnapped(v));
}

/// Returns whether lattice tets at a face of a cell with a snapped centre have four snapped nodes.
bool IsSnappedFace(const Work& work, Index cell, int face)
{
  const Index other = work.Grid.Neighbour(cell, face);
  return work.Centres[other] == Snapped && HasSnappedEdge(work, face & 1 ? other : cell, face / 2);
}

int CountSnappedFaces(const Work& work, Index cell)
{
  int count = 0;
  for (int face = 0; face < 6; ++face)
  {
    count += IsSnappedFace(work, cell, face);
  }
  return count;
}

/// Returns whether a centre is to be settled because of snapped tets: it is before all other
/// centres of these tets. First are those at the most faces with snapped tets, so that few centres
/// are settled, then those with the largest fraction of their own label.
bool GivesWay(const Work& work, Index cell)
{
  const int count = CountSnappedFaces(work, cell);
  bool gives = count > 0;
  for (int face = 0; gives && face < 6; ++face)
  {
    if (IsSnappedFace(work, cell, face))
    {
      const Index other = work.Grid.Neighbour(cell, face);
      const auto rank = [&](Index n, int faces)
      {
        const Index tie = work.Grid.CellKey(work.Grid.Canonical(work.Grid.Position(n)));
        return std::make_tuple(faces, work.Nodes.OwnFraction(n), tie);
      };
      gives = rank(cell, count) > rank(other, CountSnappedFaces(work, other));
    }
  }
  return gives;
}

/// Settles the owned snapped centres for which a condition holds. Returns whether there are any on
/// any rank. Collective.
template <class Condition>
bool SettleCentresWhere(LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition,
  Runtime& runtime, const Condition& condition)
{
  const IndexBox& box = grid.Owned();
  const Work work{ grid, nodes.Cells(), nodes };
  std::vector<std::vector<Index>> rows(box.NumberOfCells() > 0 ? box.Size(1) * box.Size(2) : 0);
  ForRows(runtime, box,
    [&](Index j, Index k, Index row)
    {
      Index3 cell{ { box.Lower[0], j, k } };
      Index n = grid.Linear(cell);
      for (; cell[0] < box.Upper[0]; ++cell[0], ++n)
      {
        if (work.Centres[n] == Snapped && condition(work, n))
        {
          rows[row].push_back(nodes.IdOf({ LatticeNodes::Centre, cell }));
        }
      }
    });
  return nodes.Settle(Joined(rows), partition);
}

} // namespace

void SettleBridges(
  LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition, Runtime& runtime)
{
  const Work work{ grid, nodes.Cells(), nodes };
  const std::vector<Index>& mixed = nodes.MixedVertices();
  std::vector<Index> ids(mixed.size(), 0);
  ForEach(runtime, mixed.size(),
    [&](Index m)
    {
      const Index3 p = grid.Position(mixed[m]);
      if (partition.OwnsNode(p) && IsAtBridge(work, mixed[m]))
      {
        ids[m] = nodes.IdOf({ LatticeNodes::Vertex, p });
      }
    });
  ids.erase(std::remove(ids.begin(), ids.end(), 0), ids.end());
  nodes.Settle(ids, partition);
}

void SettleCentres(
  LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition, Runtime& runtime)
{
  bool changed = true;
  while (changed)
  {
    changed = SettleCentresWhere(nodes, grid, partition, runtime, IsBroken);
    changed = SettleCentresWhere(nodes, grid, partition, runtime, GivesWay) || changed;
  }
}

} // namespace vfm
