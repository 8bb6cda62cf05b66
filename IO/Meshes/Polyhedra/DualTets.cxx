#include "Meshes/Polyhedra/DualTets.h"

#include <numeric>

namespace vfm
{
namespace
{

/// Returns the lowest member of a group, and shortens the way to it.
Index FindRoot(std::vector<Index>& parents, Index member)
{
  while (parents[member] != member)
  {
    parents[member] = parents[parents[member]];
    member = parents[member];
  }
  return member;
}

void Join(std::vector<Index>& parents, Index a, Index b)
{
  const Index first = FindRoot(parents, a), second = FindRoot(parents, b);
  parents[std::max(first, second)] = std::min(first, second);
}

/// Returns the lowest corner, 4 * tet + corner, of the cell of each corner.
std::vector<Index> GroupCorners(const DualTets& tets)
{
  std::vector<Index> parents(4 * tets.Count());
  std::iota(parents.begin(), parents.end(), Index(0));
  for (Index side = 0; side < 4 * tets.Count(); ++side)
  {
    const Index tet = side / 4, behind = tets.BehindSide(side);
    if (behind > tet && !tets.IsWall(side))
    {
      for (int c = 0; c < 4; ++c)
      {
        if (SideByCorner[c] != side % 4)
        {
          Join(parents, 4 * tet + c, 4 * behind + tets.CornerAt(behind, tets.Node(tet, c)));
        }
      }
    }
  }
  for (Index corner = 0; corner < 4 * tets.Count(); ++corner)
  {
    parents[corner] = parents[parents[corner]]; // roots are lower, so they are final
  }
  return parents;
}

/// Goes around an edge, to the side that does not contain a node.
/// @param[in,out] tet  a tetrahedron at the edge; the last one before the wall, or `end`
/// @param[in,out] from  its node on the side through which the way enters
/// @return the wall, or -1 if the way comes to the tetrahedron `end`
Index GoToWall(const DualTets& tets, const EdgeIds& edge, Index end, Index& tet, Index& from,
  std::vector<Index>* passed)
{
  for (;;)
  {
    const Index side = 4 * tet + SideByCorner[tets.CornerAt(tet, from)];
    if (tets.IsWall(side))
    {
      return side;
    }
    Index next = -1; // third node of the side
    for (int c = 0; c < 4; ++c)
    {
      const Index node = tets.Node(tet, c);
      next = node != edge[0] && node != edge[1] && node != from ? node : next;
    }
    tet = tets.BehindSide(side);
    from = next;
    if (tet == end)
    {
      return -1;
    }
    if (passed)
    {
      passed->push_back(tet);
    }
  }
}

} // namespace

DualCells FindDualCells(const DualTets& tets, const std::vector<char>& isApart)
{
  DualCells cells;
  cells.OfCorner = GroupCorners(tets);
  for (std::size_t corner = 0; corner < isApart.size(); ++corner)
  {
    cells.OfCorner[corner] = isApart[corner] ? static_cast<Index>(corner) : cells.OfCorner[corner];
  }
  std::vector<std::pair<Index, Index>> order; // node and lowest corner of each cell
  for (Index corner = 0; corner < 4 * tets.Count(); ++corner)
  {
    if (cells.OfCorner[corner] == corner)
    {
      order.emplace_back(tets.Node(corner / 4, static_cast<int>(corner % 4)), corner);
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> numbers(cells.OfCorner.size());
  for (const auto& [node, corner] : order)
  {
    numbers[corner] = static_cast<Index>(cells.Nodes.size());
    cells.Nodes.push_back(node);
    cells.Tets.push_back(corner / 4);
  }
  for (Index& cell : cells.OfCorner)
  {
    cell = numbers[cell];
  }
  return cells;
}

EdgeArc FollowEdge(const DualTets& tets, Index tet, int edge)
{
  const int* corners = CornersByEdge[edge];
  const EdgeIds ends{ { tets.Node(tet, corners[0]), tets.Node(tet, corners[1]) } };
  EdgeArc arc;
  Index first = tet, from = tets.Node(tet, corners[3]);
  arc.FirstSide = GoToWall(tets, ends, tet, first, from, nullptr);
  arc.Tets = { first };
  if (arc.FirstSide < 0)
  {
    from = tets.Node(tet, corners[2]);
    GoToWall(tets, ends, tet, first, from, &arc.Tets);
    return arc;
  }
  for (int c = 0; c < 4; ++c) // turn around at the wall
  {
    const Index node = tets.Node(first, c);
    if (node != ends[0] && node != ends[1] && node != from)
    {
      from = node;
      break;
    }
  }
  arc.LastSide = GoToWall(tets, ends, -1, first, from, &arc.Tets);
  return arc;
}

int EdgeBetween(int first, int second)
{
  for (int edge = 0; edge < 6; ++edge)
  {
    const int* corners = CornersByEdge[edge];
    if ((corners[0] == first && corners[1] == second) ||
      (corners[0] == second && corners[1] == first))
    {
      return edge;
    }
  }
  return -1;
}

} // namespace vfm
