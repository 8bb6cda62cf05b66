#include "Elements/Tet/LatticeTopology.h"

#include "Elements/Tet/BlockPoints.h"
#include "Elements/Tet/LatticeFaults.h"
#include "Elements/Tet/LatticeRules.h"
#include "Elements/Tet/LatticeStencils.h"

#include <atomic>
#include <utility>

namespace vfm
{
namespace
{

/// Row of blocks along x.
struct Row
{
  Row(Index j, Index k) : J(j), K(k) {}
  Index J, K;
  Index Tets = 0; // number of tets, later index of the first
};

/// Shape of a lattice tet on this grid, relative to its block.
struct PlacedShape
{
  std::array<const int*, 4> Labels; // label of each node, indexed by the tet's block
  std::array<Index, 16> Block;      // linear offset of the block of each set's point
  std::array<Index, 16> Key;        // the same offset in node keys
  std::array<int, 16> Slot;
};

/// Lattice of a grid, from which the tets of blocks are found.
struct PlacedLattice
{
  const CartesianGrid& Grid;
  const LatticeNodes& Nodes;
  const NarrowVoid& Narrow;
  const RefinedGrid& Levels;
  bool MeshVoid;
  IndexBox Box; ///< CartesianGrid::HexBox
  std::array<PlacedShape, LatticeTables::Shapes> Shapes;
};

/// Slots in use of each block.
using BlockSlots =
  std::vector<std::atomic<std::uint64_t>, LargeAllocator<std::atomic<std::uint64_t>>>;

/// Points of blocks: one for each slot in use, in the order of slots.
struct BlockPoints
{
  const BlockSlots& Slots;
  std::vector<int, LargeAllocator<int>> First; ///< first point of each block

