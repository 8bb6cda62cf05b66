#include "Elements/Tet/LatticeStencils.h"

#include <bitset>
#include <tuple>

namespace vfm
{
namespace
{

int CountNodes(int set)
{
  return static_cast<int>(std::bitset<4>(set).count());
}

/// Returns corner q = 0..3 of a face, in order around it.
HalfPoint FaceCorner(int axis, int q)
{
  HalfPoint corner{ { 0, 0, 0 } };
  corner[(axis + 1) % 3] = q == 1 || q == 2 ? 2 : 0;
  corner[(axis + 2) % 3] = q >= 2 ? 2 : 0;
  return corner;
}

/// Returns the centre below (-1) or above (1) a face.
HalfPoint FaceCentre(int axis, int side)
{
  HalfPoint centre{ { 1, 1, 1 } };
  centre[axis] = side;
  return centre;
}

/// Returns the first axis along which r has a value, or -1.
int AxisWhere(const HalfPoint& r, int value)
{
  return r[0] == value ? 0 : r[1] == value ? 1 : r[2] == value ? 2 : -1;
}

/// Returns the slot of a point.
/// @param count  number of its nodes
/// @param r  its start within the block, in units of 1 / (2 count) cells; the middle of the block
/// is at count
int SlotOf(int count, const HalfPoint& r)
{
  if (count == 1)
  {
    return r[0];
  }
  const auto upperHalves = [&](int axis)
  { return (r[(axis + 1) % 3] > count) + 2 * (r[(axis + 2) % 3] > count); };
  const int face = AxisWhere(r, 0);
  if (count == 2)
  {
    const int middles = (r[0] == 2) + (r[1] == 2) + (r[2] == 2);
    return middles == 0 ? 2 + (r[0] > 2) + 2 * (r[1] > 2) + 4 * (r[2] > 2)
      : middles == 1    ? 10 + AxisWhere(r, 2)
                        : 13 + face;
  }
  if (count == 3 && face >= 0)
  {
    return 16 + 4 * face + upperHalves(face);
  }
  if (count == 3)
  {
    const bool onEdge = (r[0] == 3) + (r[1] == 3) + (r[2] == 3) == 1;
    const int axis = onEdge ? AxisWhere(r, 3) : r[0] != 3 ? 0 : r[1] != 3 ? 1 : 2;
    return onEdge ? 28 + 4 * axis + upperHalves(axis) : 52 + 2 * axis + (r[axis] > 3);
  }
  if (face >= 0)
  {
    const bool alongFirst = r[(face + 1) % 3] == 4; // direction of the tet's edge on the face
    return 40 + 4 * face + (alongFirst ? 0 : 1) + (upperHalves(face) != 0 ? 2 : 0);
  }
  const int upper = AxisWhere(r, 7), lower = AxisWhere(r, 1);
  return upper >= 0 ? 58 + 2 * upper + (upperHalves(upper) & 1)
                    : 40 + 4 * lower + (upperHalves(lower) & 1);
}

/// Finds the block and slot of each point of a lattice tet.
LatticeTet MakeTet(const std::array<HalfPoint, 4>& nodes)
{
  LatticeTet tet;
  tet.Nodes = nodes;
  for (int set = 1; set < 16; ++set)
  {
    const int parts = 2 * CountNodes(set);
    HalfPoint rest;
    for (int a = 0; a < 3; ++a)
    {
      int sum = 0;
      for (int i = 0; i < 4; ++i)
      {
        sum += (set >> i & 1) * nodes[i][a];
      }
      tet.Block[set][a] = (sum + parts) / parts - 1; // rounds down because sum >= -parts
      rest[a] = sum - parts * tet.Block[set][a];
    }
    tet.Slot[set] = SlotOf(parts / 2, rest);
  }
  return tet;
}

/// Returns the determinant of the points of four sets in the lattice tet. It is positive if they
/// span a positive tet.
int Orientation(const std::array<std::uint8_t, 4>& sets)
{
  int m[4][4]; // barycentric coordinates in units of 1 / 12
  for (int row = 0; row < 4; ++row)
  {
    for (int i = 0; i < 4; ++i)
    {
      m[row][i] = (sets[row] >> i & 1) * 12 / CountNodes(sets[row]);
    }
  }
  int sum = 0;
  // Laplace expansion by pairs of columns of the first two and the last two rows.
  for (int p = 0; p < 4; ++p)
  {
    for (int q = p + 1; q < 4; ++q)
    {
      const int r = p == 0 ? (q == 1 ? 2 : 1) : 0, s = 6 - p - q - r;
      const int sign = (p + q) & 1 ? 1 : -1;
      sum +=
        sign * (m[0][p] * m[1][q] - m[0][q] * m[1][p]) * (m[2][r] * m[3][s] - m[2][s] * m[3][r]);
    }
  }
  return sum;
}

using Polygon = std::vector<int>; // sets of its corners, in order

/// Set of nodes of each class of a lattice tet; [0]: the snapped ones.
using Classes = std::array<int, 5>;

// Every region is convex before points move, so the fans below are positive.

/// Starts the region of a set of nodes.
void Open(int members, LatticeStencil& stencil)
{
  int node = -1;
  for (int i = 3; i >= 0; --i)
  {
    node = members >> i & 1 ? i : node;
  }
  const int first = stencil.Count > 0 ? stencil.List[stencil.Count - 1].Last : 0;
  stencil.List[stencil.Count++] = { node, first, first, 0 };
}

/// Adds a tet to the last region.
void Add(LatticeStencil& stencil, int a, int b, int c, int d)
{
  std::array<std::uint8_t, 4> sets{ { static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
    static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(d) } };
  if (Orientation(sets) < 0)
  {
    std::swap(sets[2], sets[3]);
  }
  LatticeStencil::Region& region = stencil.List[stencil.Count - 1];
  stencil.Tets[region.Last++] = sets;
  region.Points |= 1u << a | 1u << b | 1u << c | 1u << d;
}

/// Returns the one of two sets whose point is first: centres that are not snapped, vertices that
/// are not, then all others by id on any grid.
int Earlier(const LatticeTet& tet, int snapped, int a, int b)
{
  const auto rank = [&](int set)
  {
    const bool isAnchor = CountNodes(set) == 1 && (set & snapped) == 0;
    const int group = !isAnchor ? 2 : tet.Slot[set] == 1 ? 0 : 1;
    const HalfPoint& block = tet.Block[set];
    return std::make_tuple(group, block[2], block[1], block[0], tet.Slot[set]);
  };
  return rank(b) < rank(a) ? b : a;
}

/// Returns the corner of a polygon whose point is first (Earlier).
int First(const LatticeTet& tet, int snapped, const Polygon& polygon)
{
  int first = polygon[0];
  for (int set : polygon)
  {
    first = Earlier(tet, snapped, first, set);
  }
  return first;
}

/// Divides a polygon into a fan of triangles from one of its corners, and adds the tets between
/// these triangles and another point.
void AddFan(int apex, int from, const Polygon& polygon, LatticeStencil& stencil)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const int a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a != from && b != from)
    {
      Add(stencil, apex, from, a, b);
    }
  }
}

