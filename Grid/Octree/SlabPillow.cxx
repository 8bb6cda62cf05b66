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
struct Work
{
  const OctantFamilies& Sets;
  int Level, Axis;
  PillowedLevel& Mesh;
  // Whether each hex belongs to the set of the slab.
  std::vector<unsigned char> Inside;
  // Pillow faces of each hex, one bit per local face.
  std::vector<unsigned char> PillowFaces;
  // Copies of each node, by digit - 1.
  std::vector<std::array<int, 2>> Copies;
  int NodesBefore;
};

Index SlabOf(const Work& work, std::size_t hex)
{
  return work.Mesh.Cells[work.Mesh.Hexes[hex].Cell][work.Axis] >> 1;
}

int FaceAt(int corner, int axis)
{
  return 2 * axis + (corner >> axis & 1);
}

/// Returns whether a face may be pillowed: on the domain boundary only at the end of a slab.
bool MayPillow(const Work& work, std::size_t hex, int face)
{
  int sides = 63;
  for (int c = 0; c < 8; ++c)
  {
    if (FaceAt(c, face / 2) == face)
    {
      sides &= work.Mesh.Nodes[work.Mesh.Hexes[hex].Nodes[c]].Sides;
    }
  }
  const bool upperEnd = work.Sets.Lattice().Cells(work.Level, work.Axis) % 2 == 0;
  const int ends = (upperEnd ? 3 : 1) << (2 * work.Axis);
  return sides == 0 || (sides & ends);
}

