#include "Octree/SlabPillow.h"

#include "Base/Sorted.h"
#include "Base/Vector3.h"

#include <tuple>

namespace vfm
{
namespace
{

// Number of cells around the box on which positions in it depend.
constexpr Index Halo = 4;
constexpr double Step = 0.5, ConcaveStep = 0.25;
constexpr int PowersOf3[3] = { 1, 3, 9 }, PowersOf7[3] = { 1, 7, 49 };

/// Old edge from a copied node, behind a pillow face in a local direction.
struct Spoke
{
  int Copy, Direction;
  int End;
};

/// Pillows around the slabs of one axis.
struct Pillows
{
  int Axis;
  // Whether each hex belongs to the set of the slab.
  std::vector<unsigned char> Inside{};
  // Pillow faces of each hex, one bit per local face.
  std::vector<unsigned char> Faces{};
  // Copies of each node of before, by digit - 1.
  std::vector<std::array<int, 2>> Copies{};

  bool HasFace(std::size_t hex, int face) const { return this->Faces[hex] >> face & 1; }
};

Index SlabOf(const PillowedLevel& mesh, int axis, std::size_t hex)
{
  return mesh.Cells[mesh.Hexes[hex].Cell][axis] >> 1;
}

int FaceAt(int corner, int axis)
{
  return 2 * axis + (corner >> axis & 1);
}

/// Returns whether a face may be pillowed: on the domain boundary only at the end of a slab.
/// @param ends  sides of the domain at which slabs end, one bit each
bool MayPillow(const PillowedLevel& mesh, int ends, std::size_t hex, int face)
{
  int sides = 63;
  for (int c = 0; c < 8; ++c)
  {
    if (FaceAt(c, face / 2) == face)
    {
      sides &= mesh.Nodes[mesh.Hexes[hex].Nodes[c]].Sides;
    }
  }
  return sides == 0 || (sides & ends);
}

/// Finds the outer faces of the hexes of each slab, one bit per local face.
/// @param inside  whether each hex belongs to the set of the slab
std::vector<unsigned char> FindPillowFaces(
  const PillowedLevel& mesh, int axis, int ends, const std::vector<unsigned char>& inside)
{
  struct HexFace
  {
    std::array<int, 4> Nodes; // ascending
    Index Slab;
    std::size_t Hex;
    int Face;
    bool operator<(const HexFace& o) const
    {
      return std::tie(this->Nodes, this->Slab) < std::tie(o.Nodes, o.Slab);
    }
  };
  std::vector<HexFace> sides;
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    for (int f = 0; inside[h] && f < 6; ++f)
    {
      HexFace side{ {}, SlabOf(mesh, axis, h), h, f };
      int n = 0;
      for (int c = 0; c < 8; ++c)
      {
        if (FaceAt(c, f / 2) == f)
        {
          side.Nodes[n++] = mesh.Hexes[h].Nodes[c];
        }
      }
      std::sort(side.Nodes.begin(), side.Nodes.end());
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<unsigned char> faces(mesh.Hexes.size(), 0);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const bool shared =
      (s > 0 && !(sides[s - 1] < sides[s])) || (s + 1 < sides.size() && !(sides[s] < sides[s + 1]));
    if (!shared && MayPillow(mesh, ends, sides[s].Hex, sides[s].Face))
    {
      faces[sides[s].Hex] |= 1 << sides[s].Face;
    }
  }
  return faces;
}

/// Returns the digit of the copies of a node in a slab, 1 or 2.
int DigitIn(const PillowedLevel::Node& node, int axis, Index slab)
{
  return node.Base[axis] == 2 * slab ? 2 : 1;
}

/// Returns the copy of a node for the slab of a hex, -1 if there is none.
int CopyFor(const PillowedLevel& mesh, const Pillows& pillows, std::size_t hex, int node)
{
  const Index slab = SlabOf(mesh, pillows.Axis, hex);
  return pillows.Copies[node][DigitIn(mesh.Nodes[node], pillows.Axis, slab) - 1];
}

PillowedLevel::Node MakeCopy(const PillowedLevel::Node& node, int axis, int digit)
{
  PillowedLevel::Node copy = node;
  copy.Slot += digit * PowersOf3[axis];
  if (copy.Base[axis] % 2 == 0)
  {
    copy.Sides &= ~(3 << (2 * axis));
    copy.Seams &= ~(1 << axis);
  }
  return copy;
}

/// Adds a copy of each node of pillow faces, at the position of the node.
void CopyNodes(PillowedLevel& mesh, Pillows& pillows)
{
  pillows.Copies.assign(mesh.Nodes.size(), { { -1, -1 } });
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    for (int at = 0; pillows.Faces[h] && at < 24; ++at)
    {
      const int c = at / 3;
      const int node = mesh.Hexes[h].Nodes[c];
      if (pillows.HasFace(h, FaceAt(c, at % 3)) && CopyFor(mesh, pillows, h, node) < 0)
      {
        const Index slab = SlabOf(mesh, pillows.Axis, h);
        const int digit = DigitIn(mesh.Nodes[node], pillows.Axis, slab);
        pillows.Copies[node][digit - 1] = static_cast<int>(mesh.Nodes.size());
        mesh.Nodes.push_back(MakeCopy(mesh.Nodes[node], pillows.Axis, digit));
      }
    }
  }
}

/// Orders nodes independently of what else the mesh contains.
bool ComesBefore(const PillowedLevel::Node& n, const PillowedLevel::Node& m)
{
  return std::tie(n.Base, n.Slot) < std::tie(m.Base, m.Slot);
}

/// Lists the spokes once each, by copy, direction and end.
std::vector<Spoke> ListSpokes(const PillowedLevel& mesh, const Pillows& pillows)
{
  std::vector<Spoke> spokes;
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    const std::array<int, 8>& nodes = mesh.Hexes[h].Nodes;
    for (int at = 0; pillows.Faces[h] && at < 24; ++at)
    {
      const int c = at / 3, face = FaceAt(c, at % 3);
      if (pillows.HasFace(h, face))
      {
        spokes.push_back({ CopyFor(mesh, pillows, h, nodes[c]), face, nodes[c ^ 1 << at % 3] });
      }
    }
  }
  std::sort(spokes.begin(), spokes.end(),
    [&](const Spoke& a, const Spoke& b)
    {
      return std::tie(a.Copy, a.Direction) != std::tie(b.Copy, b.Direction)
        ? std::tie(a.Copy, a.Direction) < std::tie(b.Copy, b.Direction)
        : ComesBefore(mesh.Nodes[a.End], mesh.Nodes[b.End]);
    });
  spokes.erase(std::unique(spokes.begin(), spokes.end(),
                 [](const Spoke& a, const Spoke& b)
                 { return a.Copy == b.Copy && a.Direction == b.Direction && a.End == b.End; }),
    spokes.end());
  return spokes;
}

