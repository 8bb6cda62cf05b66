#include "Tet/LatticeRules.h"

#include "Base/DisjointSets.h"

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

/// The 14 nodes around a centre: vertices, then centres of neighbours.
struct Link
{
  std::array<bool, 14> HasLabel; ///< whether the node has the label of the cell in the middle
  std::array<bool, 14> IsCell;   ///< whether it is the centre of a cell with this label
  std::array<bool, 14> IsSnapped;
};

Link LinkOf(const Work& work, Index cell)
{
  Link link{};
  const int label = work.Cells[cell];
  for (int c = 0; c < 8; ++c)
  {
    const int own = work.Vertices[work.Grid.NodeOfCell(cell, c)];
    link.HasLabel[c] = own == label;
    link.IsSnapped[c] = own == Snapped;
  }
  for (int face = 0; face < 6; ++face)
  {
    const Index neighbour = work.Grid.Neighbour(cell, face);
    link.IsCell[8 + face] = work.Cells[neighbour] == label;
    link.HasLabel[8 + face] = work.Centres[neighbour] == label;
    link.IsSnapped[8 + face] = work.Centres[neighbour] == Snapped;
  }
  return link;
}

/// Calls body(v, w) for each of the 12 edges of the cell.
template <class Body>
void ForCubeEdges(const Body& body)
{
  for (int v = 0; v < 8; ++v)
  {
    for (int bit = 1; bit < 8; bit *= 2)
    {
      if (!(v & bit))
      {
        body(v, v | bit);
      }
    }
  }
}

/// Returns the node of a link across the face of a cell that is on the side of a vertex.
int NodeBeyond(int vertex, int axis)
{
  return 8 + 2 * axis + (vertex >> axis & 1);
}

/// Calls body(i, j) for each of the 36 edges of a link. The first node is a vertex.
template <class Body>
void ForEdges(const Body& body)
{
  ForCubeEdges(body);
  for (int v = 0; v < 8; ++v)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      body(v, NodeBeyond(v, axis));
    }
  }
}

/// Calls body(i, j, p, q) for each edge i, j of a link and the other nodes p, q of its two
/// triangles.
template <class Body>
void ForTrianglePairs(const Body& body)
{
  ForCubeEdges(
    [&](int v, int w)
    {
      const int axis = (v ^ w) >> 1; // along the edge
      body(v, w, NodeBeyond(v, (axis + 1) % 3), NodeBeyond(v, (axis + 2) % 3));
    });
  for (int v = 0; v < 8; ++v)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      body(v, NodeBeyond(v, axis), v ^ 1 << (axis + 1) % 3, v ^ 1 << (axis + 2) % 3);
    }
  }
}

/// Returns whether the nodes of a link that have the label are connected, and a node with the label
/// is next to every cell with the label.
bool IsWhole(const Link& link)
{
  std::vector<Index> parent = MakeSets(14);
  std::array<bool, 14> isReached = link.HasLabel;
  ForEdges(
    [&](int a, int b)
    {
      if (link.HasLabel[a] && link.HasLabel[b])
      {
        Join(parent, a, b);
      }
      isReached[b] = isReached[b] || link.HasLabel[a];
    });
  Index root = -1;
  bool isWhole = true;
  for (int i = 0; i < 14; ++i)
  {
    if (link.HasLabel[i])
    {
      root = root < 0 ? FindRoot(parent, i) : root;
      isWhole = isWhole && FindRoot(parent, i) == root;
    }
    isWhole = isWhole && (!link.IsCell[i] || isReached[i]);
  }
  return isWhole && root >= 0;
}

/// Returns the nodes of a link at a face that have the label of the cell beyond the face.
std::array<bool, 14> NodesOfNeighbour(const Work& work, Index cell, int face)
{
  std::array<bool, 14> isOther{};
  const Index other = work.Grid.Neighbour(cell, face);
  const int label = work.Cells[other];
  isOther[8 + face] = work.Centres[other] == label;
  for (int v = 0; v < 8; ++v)
  {
    isOther[v] =
      NodeBeyond(v, face / 2) == 8 + face && work.Vertices[work.Grid.NodeOfCell(cell, v)] == label;
  }
  return isOther;
}

/// Returns whether tets around a snapped centre join the label of its cell to the cell beyond a
/// face.
bool HasContact(const Work& work, Index cell, int face)
{
  const Link link = LinkOf(work, cell);
  const std::array<bool, 14> isOther = NodesOfNeighbour(work, cell, face);
  const auto meet = [&](int p, int q)
  { return (link.HasLabel[p] && isOther[q]) || (link.HasLabel[q] && isOther[p]); };
  bool found = false;
  ForEdges([&](int p, int q) { found = found || meet(p, q); });
  ForTrianglePairs([&](int i, int j, int p, int q)
    { found = found || (link.IsSnapped[i] && link.IsSnapped[j] && meet(p, q)); });
  return found;
}

bool LosesContact(const Work& work, Index cell)
{
  bool loses = false;
  for (int face = 0; face < 6; ++face)
  {
    const Index other = work.Grid.Neighbour(cell, face);
    loses = loses ||
      (work.Cells[other] != work.Cells[cell] && !HasContact(work, cell, face) &&
        !(work.Centres[other] == Snapped && HasContact(work, other, face ^ 1)));
  }
  return loses;
}

bool IsBroken(const Work& work, Index cell)
{
  return !IsWhole(LinkOf(work, cell)) || LosesContact(work, cell);
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

/// Returns whether a centre is to be settled because of a snapped tet with the centre of a
/// neighbour.
bool GivesWay(const Work& work, Index cell)
{
  bool gives = false;
  for (int face = 0; face < 6; ++face)
  {
    const Index other = work.Grid.Neighbour(cell, face);
    const bool isUpper = face & 1;
    if (work.Centres[other] == Snapped && HasSnappedEdge(work, isUpper ? other : cell, face / 2))
    {
      const double lead = work.Nodes.OwnFraction(cell) - work.Nodes.OwnFraction(other);
      gives = gives || lead > 0.0 || (lead == 0.0 && !isUpper);
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