/// Returns the nodes of a set, each as a set of its own.
std::array<int, 4> Split(int set)
{
  std::array<int, 4> nodes{};
  int count = 0;
  for (int node = 1; node < 16; node *= 2)
  {
    if (set & node)
    {
      nodes[count++] = node;
    }
  }
  return nodes;
}

/// Returns whether all nodes of a set are of one class.
bool AreEqual(const Classes& classes, int set)
{
  return std::any_of(
    classes.begin(), classes.end(), [&](int members) { return (set & ~members) == 0; });
}

/// Returns the part of a triangle that belongs to a region.
Polygon OnFace(const Classes& classes, int triangle, int members)
{
  const int inside = triangle & members, outside = triangle & ~members;
  const std::array<int, 4> in = Split(inside), out = Split(outside);
  switch (CountNodes(inside))
  {
    case 0:
      return {};
    case 1:
      return AreEqual(classes, outside)
        ? Polygon{ inside, inside | out[0], inside | out[1] }
        : Polygon{ inside, inside | out[0], triangle, inside | out[1] };
    case 2:
      return { in[0], in[1], in[1] | outside, in[0] | outside };
    default:
      return { in[0], in[1], in[2] };
  }
}

/// Returns the interface between two regions of a tet without snapped nodes.
Polygon Between(const Classes& classes, int a, int b)
{
  const int rest = 15 & ~(a | b), both = CountNodes(a) + CountNodes(b);
  const std::array<int, 4> p = Split(CountNodes(a) > CountNodes(b) ? a : b), r = Split(rest);
  const int q = CountNodes(a) > CountNodes(b) ? b : a;
  if (both == 2)
  {
    return AreEqual(classes, rest) ? Polygon{ a | b, a | b | r[0], a | b | r[1] }
                                   : Polygon{ a | b, a | b | r[0], 15, a | b | r[1] };
  }
  if (both == 3)
  {
    return { p[0] | q, p[1] | q, p[1] | q | rest, p[0] | q | rest };
  }
  if (CountNodes(q) == 1)
  {
    return { p[0] | q, p[1] | q, p[2] | q };
  }
  const std::array<int, 4> s = Split(q);
  return { p[0] | s[0], p[0] | s[1], p[1] | s[1], p[1] | s[0] };
}