/// Returns bits of each copy: bit 6 f + g is set if a hex corner there has pillow faces in local
/// directions f and g.
std::vector<std::uint64_t> FindConvexPairs(const PillowedLevel& mesh, const Pillows& pillows)
{
  const std::size_t nodesBefore = pillows.Copies.size();
  std::vector<std::uint64_t> pairs(mesh.Nodes.size() - nodesBefore, 0);
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    for (int at = 0; pillows.Faces[h] && at < 72; ++at)
    {
      const int c = at / 9, f = FaceAt(c, at / 3 % 3), g = FaceAt(c, at % 3);
      if (pillows.HasFace(h, f) && pillows.HasFace(h, g))
      {
        const int copy = CopyFor(mesh, pillows, h, mesh.Hexes[h].Nodes[c]);
        pairs[copy - nodesBefore] |= std::uint64_t(1) << (6 * f + g);
      }
    }
  }
  return pairs;
}

/// Mean ends of the spokes of a copy, by direction.
struct SpokeEnds
{
  std::array<Vector3, 6> Sum{};
  std::array<int, 6> Count{};

  void Add(int direction, const Vector3& end)
  {
    this->Sum[direction] = this->Sum[direction] + end;
    ++this->Count[direction];
  }
};

/// Moves a copy from its original along the mean spokes.
/// @param pairs  pairs of directions that are convex (FindConvexPairs)
void PlaceCopy(const SpokeEnds& ends, std::uint64_t pairs, PillowedLevel::Node& node)
{
  const Vector3 start = node.X; // position of the original
  for (int f = 0; f < 6; ++f)
  {
    double step = ends.Count[f] ? Step : 0.0;
    for (int g = 0; g < 6; ++g)
    {
      step = ends.Count[f] && ends.Count[g] && !(pairs >> (6 * f + g) & 1) ? ConcaveStep : step;
    }
    const Vector3 mean = (1.0 / std::max(ends.Count[f], 1)) * ends.Sum[f];
    for (int a = 0; a < 3; ++a)
    {
      const bool stays = (node.Sides >> (2 * a) & 3) || (node.Seams >> a & 1);
      node.X[a] += stays || !ends.Count[f] ? 0.0 : step * (mean[a] - start[a]);
    }
  }
}

