#include "Octree/SlabPillow.h"

#include "Base/Sorted.h"
#include "Base/Vector3.h"

#include <tuple>

namespace vfm
{
namespace
{

constexpr Index Halo = 4; // cells around the box on which positions in it depend
constexpr double Step = 0.5, ConcaveStep = 0.25;
constexpr int PowersOf3[3] = { 1, 3, 9 }, PowersOf7[3] = { 1, 7, 49 };

/// Pillows around the slabs of one axis.
class AxisPillow
{
public:
  AxisPillow(const OctantFamilies& sets, int level, int axis, const std::vector<int>& slabs,
    PillowedLevel& mesh) :
    Sets(sets),
    Level(level),
    Axis(axis),
    Mesh(mesh),
    Inside(mesh.Hexes.size()),
    PillowFaces(mesh.Hexes.size(), 0),
    Copies(mesh.Nodes.size(), { { -1, -1 } }),
    NodesBefore(static_cast<int>(mesh.Nodes.size()))
  {
    for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
    {
      this->Inside[h] = slabs[mesh.Hexes[h].Cell] >> axis & 1;
    }
  }

  void Run()
  {
    this->FindPillowFaces();
    this->CopyNodes();
    this->PlaceCopies();
    this->InsertHexes();
  }

private:
  /// An old edge from a copied node, behind a pillow face in a local direction.
  struct Spoke
  {
    int Copy, Direction;
    int End;
  };

  Index SlabOf(std::size_t hex) const
  {
    return this->Mesh.Cells[this->Mesh.Hexes[hex].Cell][this->Axis] >> 1;
  }
  static int FaceAt(int corner, int axis) { return 2 * axis + (corner >> axis & 1); }
  bool IsPillowed(std::size_t hex, int face) const { return this->PillowFaces[hex] >> face & 1; }

  /// The digit of the copies of a node in a slab, 1 or 2.
  int DigitIn(int node, Index slab) const
  {
    return this->Mesh.Nodes[node].Base[this->Axis] == 2 * slab ? 2 : 1;
  }
  int CopyIn(int node, Index slab) const
  {
    return this->Copies[node][this->DigitIn(node, slab) - 1];
  }

  void FindPillowFaces();
  bool MayPillow(std::size_t hex, int face) const;
  void CopyNodes();
  std::vector<Spoke> ListSpokes() const;
  std::vector<std::uint64_t> FindConvexPairs() const;
  void PlaceCopies();
  void InsertHexes();
  bool ComesBefore(int a, int b) const;