  explicit BlockPoints(const BlockSlots& slots) : Slots(slots), First(slots.size()) {}
  /// Returns the point in a slot of a block.
  Index At(Index block, int slot) const
  {
    const std::uint64_t below =
      this->Slots[block].load(std::memory_order_relaxed) & ((std::uint64_t(1) << slot) - 1);
    return this->First[block] + CountBits(below);
  }
};

template <class Body>
void OverRows(Runtime& runtime, std::vector<Row>& rows, const Body& body)
{
  ForEach(runtime, rows.size(), [&](Index row) { body(rows[row]); });
}

/// Returns whether both cells at a face are fine. Beyond the domain, it is the cell inside.
bool IsFineFace(const RefinedGrid& levels, const Index3& block, int axis)
{
  Index3 below = block;
  --below[axis];
  return levels.IsFine(block) && levels.IsFine(below);
}

bool HasFineFaces(const RefinedGrid& levels, const Index3& block)
{
  return levels.IsUniform() ||
    (IsFineFace(levels, block, 0) && IsFineFace(levels, block, 1) && IsFineFace(levels, block, 2));
}

/// Returns whether all lattice tets at a block's three faces exist and have one label.
bool IsUniform(const PlacedLattice& lattice, Index n, const Index3& block)
{
  const int* vertices = lattice.Nodes.Labels(LatticeNodes::Vertex) + n;
  const int* centres = lattice.Nodes.Labels(LatticeNodes::Centre) + n;
  const int label = *centres;
  int differs = label < 0;
  for (int c = 0; c < 8; ++c)
  {
    differs |= vertices[lattice.Grid.CornerOffset(c)] ^ label;
  }
  for (int a = 0; a < 3; ++a)
  {
    differs |= (centres[-lattice.Grid.Stride(a)] ^ label) | (block[a] == lattice.Box.Lower[a]) |
      (block[a] == lattice.Box.Upper[a]);
  }
  differs |= lattice.Grid.FlatSeams(block);
  return !differs && HasFineFaces(lattice.Levels, block);
}

/// Marks slots of a block as used. Threads that process other rows may do so at the same time.
void Mark(BlockSlots& used, Index block, std::uint64_t slots)
{
  if (slots & ~used[block].load(std::memory_order_relaxed))
  {
    used[block].fetch_or(slots, std::memory_order_relaxed);
  }
}

/// Marks the points that coarse tets share with fine cells. At the rim, they may have no other tets
/// on this rank.
void MarkNextToCoarse(const PlacedLattice& lattice, const Row& row, BlockSlots& used)
{
  Index3 p{ { lattice.Box.Lower[0], row.J, row.K } };
  Index n = lattice.Grid.Linear(p);
  for (; p[0] <= lattice.Box.Upper[0]; ++p[0], ++n)
  {
    if (lattice.Levels.IsFineAround(p) || !lattice.Levels.TouchesFine(p) ||
      !IsMeshed(lattice.Nodes.Labels(LatticeNodes::Vertex)[n], lattice.MeshVoid))
    {
      continue;
    }
    Mark(used, n, 1);
    for (int c = 0; c < 8; ++c)
    {
      const Index3 cell = CellOfStar(p, c);
      if (lattice.Box.Contains(cell) && lattice.Levels.IsFine(cell))
      {
        Mark(used, lattice.Grid.Linear(cell), 2);
      }
    }
  }
}

/// Returns how much the angle of a face on the domain boundary opens at a corner, when the
/// interfaces on this side of the domain become smooth: 2 if the face is the only one with its
/// label around the corner, -2 if there are three of four.
/// @param cell  cell of the face
/// @param corner  corner of the face, as a corner of the cell
int OpeningOf(
  const CartesianGrid& grid, const LabelArray& cells, const Index3& cell, int axis, int corner)
{
  const int label = cells[grid.Linear(cell)];
  int around = 0, equal = 0;
  for (int c = 0; c < 4; ++c)
  {
    Index3 other = cell;
    for (int side = 0; side < 2; ++side)
    {
      const int a = (axis + 1 + side) % 3;
      other[a] += c >> side & 1 ? (corner >> a & 1 ? 1 : -1) : 0;
    }
    const bool isInside = grid.InDomain(other);
    around += isInside;
    equal += isInside && cells[grid.Linear(other)] == label;
  }
  return equal == around ? 0 : 4 - 2 * equal - (4 - around) / 2;
}

/// Returns the diagonal of a face on the domain boundary or a flat seam. If three of its corners
/// are snapped, it begins at the fourth, so that no triangle has all its corners on a curve. Else
/// it divides the angles that open, so that they can become straight. Such faces have no cuts,
/// because only pure vertices have labels there.
int DiagonalOf(const CartesianGrid& grid, const LatticeNodes& nodes, const Index3& block, int axis)
{
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const int around[4] = { 0, u, u | v, v };
  const int* vertices = nodes.Labels(LatticeNodes::Vertex) + grid.Linear(block);
  Index3 below = block;
  --below[axis];
  int free = 0, last = 0, openings[2] = { 0, 0 };
  for (int q = 0; q < 4; ++q)
  {
    const bool isFree = vertices[grid.CornerOffset(around[q])] != LatticeNodes::Snapped;
    free += isFree;
    last = isFree ? q : last;
    for (const Index3& cell : { below, block })
    {
      const bool counts = !isFree && grid.InDomain(cell);
      openings[q & 1] += counts ? OpeningOf(grid, nodes.Cells(), cell, axis, around[q]) : 0;
    }
  }
  return free == 1               ? last & 1
    : openings[0] == openings[1] ? LatticeTables::Diagonal(grid.Canonical(block))
                                 : openings[1] > openings[0];
}

/// Lattice tets of a face.
struct FaceTets
{
  int Count = 0; ///< 4 inside the domain, 2 on its boundary, 0 outside the box
  /// First shape of tets 0 and 1, and of tets 2 and 3. On a flat seam, these are the halves of the
  /// cells below and above, as on the boundary of the domain.
  std::array<int, 2> First{};
  int ShapeOf(int tet) const { return this->First[tet / 2] + tet % 2; }
};

FaceTets TetsOfFace(const PlacedLattice& lattice, const Index3& block, int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const bool isFace = block[u] < lattice.Box.Upper[u] && block[v] < lattice.Box.Upper[v] &&
    IsFineFace(lattice.Levels, block, axis);
  const bool atLower = block[axis] == 0, atUpper = block[axis] == lattice.Grid.Global().Upper[axis];
  if (atLower || atUpper)
  {
    const int diagonal = isFace ? DiagonalOf(lattice.Grid, lattice.Nodes, block, axis) : 0;
    return { isFace ? 2 : 0, { { LatticeTables::DomainShape(axis, atUpper, diagonal), 0 } } };
  }
  const bool isInside =
    block[axis] > lattice.Box.Lower[axis] && block[axis] < lattice.Box.Upper[axis];
  const int count = isFace && isInside ? 4 : 0;
  if (count > 0 && lattice.Grid.IsOnFlatSeam(block, axis))
  {
    const int diagonal = DiagonalOf(lattice.Grid, lattice.Nodes, block, axis);
    return { count,
      { { LatticeTables::DomainShape(axis, 1, diagonal),
        LatticeTables::DomainShape(axis, 0, diagonal) } } };
  }
  const int first = LatticeTables::InnerShape(axis);
  return { count, { { first, first + 2 } } };
}

/// Returns whether a face has a corner at a narrow void cell.
bool TouchesNarrow(const CartesianGrid& grid, const NarrowVoid& narrow, Index n, int axis)
{
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  return narrow.Touches(n) || narrow.Touches(n + grid.CornerOffset(u)) ||
    narrow.Touches(n + grid.CornerOffset(v)) || narrow.Touches(n + grid.CornerOffset(u | v));
}

/// Returns whether pieces of void in the lattice tets of a face are made.
bool HasVoid(const PlacedLattice& lattice, Index n, int axis)
{
  return lattice.MeshVoid ||
    (!lattice.Narrow.IsEmpty() && TouchesNarrow(lattice.Grid, lattice.Narrow, n, axis));
}

/// Calls whole(block, n) for a block if all its tets have one label, which is meshed. Else calls
/// cut(block, n, shape, t, labels, hasVoid) for every lattice tet of the block that may have
/// pieces; hasVoid says whether pieces of void are made.
template <class Whole, class Cut>
void OverTets(const PlacedLattice& lattice, const Row& row, const Whole& whole, const Cut& cut)
{
  const int* centres = lattice.Nodes.Labels(LatticeNodes::Centre);
  Index3 block{ { lattice.Box.Lower[0], row.J, row.K } };
  Index n = lattice.Grid.Linear(block);
  for (; block[0] <= lattice.Box.Upper[0]; ++block[0], ++n)
  {
    const bool isUniform = IsUniform(lattice, n, block);
    if (isUniform && IsMeshed(centres[n], lattice.MeshVoid))
    {
      whole(block, n);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const FaceTets face = TetsOfFace(lattice, block, axis);
      const bool hasVoid = face.Count > 0 && HasVoid(lattice, n, axis);
      for (int t = 0; t < face.Count && (hasVoid || !isUniform); ++t)
      {
        const PlacedShape& shape = lattice.Shapes[face.ShapeOf(t)];
        cut(block, n, face.ShapeOf(t), 4 * axis + t,
          std::array<int, 4>{
            { shape.Labels[0][n], shape.Labels[1][n], shape.Labels[2][n], shape.Labels[3][n] } },
          hasVoid);
      }
    }
  }
}

void MarkSets(const PlacedShape& shape, Index n, std::uint32_t sets, BlockSlots& used)
{
  for (int set = 1; set < 16; ++set)
  {
    if (sets >> set & 1)
    {
      Mark(used, n + shape.Block[set], std::uint64_t(1) << shape.Slot[set]);
    }
  }
}

/// Returns the number of tets in a lattice tet, and marks their points.
/// @param labels  label of each node
Index CountTet(const LatticeStencil& stencil, const PlacedShape& shape, Index n,
  const std::array<int, 4>& labels, bool hasVoid, BlockSlots& used)
{
  Index count = 0;
  for (int r = 0; r < stencil.Count; ++r)
  {
    const LatticeStencil::Region& region = stencil.List[r];
    if (IsMeshed(labels[region.Node], hasVoid))
    {
      count += region.Last - region.First;
      MarkSets(shape, n, region.Points, used);
    }
  }
  return count;
}

/// Counts the tets of a row and marks their points.
void Count(const PlacedLattice& lattice, Row& row, BlockSlots& used)
{
  const LatticeTables& tables = LatticeTables::Get();
  OverTets(
    lattice, row,
    [&](const Index3&, Index n)
    {
      row.Tets += 12;
      for (int c = 0; c < 8; ++c)
      {
        Mark(used, n + lattice.Grid.CornerOffset(c), 1);
      }
      Mark(used, n, 2);
      for (int a = 0; a < 3; ++a)
      {
        Mark(used, n - lattice.Grid.Stride(a), 2);
      }
    },
    [&](const Index3&, Index n, int shape, int, const std::array<int, 4>& labels, bool hasVoid)
    {
      row.Tets +=
        CountTet(tables.Stencil(shape, labels), lattice.Shapes[shape], n, labels, hasVoid, used);
    });
}

PointPosition PositionOf(
  const CartesianGrid& grid, const LatticeNodes& nodes, const Index3& block, Index n, int slot)
{
  if (slot > 1 || nodes.Labels(LatticeNodes::Kind(slot))[n] == LatticeNodes::Snapped)
  {
    return PointPosition::OnInterface;
  }
  return slot == LatticeNodes::Vertex && grid.DomainSides(block) != 0 ? PointPosition::OnDomain
                                                                      : PointPosition::Inside;
}

/// Makes the 12 tets of a block with one label.
/// @param tet,id  index and id of the first
void FillUniform(const CartesianGrid& grid, const BlockPoints& points, Index n, Index tet, Index id,
  int label, Mesh& mesh)
{
  Index vertices[8];
  for (int c = 0; c < 8; ++c)
  {
    vertices[c] = points.First[n + grid.CornerOffset(c)];
  }
  const Index centre = points.At(n, 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    const Index below = points.At(n - grid.Stride(axis), 1);
    const Index corners[5] = { vertices[0], vertices[u], vertices[u | v], vertices[v],
      vertices[0] };
    for (int t = 0; t < 4; ++t)
    {
      mesh.SetElement(tet++, std::array<Index, 4>{ { below, corners[t], corners[t + 1], centre } },
        id + (4 * axis + t) * PiecesPerTet, label);
    }
  }
}

/// Returns the regions of a stencil in the order of their labels.
std::array<int, 4> OrderRegions(const LatticeStencil& stencil, const std::array<int, 4>& labels)
{
  const auto labelOf = [&](int r) { return labels[stencil.List[r].Node]; };
  std::array<int, 4> order{ { 0, 1, 2, 3 } };
  for (int r = 1; r < stencil.Count; ++r)
  {
    for (int q = r; q > 0 && labelOf(order[q]) < labelOf(order[q - 1]); --q)
    {
      std::swap(order[q], order[q - 1]);
    }
  }
  return order;
}

/// Lattice tet that is cut into pieces.
struct CutTet
{
  const LatticeStencil& Stencil;
  const PlacedShape& Shape;
  const std::array<int, 4>& Labels; ///< label of each node
  bool HasVoid;                     ///< whether pieces of void are made
};

/// Makes the pieces of a lattice tet, with regions in the order of labels.
/// @param n  block of the tet
/// @param id  id of its first piece
/// @param[in,out] tet  index of the next piece
void FillCut(
  const CutTet& cut, const BlockPoints& blockPoints, Index n, Index id, Index& tet, Mesh& mesh)
{
  const LatticeStencil& stencil = cut.Stencil;
  const std::array<int, 4> order = OrderRegions(stencil, cut.Labels);
  for (int r = 0; r < stencil.Count; ++r)
  {
    const LatticeStencil::Region& region = stencil.List[order[r]];
    const int label = cut.Labels[region.Node];
    for (int piece = region.First; piece < region.Last; ++piece, ++id)
    {
      if (IsMeshed(label, cut.HasVoid))
      {
        std::array<Index, 4> points;
        for (int i = 0; i < 4; ++i)
        {
          const int set = stencil.Tets[piece][i];
          points[i] = blockPoints.At(n + cut.Shape.Block[set], cut.Shape.Slot[set]);
        }
        mesh.SetElement(tet++, points, id, label);
      }
    }
  }
}

void FillTets(const PlacedLattice& lattice, const BlockPoints& points, const Row& row, Mesh& mesh)
{
  const LatticeTables& tables = LatticeTables::Get();
  const int* centres = lattice.Nodes.Labels(LatticeNodes::Centre);
  const auto idOf = [&](const Index3& block, int slot)
  { return lattice.Grid.NodeKey(block) * TetIds.ElementSlots + slot * PiecesPerTet + 1; };
  Index tet = row.Tets;
  OverTets(
    lattice, row,
    [&](const Index3& block, Index n)
    {
      FillUniform(lattice.Grid, points, n, tet, idOf(block, 0), centres[n], mesh);
      tet += 12;
    },
    [&](const Index3& block, Index n, int shape, int slot, const std::array<int, 4>& labels,
      bool hasVoid)
    {
      const CutTet cut{ tables.Stencil(shape, labels), lattice.Shapes[shape], labels, hasVoid };
      FillCut(cut, points, n, idOf(block, slot), tet, mesh);
    });
}

/// Replaces the number of tets of each row by the index of its first; returns the sum.
Index MakeOffsets(std::vector<Row>& rows)
{
  Index total = 0;
  for (Row& row : rows)
  {
    row.Tets = std::exchange(total, total + row.Tets);
  }
  return total;
}

std::array<PlacedShape, LatticeTables::Shapes> PlaceShapes(
  const CartesianGrid& grid, const LatticeNodes& nodes)
{
  const Index3& n = grid.Global().Upper;
  std::array<PlacedShape, LatticeTables::Shapes> shapes{};
  for (int s = 0; s < LatticeTables::Shapes; ++s)
  {
    const LatticeTet& tet = LatticeTables::Get().Shape(s);
    PlacedShape& shape = shapes[s];
    shape.Slot = tet.Slot;
    for (int set = 1; set < 16; ++set)
    {
      const HalfPoint& b = tet.Block[set];
      shape.Block[set] = b[0] + b[1] * grid.Stride(1) + b[2] * grid.Stride(2);
      shape.Key[set] = b[0] + (n[0] + 1) * (b[1] + (n[1] + 1) * b[2]);
    }
    for (int i = 0; i < 4; ++i)
    {
      shape.Labels[i] = nodes.Labels(LatticeNodes::Kind(tet.Slot[1 << i])) + shape.Block[1 << i];
    }
  }
  return shapes;
}

TetTopology BuildTets(const CartesianGrid& grid, const LatticeNodes& nodes, bool meshVoid,
  const NarrowVoid& narrow, Runtime& runtime, const CoarseTets& coarse)
{
  const PlacedLattice lattice{ grid, nodes, narrow, coarse.Levels(), meshVoid, grid.HexBox(),
    PlaceShapes(grid, nodes) };
  std::vector<Row> rows;
  ForRows(NodesOf(lattice.Box), [&](Index j, Index k) { rows.emplace_back(j, k); });
  BlockSlots used(grid.NumberOfEntries());
  if (!lattice.Levels.IsUniform())
  {
    OverRows(runtime, rows, [&](Row& row) { MarkNextToCoarse(lattice, row, used); });
  }
  OverRows(runtime, rows, [&](Row& row) { Count(lattice, row, used); });
  BlockPoints points(used);
  TetTopology result;
  const Index finePoints = MakeBlockPoints(
    grid, coarse, runtime,
    [&](const Index3&, Index n) { return used[n].load(std::memory_order_relaxed); },
    [&](const Index3& block, Index n, int slot) { return PositionOf(grid, nodes, block, n, slot); },
    points.First, result);
  const Index fineTets = MakeOffsets(rows);
  result.Tets.ResizeElements(fineTets + coarse.NumberOfTets());
  OverRows(runtime, rows, [&](Row& row) { FillTets(lattice, points, row, result.Tets); });
  coarse.Fill(result, finePoints, fineTets,
    [&](Index block, Index slot) { return points.At(block, static_cast<int>(slot)); });
  result.Barrier = { !narrow.IsEmpty() };
  return result;
}

} // namespace

/// The loop terminates: every round settles a node that was not settled, and no node is ever
/// unsettled.
LatticeTets BuildLatticeTets(const CartesianGrid& grid, LatticeNodes& nodes, bool meshVoid,
  const NarrowVoid& narrow, const Partition& partition, Runtime& runtime, const CoarseTets& coarse)
{
  CheckIds(grid, TetIds.ElementSlots);
  SettleBridges(nodes, grid, partition, runtime);
  LatticeTets tets;
  bool isFaulty = true;
  while (isFaulty)
  {
    SettleCentres(nodes, grid, partition, runtime);
    tets.Topology = BuildTets(grid, nodes, meshVoid, narrow, runtime, coarse);
    tets.Faces =
      FindTetFaces(tets.Topology.Tets, tets.Topology.Positions, tets.Topology.Barrier, grid);
    isFaulty =
      nodes.Settle(FindLatticeFaults(tets.Topology, tets.Faces, nodes, grid, partition), partition);
  }
  return tets;
}

std::vector<Index> FindLatticeInterfaces(const CartesianGrid& grid, const LatticeNodes& nodes)
{
  const int* vertices = nodes.Labels(LatticeNodes::Vertex);
  const int* centres = nodes.Labels(LatticeNodes::Centre);
  const IndexBox box = grid.HexBox();
  std::vector<Index> found;
  ForCells(NodesOf(box),
    [&](const Index3& p)
    {
      const Index n = grid.Linear(p);
      bool differs = vertices[n] == LatticeNodes::Snapped;
      for (int c = 0; c < 8; ++c)
      {
        differs = differs ||
          (box.Contains(CellOfStar(p, c)) && centres[grid.CellOfNode(n, c)] != vertices[n]);
      }
      if (differs)
      {
        found.push_back(n);
      }
    });
  return found;
}

} // namespace vfm