void PlaceCopies(const Pillows& pillows, PillowedLevel& mesh)
{
  const std::vector<Spoke> spokes = ListSpokes(mesh, pillows);
  const std::vector<std::uint64_t> convex = FindConvexPairs(mesh, pillows);
  for (std::size_t first = 0; first < spokes.size();)
  {
    const int copy = spokes[first].Copy;
    SpokeEnds ends;
    for (; first < spokes.size() && spokes[first].Copy == copy; ++first)
    {
      ends.Add(spokes[first].Direction, mesh.Nodes[spokes[first].End].X);
    }
    PlaceCopy(ends, convex[copy - pillows.Copies.size()], mesh.Nodes[copy]);
  }
}

/// Makes a hex at each pillow face, and the hexes inside end at the copies.
void InsertHexes(const Pillows& pillows, PillowedLevel& mesh)
{
  for (std::size_t h = 0; h < pillows.Inside.size(); ++h)
  {
    if (!pillows.Inside[h])
    {
      continue;
    }
    const PillowedLevel::Hex old = mesh.Hexes[h];
    std::array<int, 8> inner = old.Nodes;
    for (int& node : inner)
    {
      const int copy = CopyFor(mesh, pillows, h, node);
      node = copy >= 0 ? copy : node;
    }
    for (int f = 0; f < 6; ++f)
    {
      if (!pillows.HasFace(h, f))
      {
        continue;
      }
      PillowedLevel::Hex made = old;
      made.Slot += (1 + f) * PowersOf7[pillows.Axis];
      for (int c = 0; c < 8; ++c)
      {
        if (FaceAt(c, f / 2) != f)
        {
          made.Nodes[c] = inner[c ^ 1 << f / 2];
        }
      }
      mesh.Hexes.push_back(made);
    }
    mesh.Hexes[h].Nodes = inner;
  }
}

/// Inserts pillows around the slabs of an axis.
/// @param slabs  axes of the slabs of each cell, one bit each
/// @param upperEnd  whether a slab may end at the upper side of the domain
void Pillow(int axis, const std::vector<int>& slabs, bool upperEnd, PillowedLevel& mesh)
{
  Pillows pillows{ axis };
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    pillows.Inside.push_back(slabs[hex.Cell] >> axis & 1);
  }
  const int ends = (upperEnd ? 3 : 1) << (2 * axis);
  pillows.Faces = FindPillowFaces(mesh, axis, ends, pillows.Inside);
  CopyNodes(mesh, pillows);
  PlaceCopies(pillows, mesh);
  InsertHexes(pillows, mesh);
}