/// Finds the outer faces of the hexes of each slab.
void FindPillowFaces(Work& work)
{
  struct Side
  {
    std::array<int, 4> Nodes; // ascending
    Index Slab;
    std::size_t Hex;
    int Face;
    bool operator<(const Side& o) const
    {
      return std::tie(this->Nodes, this->Slab) < std::tie(o.Nodes, o.Slab);
    }
  };
  std::vector<Side> sides;
  for (std::size_t h = 0; h < work.Mesh.Hexes.size(); ++h)
  {
    for (int f = 0; work.Inside[h] && f < 6; ++f)
    {
      Side side{ {}, SlabOf(work, h), h, f };
      int n = 0;
      for (int c = 0; c < 8; ++c)
      {
        if (FaceAt(c, f / 2) == f)
        {
          side.Nodes[n++] = work.Mesh.Hexes[h].Nodes[c];
        }
      }
      std::sort(side.Nodes.begin(), side.Nodes.end());
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const bool shared =
      (s > 0 && !(sides[s - 1] < sides[s])) || (s + 1 < sides.size() && !(sides[s] < sides[s + 1]));
    if (!shared && MayPillow(work, sides[s].Hex, sides[s].Face))
    {
      work.PillowFaces[sides[s].Hex] |= 1 << sides[s].Face;
    }
  }
}

bool IsPillowed(const Work& work, std::size_t hex, int face)
{
  return work.PillowFaces[hex] >> face & 1;
}

/// Returns the digit of the copies of a node in a slab, 1 or 2.
int DigitIn(const Work& work, int node, Index slab)
{
  return work.Mesh.Nodes[node].Base[work.Axis] == 2 * slab ? 2 : 1;
}

int CopyIn(const Work& work, int node, Index slab)
{
  return work.Copies[node][DigitIn(work, node, slab) - 1];
}

void CopyNodes(Work& work)
{
  for (std::size_t h = 0; h < work.Inside.size(); ++h)
  {
    const Index slab = SlabOf(work, h);
    for (int at = 0; work.PillowFaces[h] && at < 24; ++at)
    {
      const int c = at / 3;
      const int node = work.Mesh.Hexes[h].Nodes[c];
      if (!IsPillowed(work, h, FaceAt(c, at % 3)) || CopyIn(work, node, slab) >= 0)
      {
        continue;
      }
      const int digit = DigitIn(work, node, slab);
      work.Copies[node][digit - 1] = static_cast<int>(work.Mesh.Nodes.size());
      PillowedLevel::Node copy = work.Mesh.Nodes[node];
      copy.Slot += digit * PowersOf3[work.Axis];
      if (copy.Base[work.Axis] % 2 == 0)
      {
        copy.Sides &= ~(3 << (2 * work.Axis));
        copy.Seams &= ~(1 << work.Axis);
      }
      work.Mesh.Nodes.push_back(copy);
    }
  }
}

/// Orders nodes independently of what else the mesh contains.
bool ComesBefore(const Work& work, int a, int b)
{
  const PillowedLevel::Node &n = work.Mesh.Nodes[a], &m = work.Mesh.Nodes[b];
  return std::tie(n.Base, n.Slot) < std::tie(m.Base, m.Slot);
}

/// Lists the spokes once each, by copy, direction and end.
std::vector<Spoke> ListSpokes(const Work& work)
{
  std::vector<Spoke> spokes;
  for (std::size_t h = 0; h < work.Inside.size(); ++h)
  {
    const std::array<int, 8>& nodes = work.Mesh.Hexes[h].Nodes;
    for (int at = 0; work.PillowFaces[h] && at < 24; ++at)
    {
      const int c = at / 3, face = FaceAt(c, at % 3);
      if (IsPillowed(work, h, face))
      {
        spokes.push_back({ CopyIn(work, nodes[c], SlabOf(work, h)), face, nodes[c ^ 1 << at % 3] });
      }
    }
  }
  std::sort(spokes.begin(), spokes.end(),
    [&](const Spoke& a, const Spoke& b)
    {
      return std::tie(a.Copy, a.Direction) != std::tie(b.Copy, b.Direction)
        ? std::tie(a.Copy, a.Direction) < std::tie(b.Copy, b.Direction)
        : ComesBefore(work, a.End, b.End);
    });
  spokes.erase(std::unique(spokes.begin(), spokes.end(),
                 [](const Spoke& a, const Spoke& b)
                 { return a.Copy == b.Copy && a.Direction == b.Direction && a.End == b.End; }),
    spokes.end());
  return spokes;
}

/// Returns bits of each copy: bit 6 f + g is set if a hex corner there has pillow faces in local
/// directions f and g.
std::vector<std::uint64_t> FindConvexPairs(const Work& work)
{
  std::vector<std::uint64_t> pairs(work.Mesh.Nodes.size() - work.NodesBefore, 0);
  for (std::size_t h = 0; h < work.Inside.size(); ++h)
  {
    for (int at = 0; work.PillowFaces[h] && at < 72; ++at)
    {
      const int c = at / 9, f = FaceAt(c, at / 3 % 3), g = FaceAt(c, at % 3);
      if (IsPillowed(work, h, f) && IsPillowed(work, h, g))
      {
        const int copy = CopyIn(work, work.Mesh.Hexes[h].Nodes[c], SlabOf(work, h));
        pairs[copy - work.NodesBefore] |= std::uint64_t(1) << (6 * f + g);
      }
    }
  }
  return pairs;
}

void PlaceCopies(Work& work)
{
  const std::vector<Spoke> spokes = ListSpokes(work);
  const std::vector<std::uint64_t> convex = FindConvexPairs(work);
  for (std::size_t first = 0; first < spokes.size();)
  {
    const int copy = spokes[first].Copy;
    const std::uint64_t pairs = convex[copy - work.NodesBefore];
    Vector3 ends[6]{};
    int count[6]{};
    for (; first < spokes.size() && spokes[first].Copy == copy; ++first)
    {
      const Spoke& spoke = spokes[first];
      ends[spoke.Direction] = ends[spoke.Direction] + work.Mesh.Nodes[spoke.End].X;
      ++count[spoke.Direction];
    }
    PillowedLevel::Node& node = work.Mesh.Nodes[copy];
    const Vector3 start = node.X; // position of the original
    for (int f = 0; f < 6; ++f)
    {
      double step = count[f] ? Step : 0.0;
      for (int g = 0; g < 6; ++g)
      {
        step = count[f] && count[g] && !(pairs >> (6 * f + g) & 1) ? ConcaveStep : step;
      }
      const Vector3 mean = (1.0 / std::max(count[f], 1)) * ends[f];
      for (int a = 0; a < 3; ++a)
      {
        const bool stays = (node.Sides >> (2 * a) & 3) || (node.Seams >> a & 1);
        node.X[a] += stays || !count[f] ? 0.0 : step * (mean[a] - start[a]);
      }
    }
  }
}

void InsertHexes(Work& work)
{
  for (std::size_t h = 0; h < work.Inside.size(); ++h)
  {
    if (!work.Inside[h])
    {
      continue;
    }
    const Index slab = SlabOf(work, h);
    const PillowedLevel::Hex old = work.Mesh.Hexes[h];
    std::array<int, 8> inner = old.Nodes;
    for (int& node : inner)
    {
      const int copy = CopyIn(work, node, slab);
      node = copy >= 0 ? copy : node;
    }
    for (int f = 0; f < 6; ++f)
    {
      if (!IsPillowed(work, h, f))
      {
        continue;
      }
      PillowedLevel::Hex made = old;
      made.Slot += (1 + f) * PowersOf7[work.Axis];
      for (int c = 0; c < 8; ++c)
      {
        if (FaceAt(c, f / 2) != f)
        {
          made.Nodes[c] = inner[c ^ 1 << f / 2];
        }
      }
      work.Mesh.Hexes.push_back(made);
    }
    work.Mesh.Hexes[h].Nodes = inner;
  }
}

void Pillow(const OctantFamilies& sets, int level, int axis, const std::vector<int>& slabs,
  PillowedLevel& mesh)
{
  Work work{ sets, level, axis, mesh, {}, std::vector<unsigned char>(mesh.Hexes.size(), 0),
    std::vector<std::array<int, 2>>(mesh.Nodes.size(), { { -1, -1 } }),
    static_cast<int>(mesh.Nodes.size()) };
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    work.Inside.push_back(slabs[hex.Cell] >> axis & 1);
  }
  FindPillowFaces(work);
  CopyNodes(work);
  PlaceCopies(work);
  InsertHexes(work);
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
    Pillow(sets, level, axis, slabs, mesh);
  }
  return mesh;
}

} // namespace vfm
