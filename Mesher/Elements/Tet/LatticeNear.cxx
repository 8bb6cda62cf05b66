#include "Elements/Tet/LatticeNear.h"

namespace vfm
{
namespace
{

constexpr int Steps[3] = { 1, 4, 16 };
constexpr std::uint64_t NotLastX = 0x7777777777777777, NotLastY = 0x0fff0fff0fff0fff;
constexpr std::uint64_t Cells = 0x0000077707770777;

/// Returns the next nodes of one kind along all axes. Those of centres include positions without
/// cells.
std::uint64_t NextAlongAxes(std::uint64_t nodes)
{
  return (nodes & NotLastX) << 1 | (nodes >> 1 & NotLastX) | (nodes & NotLastY) << 4 |
    (nodes >> 4 & NotLastY) | nodes << 16 | nodes >> 16;
}

/// Returns the positions from which an offset leads to one of some nodes.
std::uint64_t At(std::uint64_t nodes, int offset)
{
  return offset < 0 ? nodes << -offset : nodes >> offset;
}

} // namespace

NearNodes CentreAcross(int face)
{
  const std::uint64_t middle = MiddleCentre().Centres;
  return { 0, At(middle, face & 1 ? -Steps[face / 2] : Steps[face / 2]) };
}

NearNodes FindNear(const LatticeNodes& nodes, const CartesianGrid& grid, Index cell, int label)
{
  const Index first = cell - grid.CornerOffset(7);
  const int* vertices = nodes.Labels(LatticeNodes::Vertex) + first;
  const int* centres = nodes.Labels(LatticeNodes::Centre) + first;
  NearNodes found;
  for (int row = 0; row < 16; ++row)
  {
    const Index offset = (row & 3) * grid.Stride(1) + (row >> 2) * grid.Stride(2);
    for (int x = 0; x < 4; ++x)
    {
      const int bit = 4 * row + x;
      found.Vertices |= std::uint64_t(vertices[offset + x] == label) << bit;
      found.Centres |= std::uint64_t((Cells >> bit & 1) && centres[offset + x] == label) << bit;
    }
  }
  return found;
}

NearNodes NeighboursOf(const NearNodes& nodes)
{
  std::uint64_t vertices = nodes.Centres, centres = nodes.Vertices;
  for (int step : Steps)
  {
    vertices |= vertices << step;
    centres |= centres >> step;
  }
  return { NextAlongAxes(nodes.Vertices) | vertices,
    (NextAlongAxes(nodes.Centres) | centres) & Cells };
}

NearNodes ConnectedTo(const NearNodes& some, const NearNodes& set)
{
  NearNodes reached = some;
  NearNodes next = NeighboursOf(reached) & set;
  while (!IsSubset(next, reached))
  {
    reached = { reached.Vertices | next.Vertices, reached.Centres | next.Centres };
    next = NeighboursOf(reached) & set;
  }
  return reached;
}

/// The triangles have a centre and an edge between vertices, or two centres and a vertex. The
/// fourth nodes are the centres across two faces, or vertices next to the vertex on the face
/// between the centres.
bool MeetAtTriangle(const NearNodes& a, const NearNodes& b, const NearNodes& snapped)
{
  std::uint64_t found = 0;
  const auto meet = [](std::uint64_t inA, std::uint64_t inB, int p, int q)
  { return (At(inA, p) & At(inB, q)) | (At(inA, q) & At(inB, p)); };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int along = Steps[axis], u = Steps[(axis + 1) % 3], v = Steps[(axis + 2) % 3];
    for (int corner = 0; corner < 4; ++corner)
    {
      const int low = (corner & 1 ? u : 0) + (corner & 2 ? v : 0), high = low + along;
      const int acrossU = corner & 1 ? u : -u, acrossV = corner & 2 ? v : -v;
      const std::uint64_t ends = At(snapped.Vertices, low) & At(snapped.Vertices, high);
      const std::uint64_t pairs = At(snapped.Centres, along) & At(snapped.Vertices, high);
      found |= snapped.Centres &
        ((ends & meet(a.Centres, b.Centres, acrossU, acrossV)) |
          (pairs & meet(a.Vertices, b.Vertices, high - acrossU, high - acrossV)));
    }
  }
  return found != 0;
}

} // namespace vfm