/// Returns the sides of the region of a set of nodes in a tet without snapped nodes.
std::vector<Polygon> SidesOf(const Classes& classes, int members)
{
  std::vector<Polygon> sides;
  for (int i = 0; i < 4; ++i)
  {
    sides.push_back(OnFace(classes, 15 & ~(1 << i), members));
  }
  for (int c = 1; c < 5; ++c)
  {
    if (classes[c] != 0 && classes[c] != members)
    {
      sides.push_back(Between(classes, members, classes[c]));
    }
  }
  sides.erase(std::remove(sides.begin(), sides.end(), Polygon()), sides.end());
  return sides;
}

/// Divides the region of a set of nodes into tets, which form fans from the boundary of the region.
void AddRegion(const LatticeTet& tet, const Classes& classes, int members, LatticeStencil& stencil)
{
  const int snapped = classes[0], free = 15 & ~snapped;
  const std::array<int, 4> w = Split(snapped);
  if (CountNodes(free) == 2)
  {
    Add(stencil, w[0], w[1], members, free);
    return;
  }
  if (CountNodes(free) == 3)
  {
    const Polygon face = OnFace(classes, free, members);
    AddFan(snapped, First(tet, snapped, face), face, stencil);
    return;
  }
  const std::vector<Polygon> sides = SidesOf(classes, members);
  int apex = members;
  for (const Polygon& side : sides)
  {
    apex = Earlier(tet, snapped, apex, First(tet, snapped, side));
  }
  for (const Polygon& side : sides)
  {
    if (std::find(side.begin(), side.end(), apex) == side.end())
    {
      AddFan(apex, First(tet, snapped, side), side, stencil);
    }
  }
}

/// Returns the stencil of a lattice tet.
/// @param classOf  class of each node: 0 if snapped; nodes with one label are in one class
LatticeStencil MakeStencil(const LatticeTet& tet, const std::array<int, 4>& classOf)
{
  Classes classes{};
  for (int i = 0; i < 4; ++i)
  {
    classes[classOf[i]] |= 1 << i;
  }
  const int labels = (classes[1] != 0) + (classes[2] != 0) + (classes[3] != 0) + (classes[4] != 0);
  LatticeStencil stencil;
  if (labels < 2)
  {
    Open(classes[1], stencil);
    Add(stencil, 1, 2, 4, 8);
  }
  for (int c = 1; c <= labels && labels > 1; ++c)
  {
    Open(classes[c], stencil);
    AddRegion(tet, classes, classes[c], stencil);
  }
  return stencil;
}

/// Returns the axis of the face on which the nodes of a point depend: they differ if this face is
/// on the domain boundary. Returns -1 if they never differ.
int FaceAxis(int slot)
{
  if (slot < 13 || (slot >= 28 && slot < 40))
  {
    return -1;
  }
  return slot < 16 ? slot - 13
    : slot < 28    ? (slot - 16) / 4
    : slot < 52    ? (slot - 40) / 4
    : slot < 58    ? (slot - 52) / 2
                   : (slot - 58) / 2;
}

} // namespace