  const OctantFamilies& Sets;
  int Level, Axis;
  PillowedLevel& Mesh;
  std::vector<unsigned char> Inside;      // of each hex: whether it belongs to the slab's set
  std::vector<unsigned char> PillowFaces; // of each hex, a bit a local face
  std::vector<std::array<int, 2>> Copies; // of each node, by digit - 1
  int NodesBefore;
};

/// Outer faces of the hexes of each slab.
void AxisPillow::FindPillowFaces()
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
  for (std::size_t h = 0; h < this->Mesh.Hexes.size(); ++h)
  {
    for (int f = 0; this->Inside[h] && f < 6; ++f)
    {
      Side side{ {}, this->SlabOf(h), h, f };
      int n = 0;
      for (int c = 0; c < 8; ++c)
      {
        if (FaceAt(c, f / 2) == f)
        {
          side.Nodes[n++] = this->Mesh.Hexes[h].Nodes[c];
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
    if (!shared && this->MayPillow(sides[s].Hex, sides[s].Face))
    {
      this->PillowFaces[sides[s].Hex] |= 1 << sides[s].Face;
    }
  }
}

/// Faces on the domain boundary are pillowed at the end of a slab only.
bool AxisPillow::MayPillow(std::size_t hex, int face) const
{
  int sides = 63;
  for (int c = 0; c < 8; ++c)
  {
    if (FaceAt(c, face / 2) == face)
    {
      sides &= this->Mesh.Nodes[this->Mesh.Hexes[hex].Nodes[c]].Sides;
    }
  }
  const bool upperEnd = this->Sets.Lattice().Cells(this->Level, this->Axis) % 2 == 0;
  const int ends = (upperEnd ? 3 : 1) << (2 * this->Axis);
  return sides == 0 || (sides & ends);
}

void AxisPillow::CopyNodes()
{
  for (std::size_t h = 0; h < this->Inside.size(); ++h)
  {
    const Index slab = this->SlabOf(h);
    for (int at = 0; this->PillowFaces[h] && at < 24; ++at)
    {
      const int c = at / 3;
      const int node = this->Mesh.Hexes[h].Nodes[c];
      if (!this->IsPillowed(h, FaceAt(c, at % 3)) || this->CopyIn(node, slab) >= 0)
      {
        continue;
      }
      const int digit = this->DigitIn(node, slab);
      this->Copies[node][digit - 1] = static_cast<int>(this->Mesh.Nodes.size());
      PillowedLevel::Node copy = this->Mesh.Nodes[node];
      copy.Slot += digit * PowersOf3[this->Axis];
      if (copy.Base[this->Axis] % 2 == 0)
      {
        copy.Sides &= ~(3 << (2 * this->Axis));
      }
      this->Mesh.Nodes.push_back(copy);
    }
  }
}

/// An order of the nodes that does not depend on what else the mesh holds.
bool AxisPillow::ComesBefore(int a, int b) const
{
  const PillowedLevel::Node &n = this->Mesh.Nodes[a], &m = this->Mesh.Nodes[b];
  return std::tie(n.Base, n.Slot) < std::tie(m.Base, m.Slot);
}

/// By copy, direction and end, each once.
std::vector<AxisPillow::Spoke> AxisPillow::ListSpokes() const
{
  std::vector<Spoke> spokes;
  for (std::size_t h = 0; h < this->Inside.size(); ++h)
  {
    const std::array<int, 8>& nodes = this->Mesh.Hexes[h].Nodes;
    for (int at = 0; this->PillowFaces[h] && at < 24; ++at)
    {
      const int c = at / 3, face = FaceAt(c, at % 3);
      if (this->IsPillowed(h, face))
      {
        spokes.push_back({ this->CopyIn(nodes[c], this->SlabOf(h)), face, nodes[c ^ 1 << at % 3] });
      }
    }
  }
  std::sort(spokes.begin(), spokes.end(),
    [this](const Spoke& a, const Spoke& b)
    {
      return std::tie(a.Copy, a.Direction) != std::tie(b.Copy, b.Direction)
        ? std::tie(a.Copy, a.Direction) < std::tie(b.Copy, b.Direction)
        : this->ComesBefore(a.End, b.End);
    });
  spokes.erase(std::unique(spokes.begin(), spokes.end(),
                 [](const Spoke& a, const Spoke& b)
                 { return a.Copy == b.Copy && a.Direction == b.Direction && a.End == b.End; }),
    spokes.end());
  return spokes;
}

/// Of each copy, bit 6 f + g: a hex corner there has pillow faces in both local directions.
std::vector<std::uint64_t> AxisPillow::FindConvexPairs() const
{
  std::vector<std::uint64_t> pairs(this->Mesh.Nodes.size() - this->NodesBefore, 0);
  for (std::size_t h = 0; h < this->Inside.size(); ++h)
  {
    for (int at = 0; this->PillowFaces[h] && at < 72; ++at)
    {
      const int c = at / 9, f = FaceAt(c, at / 3 % 3), g = FaceAt(c, at % 3);
      if (this->IsPillowed(h, f) && this->IsPillowed(h, g))
      {
        const int copy = this->CopyIn(this->Mesh.Hexes[h].Nodes[c], this->SlabOf(h));
        pairs[copy - this->NodesBefore] |= std::uint64_t(1) << (6 * f + g);
      }
    }
  }
  return pairs;
}

void AxisPillow::PlaceCopies()
{
  const std::vector<Spoke> spokes = this->ListSpokes();
  const std::vector<std::uint64_t> convex = this->FindConvexPairs();
  for (std::size_t first = 0; first < spokes.size();)
  {
    const int copy = spokes[first].Copy;
    const std::uint64_t pairs = convex[copy - this->NodesBefore];
    Vector3 ends[6]{};
    int count[6]{};
    for (; first < spokes.size() && spokes[first].Copy == copy; ++first)
    {
      const Spoke& spoke = spokes[first];
      ends[spoke.Direction] = ends[spoke.Direction] + this->Mesh.Nodes[spoke.End].X;
      ++count[spoke.Direction];
    }
    PillowedLevel::Node& node = this->Mesh.Nodes[copy];
    const Vector3 start = node.X; // that of the original
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
        const bool stays = node.Sides >> (2 * a) & 3;
        node.X[a] += stays || !count[f] ? 0.0 : step * (mean[a] - start[a]);
      }
    }
  }
}

void AxisPillow::InsertHexes()
{
  for (std::size_t h = 0; h < this->Inside.size(); ++h)
  {
    if (!this->Inside[h])
    {
      continue;
    }
    const Index slab = this->SlabOf(h);
    const PillowedLevel::Hex old = this->Mesh.Hexes[h];
    std::array<int, 8> inner = old.Nodes;
    for (int& node : inner)
    {
      const int copy = this->CopyIn(node, slab);
      node = copy >= 0 ? copy : node;
    }
    for (int f = 0; f < 6; ++f)
    {
      if (!this->IsPillowed(h, f))
      {
        continue;
      }
      PillowedLevel::Hex made = old;
      made.Slot += (1 + f) * PowersOf7[this->Axis];
      for (int c = 0; c < 8; ++c)
      {
        if (FaceAt(c, f / 2) != f)
        {
          made.Nodes[c] = inner[c ^ 1 << f / 2];
        }
      }
      this->Mesh.Hexes.push_back(made);
    }
    this->Mesh.Hexes[h].Nodes = inner;
  }
}

/// The touched cells of a box, ascending by key of their hexes.
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

/// A hex a cell.
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
    mesh.Nodes.push_back(
      { node, 0, lattice.DomainSides(level, node), std::ldexp(1.0, -level) * x });
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
    AxisPillow(sets, level, axis, slabs, mesh).Run();
  }
  return mesh;
}

} // namespace vfm