/// Returns the touched cells of a box, ascending by key of their hexes.
std::vector<Index3> ListTouchedCells(const OctantFamilies& sets, int level, const IndexBox& box)
{
  const OctreeKeys& lattice = sets.Lattice();
  std::vector<Index> keys;
  for (Index key : sets.Keys(level))
  {
    const Index3 family = lattice.FamilyOfKey(level, key);
    for (int n = 0; n < 64; ++n)
    {
      const Index3 step{ { n % 4 - 1, n / 4 % 4 - 1, n / 16 - 1 } };
      Index3 cell;
      int away = 0;
      for (int a = 0; a < 3; ++a)
      {
        cell[a] = 2 * family[a] + step[a];
        away += step[a] < 0 || step[a] > 1;
      }
      if (away < 3 && box.Contains(cell) && lattice.HasCell(level, cell))
      {
        keys.push_back(lattice.HexKey(level, cell, 0));
      }
    }
  }
  SortUnique(keys);
  std::vector<Index3> cells;
  for (Index key : keys)
  {
    cells.push_back(lattice.HexOfKey(key).At);
  }
  return cells;
}

/// Makes one hex per cell.
PillowedLevel MakeCells(const OctantFamilies& sets, int level, const IndexBox& box)
{
  const OctreeKeys& lattice = sets.Lattice();
  PillowedLevel mesh;
  mesh.Cells = ListTouchedCells(sets, level, box);
  std::vector<Index> keys;
  const auto cornerKey = [&](const Index3& cell, int c)
  { return lattice.NodeKey(level, CornerOfCell(cell, c), 0); };
  for (const Index3& cell : mesh.Cells)
  {
    for (int c = 0; c < 8; ++c)
    {
      keys.push_back(cornerKey(cell, c));
    }
  }
  SortUnique(keys);
  for (Index key : keys)
  {
    const Index3 node = lattice.NodeOfKey(key).At;
    const Vector3 x{ { static_cast<double>(node[0]), static_cast<double>(node[1]),
      static_cast<double>(node[2]) } };
    mesh.Nodes.push_back({ node, 0, lattice.DomainSides(level, node),
      lattice.FlatSeams(level, node), std::ldexp(1.0, -level) * x });
  }
  for (std::size_t n = 0; n < mesh.Cells.size(); ++n)
  {
    PillowedLevel::Hex hex{ {}, static_cast<int>(n), 0 };
    for (int c = 0; c < 8; ++c)
    {
      hex.Nodes[c] = static_cast<int>(FindSorted(keys, cornerKey(mesh.Cells[n], c)));
    }
    mesh.Hexes.push_back(hex);
  }
  return mesh;
}

} // namespace

int ChildOfHex(const Index3& cell, int slot)
{
  int child = 0;
  for (int a = 0; a < 3; ++a)
  {
    const int digit = slot / PowersOf7[a] % 7;
    // the hex made on the outer side of its layer is the outer half
    child |= static_cast<int>(digit ? (digit - 1) & 1 : 1 - (cell[a] & 1)) << a;
  }
  return child;
}

PillowedLevel PillowSlabs(const OctantFamilies& sets, int level, const IndexBox& box)
{
  IndexBox wide;
  for (int a = 0; a < 3; ++a)
  {
    wide.Lower[a] = box.Lower[a] - Halo;
    wide.Upper[a] = box.Upper[a] + Halo;
  }
  PillowedLevel mesh = MakeCells(sets, level, wide);
  std::vector<int> slabs;
  for (const Index3& cell : mesh.Cells)
  {
    slabs.push_back(sets.FindSlabs(level, cell));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Pillow(axis, slabs, sets.Lattice().Cells(level, axis) % 2 == 0, mesh);
  }
  return mesh;
}

} // namespace vfm