LatticeTables::LatticeTables()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int t = 0; t < 4; ++t)
    {
      this->AddShape(InnerShape(axis) + t,
        { { FaceCentre(axis, -1), FaceCorner(axis, t), FaceCorner(axis, (t + 1) % 4),
          FaceCentre(axis, 1) } },
        -1);
    }
    for (int half = 0; half < 4; ++half)
    {
      const int diagonal = half / 2, t = half % 2;
      const HalfPoint a = FaceCorner(axis, diagonal), b = FaceCorner(axis, (diagonal + 1 + t) % 4),
                      c = FaceCorner(axis, (diagonal + 2 + t) % 4);
      this->AddShape(
        DomainShape(axis, 0, diagonal) + t, { { a, b, c, FaceCentre(axis, 1) } }, diagonal);
      this->AddShape(
        DomainShape(axis, 1, diagonal) + t, { { a, c, b, FaceCentre(axis, -1) } }, diagonal);
    }
  }
  this->AddPatterns();
}

const LatticeTables& LatticeTables::Get()
{
  static const LatticeTables tables;
  return tables;
}

void LatticeTables::AddShape(int shape, const std::array<HalfPoint, 4>& nodes, int domain)
{
  const LatticeTet tet = MakeTet(nodes);
  this->Tets[shape] = tet;
  for (int set = 1; set < 16; ++set)
  {
    PointNodes& source = this->Sources[domain + 1][tet.Slot[set]];
    source.Count = 0; // all tets that have the point give the same nodes
    for (int i = 0; i < 4; ++i)
    {
      if (set >> i & 1)
      {
        HalfPoint& node = source.Nodes[source.Count++];
        for (int a = 0; a < 3; ++a)
        {
          node[a] = nodes[i][a] - 2 * tet.Block[set][a];
        }
      }
    }
  }
}

/// Makes the stencils of every shape, for every pattern of snapped and equal labels.
void LatticeTables::AddPatterns()
{
  std::vector<std::array<int, 4>> patterns;
  for (int code = 0; code < 625; ++code)
  {
    const std::array<int, 4> classes{ { code / 125, code / 25 % 5, code / 5 % 5, code % 5 } };
    int known = 0;           // classes are numbered in the order of their first nodes
    bool isFirst = code > 0; // not all nodes are snapped
    for (int c : classes)
    {
      isFirst = isFirst && c <= known + 1;
      known = std::max(known, c);
    }
    if (isFirst)
    {
      const std::array<int, 4> labels{ { classes[0] - 1, classes[1] - 1, classes[2] - 1,
        classes[3] - 1 } };
      this->PatternOfCode[Code(labels)] = static_cast<std::uint8_t>(patterns.size());
      patterns.push_back(classes);
    }
  }
  for (const LatticeTet& tet : this->Tets)
  {
    for (const std::array<int, 4>& classes : patterns)
    {
      this->Stencils.push_back(MakeStencil(tet, classes));
    }
  }
}

Vector3 LatticeTables::StartOf(const CartesianGrid& grid, const Index3& block, int slot) const
{
  int source = 0;
  const int axis = FaceAxis(slot);
  if (axis >= 0)
  {
    Index3 face = block;
    face[axis] += slot > 57 || (slot > 51 && (slot & 1)); // face on the upper side of the cell
    const bool onDomain = face[axis] == 0 || face[axis] == grid.Global().Upper[axis];
    source = onDomain ? 1 + Diagonal(grid.Canonical(face)) : 0;
  }
  const PointNodes& point = this->Sources[source][slot];
  Vector3 first, x;
  for (int i = 0; i < point.Count; ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double* at = &grid.Coordinates(a)[block[a] + (point.Nodes[i][a] >> 1)];
      const double node = point.Nodes[i][a] & 1 ? 0.5 * (at[0] + at[1]) : at[0];
      first[a] = i == 0 ? node : first[a];
      x[a] = i == 0 ? node : x[a] + (node - first[a]) / point.Count;
    }
  }
  return x;
}

} // namespace vfm
