#include "Elements/Tet/LatticeRules.h"

#include "Elements/Tet/LatticeNear.h"

#include <tuple>

namespace vfm
{
namespace
{

constexpr int Snapped = LatticeNodes::Snapped;

/// Returns whether a cell around a vertex has a label.
bool HasLabel(const CartesianGrid& grid, const LabelArray& cells, Index vertex, int label)
{
  const std::array<int, 8> star = StarOfNode(grid, cells, vertex);
  return std::find(star.begin(), star.end(), label) != star.end();
}

/// Returns whether the edge between a vertex and the next one across a face number is a bridge.
bool IsBridge(const CartesianGrid& grid, const LatticeNodes& nodes, Index vertex, int face)
{
  const Index other = grid.Neighbour(vertex, face);
  const int* vertices = nodes.Labels(LatticeNodes::Vertex);
  const int label = vertices[vertex], otherLabel = vertices[other];
  if (label == Snapped || otherLabel == Snapped)
  {
    return false;
  }
  if (label != otherLabel)
  {
    return !HasLabel(grid, nodes.Cells(), vertex, otherLabel) &&
      !HasLabel(grid, nodes.Cells(), other, label);
  }
  const std::array<int, 8> star = StarOfNode(grid, nodes.Cells(), vertex);
  bool found = false;
  for (int c = 0; c < 8; ++c)
  {
    found = found || ((c >> (face / 2) & 1) == (face & 1) && star[c] == label);
  }
  return !found;
}

bool IsAtBridge(const CartesianGrid& grid, const LatticeNodes& nodes, Index vertex)
{
  bool found = false;
  for (int face = 0; !found && face < 6; ++face)
  {
    found = IsBridge(grid, nodes, vertex, face);
  }
  return found;
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
bool IsWhole(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell)
{
  const LabelArray& cells = nodes.Cells();
  const int label = cells[cell];
  const NearNodes own = FindNear(nodes, grid, cell, label);
  const NearNodes middle = NodesOfCell(MiddleCentre(), own);
  const NearNodes connected = ConnectedTo(AnyOf(middle), own);
  bool isWhole = !IsEmpty(middle) && IsSubset(middle, connected);
  for (int face = 0; isWhole && face < 6; ++face)
  {
    isWhole = cells[grid.Neighbour(cell, face)] != label ||
      !IsEmpty(NodesOfCell(CentreAcross(face), own) & connected);
  }
  return isWhole;
}

/// A cell and what is near it.
struct Middle
{
  Middle(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell) :
    Cell(cell), Snapped(FindNear(nodes, grid, cell, vfm::Snapped))
  {
    const NearNodes own = FindNear(nodes, grid, cell, nodes.Cells()[cell]);
    this->Nodes = ConnectedTo(NodesOfCell(MiddleCentre(), own), own);
  }

  Index Cell;
  NearNodes Nodes; // nodes that stand for the cell, and those connected to them
  NearNodes Snapped;
};

/// Returns whether tets near a cell join the connected nodes of the cell to those of the cell
/// across a face.
bool HasContact(
  const CartesianGrid& grid, const LatticeNodes& nodes, const Middle& middle, int face)
{
  const Index across = grid.Neighbour(middle.Cell, face);
  const NearNodes other = FindNear(nodes, grid, middle.Cell, nodes.Cells()[across]);
  const NearNodes there = ConnectedTo(NodesOfCell(CentreAcross(face), other), other);
  return !IsEmpty(NeighboursOf(middle.Nodes) & there) ||
    MeetAtTriangle(middle.Nodes, there, middle.Snapped);
}

bool LosesContact(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell)
{
  const LabelArray& cells = nodes.Cells();
  const int* centres = nodes.Labels(LatticeNodes::Centre);
  const Middle middle(grid, nodes, cell);
  bool loses = false;
  for (int face = 0; !loses && face < 6; ++face)
  {
    const Index other = grid.Neighbour(cell, face);
    loses = cells[other] != cells[cell] && !HasContact(grid, nodes, middle, face) &&
      !(centres[other] == Snapped && HasContact(grid, nodes, { grid, nodes, other }, face ^ 1));
  }
  return loses;
}

bool IsBroken(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell)
{
  return !IsWhole(grid, nodes, cell) || LosesContact(grid, nodes, cell);
}

/// Returns whether the edges of a face of the grid include one between snapped vertices.
/// @param vertices  labels of the vertices
/// @param block  linear index of the lowest corner of the face
bool HasSnappedEdge(const CartesianGrid& grid, const int* vertices, Index block, int axis)
{
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const auto isSnapped = [&](int corner)
  { return vertices[grid.NodeOfCell(block, corner)] == Snapped; };
  return (isSnapped(0) || isSnapped(u | v)) && (isSnapped(u) || isSnapped(v));
}

/// Returns whether lattice tets at a face of a cell with a snapped centre have four snapped nodes.
bool IsSnappedFace(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell, int face)
{
  const Index other = grid.Neighbour(cell, face);
  return nodes.Labels(LatticeNodes::Centre)[other] == Snapped &&
    HasSnappedEdge(grid, nodes.Labels(LatticeNodes::Vertex), face & 1 ? other : cell, face / 2);
}

int CountSnappedFaces(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell)
{
  int count = 0;
  for (int face = 0; face < 6; ++face)
  {
    count += IsSnappedFace(grid, nodes, cell, face);
  }
  return count;
}

/// Returns whether a centre is to be settled because of snapped tets: it is before all other
/// centres of these tets. First are those at the most faces with snapped tets, so that few centres
/// are settled, then those with the largest fraction of their own label.
bool GivesWay(const CartesianGrid& grid, const LatticeNodes& nodes, Index cell)
{
  const int count = CountSnappedFaces(grid, nodes, cell);
  bool gives = count > 0;
  for (int face = 0; gives && face < 6; ++face)
  {
    if (IsSnappedFace(grid, nodes, cell, face))
    {
      const Index other = grid.Neighbour(cell, face);
      const auto rank = [&](Index n, int faces)
      {
        const Index tie = grid.CellKey(grid.Canonical(grid.Position(n)));
        return std::make_tuple(faces, nodes.OwnFraction(n), tie);
      };
      gives = rank(cell, count) > rank(other, CountSnappedFaces(grid, nodes, other));
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
  const int* centres = nodes.Labels(LatticeNodes::Centre);
  std::vector<std::vector<Index>> rows(box.NumberOfCells() > 0 ? box.Size(1) * box.Size(2) : 0);
  ForRows(runtime, box,
    [&](Index j, Index k, Index row)
    {
      Index3 cell{ { box.Lower[0], j, k } };
      Index n = grid.Linear(cell);
      for (; cell[0] < box.Upper[0]; ++cell[0], ++n)
      {
        if (centres[n] == Snapped && condition(grid, nodes, n))
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
  const std::vector<Index>& mixed = nodes.MixedVertices();
  std::vector<Index> ids(mixed.size(), 0);
  ForEach(runtime, mixed.size(),
    [&](Index m)
    {
      const Index3 p = grid.Position(mixed[m]);
      if (partition.OwnsNode(p) && IsAtBridge(grid, nodes, mixed[m]))
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
