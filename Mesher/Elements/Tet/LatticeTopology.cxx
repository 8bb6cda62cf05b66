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

struct Work
{
  const CartesianGrid& Grid;
  const LatticeNodes& Nodes;
  bool MeshVoid;
  const NarrowVoid& Narrow;
  Runtime& Run;
  const CoarseTets& Coarse;
  const IndexBox Box = Grid.HexBox();
  const RefinedGrid& Levels = Coarse.Levels();
  const LatticeTables& Tables = LatticeTables::Get();
  std::array<PlacedShape, LatticeTables::Shapes> Shapes{};
  std::vector<Row> Rows{};
  // Slots in use and first point of each block.
  std::vector<std::atomic<std::uint64_t>, LargeAllocator<std::atomic<std::uint64_t>>> Slots =
    decltype(Slots)(Grid.NumberOfEntries());
  std::vector<int, LargeAllocator<int>> FirstPoint = decltype(FirstPoint)(Grid.NumberOfEntries());
  Index FinePoints = 0;
  TetTopology Result{};
};

template <class Body>
void OverRows(Work& work, const Body& body)
{
  ForEach(work.Run, work.Rows.size(), [&](Index row) { body(work.Rows[row]); });
}

/// Returns whether both cells at a face are fine. Beyond the domain, it is the cell inside.
bool IsFineFace(const Work& work, const Index3& block, int axis)
{
  Index3 below = block;
  --below[axis];
  return work.Levels.IsFine(block) && work.Levels.IsFine(below);
}

bool HasFineFaces(const Work& work, const Index3& block)
{
  return work.Levels.IsUniform() ||
    (IsFineFace(work, block, 0) && IsFineFace(work, block, 1) && IsFineFace(work, block, 2));
}

/// Returns whether all lattice tets at a block's three faces exist and have one label.
bool IsUniform(const Work& work, Index n, const Index3& block)
{
  const int* vertices = work.Nodes.Labels(LatticeNodes::Vertex) + n;
  const int* centres = work.Nodes.Labels(LatticeNodes::Centre) + n;
  const int label = *centres;
  int differs = label < 0;
  for (int c = 0; c < 8; ++c)
  {
    differs |= vertices[work.Grid.CornerOffset(c)] ^ label;
  }
  for (int a = 0; a < 3; ++a)
  {
    differs |= (centres[-work.Grid.Stride(a)] ^ label) | (block[a] == work.Box.Lower[a]) |
      (block[a] == work.Box.Upper[a]);
  }
  differs |= work.Grid.FlatSeams(block);
  return !differs && HasFineFaces(work, block);
}

/// Marks slots of a block as used. Threads that process other rows may do so at the same time.
void Mark(Work& work, Index block, std::uint64_t slots)
{
  if (slots & ~work.Slots[block].load(std::memory_order_relaxed))
  {
    work.Slots[block].fetch_or(slots, std::memory_order_relaxed);
  }
}

/// Marks the points that coarse tets share with fine cells. At the rim, they may have no other tets
/// on this rank.
void MarkNextToCoarse(Work& work, const Row& row)
{
  Index3 p{ { work.Box.Lower[0], row.J, row.K } };
  Index n = work.Grid.Linear(p);
  for (; p[0] <= work.Box.Upper[0]; ++p[0], ++n)
  {
    if (work.Levels.IsFineAround(p) || !work.Levels.TouchesFine(p) ||
      !IsMeshed(work.Nodes.Labels(LatticeNodes::Vertex)[n], work.MeshVoid))
    {
      continue;
    }
    Mark(work, n, 1);
    for (int c = 0; c < 8; ++c)
    {
      const Index3 cell = CellOfStar(p, c);
      if (work.Box.Contains(cell) && work.Levels.IsFine(cell))
      {
        Mark(work, work.Grid.Linear(cell), 2);
      }
    }
  }
}

/// Returns how much the angle of a face on the domain boundary opens at a corner, when the
/// interfaces on this side of the domain become smooth: 2 if the face is the only one with its
/// label around the corner, -2 if there are three of four.
/// @param cell  cell of the face
/// @param corner  corner of the face, as a corner of the cell
int OpeningOf(const Work& work, const Index3& cell, int axis, int corner)
{
  const LabelArray& cells = work.Nodes.Cells();
  const int label = cells[work.Grid.Linear(cell)];
  int around = 0, equal = 0;
  for (int c = 0; c < 4; ++c)
  {
    Index3 other = cell;
    for (int side = 0; side < 2; ++side)
    {
      const int a = (axis + 1 + side) % 3;
      other[a] += c >> side & 1 ? (corner >> a & 1 ? 1 : -1) : 0;
    }
    const bool isInside = work.Grid.InDomain(other);
    around += isInside;
    equal += isInside && cells[work.Grid.Linear(other)] == label;
  }
  return equal == around ? 0 : 4 - 2 * equal - (4 - around) / 2;
}

/// Returns the diagonal of a face on the domain boundary or a flat seam. If three of its corners
/// are snapped, it begins at the fourth, so that no triangle has all its corners on a curve. Else
/// it divides the angles that open, so that they can become straight. Such faces have no cuts,
/// because only pure vertices have labels there.
int DiagonalOf(const Work& work, const Index3& block, int axis)
{
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const int around[4] = { 0, u, u | v, v };
  const int* vertices = work.Nodes.Labels(LatticeNodes::Vertex) + work.Grid.Linear(block);
  Index3 below = block;
  --below[axis];
  int free = 0, last = 0, openings[2] = { 0, 0 };
  for (int q = 0; q < 4; ++q)
  {
    const bool isFree = vertices[work.Grid.CornerOffset(around[q])] != LatticeNodes::Snapped;
    free += isFree;
    last = isFree ? q : last;
    for (const Index3& cell : { below, block })
    {
      const bool counts = !isFree && work.Grid.InDomain(cell);
      openings[q & 1] += counts ? OpeningOf(work, cell, axis, around[q]) : 0;
    }
  }
  return free == 1               ? last & 1
    : openings[0] == openings[1] ? LatticeTables::Diagonal(work.Grid.Canonical(block))
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

FaceTets TetsOfFace(const Work& work, const Index3& block, int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const bool isFace =
    block[u] < work.Box.Upper[u] && block[v] < work.Box.Upper[v] && IsFineFace(work, block, axis);
  const bool atLower = block[axis] == 0, atUpper = block[axis] == work.Grid.Global().Upper[axis];
  if (atLower || atUpper)
  {
    const int diagonal = isFace ? DiagonalOf(work, block, axis) : 0;
    return { isFace ? 2 : 0, { { LatticeTables::DomainShape(axis, atUpper, diagonal), 0 } } };
  }
  const bool isInside = block[axis] > work.Box.Lower[axis] && block[axis] < work.Box.Upper[axis];
  const int count = isFace && isInside ? 4 : 0;
  if (count > 0 && work.Grid.IsOnFlatSeam(block, axis))
  {
    const int diagonal = DiagonalOf(work, block, axis);
    return { count,
      { { LatticeTables::DomainShape(axis, 1, diagonal),
        LatticeTables::DomainShape(axis, 0, diagonal) } } };
  }
  const int first = LatticeTables::InnerShape(axis);
  return { count, { { first, first + 2 } } };
}

/// Returns whether a face has a corner at a narrow void cell.
bool TouchesNarrow(const Work& work, Index n, int axis)
{
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  return work.Narrow.Touches(n) || work.Narrow.Touches(n + work.Grid.CornerOffset(u)) ||
    work.Narrow.Touches(n + work.Grid.CornerOffset(v)) ||
    work.Narrow.Touches(n + work.Grid.CornerOffset(u | v));
}

/// Returns whether pieces of void in the lattice tets of a face are made.
bool HasVoid(const Work& work, Index n, int axis)
{
  return work.MeshVoid || (!work.Narrow.IsEmpty() && TouchesNarrow(work, n, axis));
}

/// Calls whole(block, n) for a block if all its tets have one label, which is meshed. Else calls
/// cut(block, n, shape, t, labels, hasVoid) for every lattice tet of the block that may have
/// pieces; hasVoid says whether pieces of void are made.
template <class Whole, class Cut>
void OverTets(const Work& work, const Row& row, const Whole& whole, const Cut& cut)
{
  const int* centres = work.Nodes.Labels(LatticeNodes::Centre);
  Index3 block{ { work.Box.Lower[0], row.J, row.K } };
  Index n = work.Grid.Linear(block);
  for (; block[0] <= work.Box.Upper[0]; ++block[0], ++n)
  {
    const bool isUniform = IsUniform(work, n, block);
    if (isUniform && IsMeshed(centres[n], work.MeshVoid))
    {
      whole(block, n);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const FaceTets face = TetsOfFace(work, block, axis);
      const bool hasVoid = face.Count > 0 && HasVoid(work, n, axis);
      for (int t = 0; t < face.Count && (hasVoid || !isUniform); ++t)
      {
        const PlacedShape& shape = work.Shapes[face.ShapeOf(t)];
        cut(block, n, face.ShapeOf(t), 4 * axis + t,
          std::array<int, 4>{
            { shape.Labels[0][n], shape.Labels[1][n], shape.Labels[2][n], shape.Labels[3][n] } },
          hasVoid);
      }
    }
  }
}

void MarkSets(Work& work, const PlacedShape& shape, Index n, std::uint32_t sets)
{
  for (int set = 1; set < 16; ++set)
  {
    if (sets >> set & 1)
    {
      Mark(work, n + shape.Block[set], std::uint64_t(1) << shape.Slot[set]);
    }
  }
}

void CountTet(
  Work& work, Row& row, Index n, int shape, const std::array<int, 4>& labels, bool hasVoid)
{
  const LatticeStencil& stencil = work.Tables.Stencil(shape, labels);
  for (int r = 0; r < stencil.Count; ++r)
  {
    const LatticeStencil::Region& region = stencil.List[r];
    if (IsMeshed(labels[region.Node], hasVoid))
    {
      row.Tets += region.Last - region.First;
      MarkSets(work, work.Shapes[shape], n, region.Points);
    }
  }
}

void Count(Work& work, Row& row)
{
  OverTets(
    work, row,
    [&](const Index3&, Index n)
    {
      row.Tets += 12;
      for (int c = 0; c < 8; ++c)
      {
        Mark(work, n + work.Grid.CornerOffset(c), 1);
      }
      Mark(work, n, 2);
      for (int a = 0; a < 3; ++a)
      {
        Mark(work, n - work.Grid.Stride(a), 2);
      }
    },
    [&](const Index3&, Index n, int shape, int, const std::array<int, 4>& labels, bool hasVoid)
    { CountTet(work, row, n, shape, labels, hasVoid); });
}

PointPosition PositionOf(const Work& work, const Index3& block, Index n, int slot)
{
  if (slot > 1 || work.Nodes.Labels(LatticeNodes::Kind(slot))[n] == LatticeNodes::Snapped)
  {
    return PointPosition::OnInterface;
  }
  return slot == LatticeNodes::Vertex && work.Grid.DomainSides(block) != 0 ? PointPosition::OnDomain
                                                                           : PointPosition::Inside;
}

/// Returns the point in a slot of a block.
Index PointAt(const Work& work, Index block, int slot)
{
  const std::uint64_t below =
    work.Slots[block].load(std::memory_order_relaxed) & ((std::uint64_t(1) << slot) - 1);
  return work.FirstPoint[block] + CountBits(below);
}

/// Makes the 12 tets of a block with one label.
void FillUniform(Work& work, Index tet, Index n, Index id, int label)
{
  Index vertices[8];
  for (int c = 0; c < 8; ++c)
  {
    vertices[c] = work.FirstPoint[n + work.Grid.CornerOffset(c)];
  }
  const Index centre = PointAt(work, n, 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    const Index below = PointAt(work, n - work.Grid.Stride(axis), 1);
    const Index corners[5] = { vertices[0], vertices[u], vertices[u | v], vertices[v],
      vertices[0] };
    for (int t = 0; t < 4; ++t)
    {
      work.Result.Tets.SetElement(tet++,
        std::array<Index, 4>{ { below, corners[t], corners[t + 1], centre } },
        id + (4 * axis + t) * PiecesPerTet, label);
    }
  }
}

/// Makes the pieces of a lattice tet, with regions in the order of labels.
void FillCut(Work& work, Index& tet, Index n, int shape, Index id, const std::array<int, 4>& labels,
  bool hasVoid)
{
  const LatticeStencil& stencil = work.Tables.Stencil(shape, labels);
  const PlacedShape& placed = work.Shapes[shape];
  const auto labelOf = [&](int r) { return labels[stencil.List[r].Node]; };
  std::array<int, 4> order{ { 0, 1, 2, 3 } };
  for (int r = 1; r < stencil.Count; ++r)
  {
    for (int q = r; q > 0 && labelOf(order[q]) < labelOf(order[q - 1]); --q)
    {
      std::swap(order[q], order[q - 1]);
    }
  }
  for (int r = 0; r < stencil.Count; ++r)
  {
    const LatticeStencil::Region& region = stencil.List[order[r]];
    const int label = labelOf(order[r]);
    for (int piece = region.First; piece < region.Last; ++piece, ++id)
    {
      if (IsMeshed(label, hasVoid))
      {
        std::array<Index, 4> points;
        for (int i = 0; i < 4; ++i)
        {
          const int set = stencil.Tets[piece][i];
          points[i] = PointAt(work, n + placed.Block[set], placed.Slot[set]);
        }
        work.Result.Tets.SetElement(tet++, points, id, label);
      }
    }
  }
}

void FillTets(Work& work, const Row& row)
{
  const int* centres = work.Nodes.Labels(LatticeNodes::Centre);
  Index tet = row.Tets;
  OverTets(
    work, row,
    [&](const Index3& block, Index n)
    {
      FillUniform(work, tet, n, work.Grid.NodeKey(block) * TetIds.ElementSlots + 1, centres[n]);
      tet += 12;
    },
    [&](const Index3& block, Index n, int shape, int slot, const std::array<int, 4>& labels,
      bool hasVoid)
    {
      const Index id = work.Grid.NodeKey(block) * TetIds.ElementSlots + slot * PiecesPerTet + 1;
      FillCut(work, tet, n, shape, id, labels, hasVoid);
    });
}

void MakeTets(Work& work)
{
  Index total = 0;
  for (Row& row : work.Rows)
  {
    row.Tets = std::exchange(total, total + row.Tets);
  }
  const Index fineTets = total;
  total += work.Coarse.NumberOfTets();
  work.Result.Tets.ResizeElements(total);
  OverRows(work, [&](Row& row) { FillTets(work, row); });
  work.Coarse.Fill(work.Result, work.FinePoints, fineTets,
    [&](Index block, Index slot) { return PointAt(work, block, static_cast<int>(slot)); });
}

void PlaceShapes(Work& work)
{
  const Index3& n = work.Grid.Global().Upper;
  for (int s = 0; s < LatticeTables::Shapes; ++s)
  {
    const LatticeTet& tet = work.Tables.Shape(s);
    PlacedShape& shape = work.Shapes[s];
    shape.Slot = tet.Slot;
    for (int set = 1; set < 16; ++set)
    {
      const HalfPoint& b = tet.Block[set];
      shape.Block[set] = b[0] + b[1] * work.Grid.Stride(1) + b[2] * work.Grid.Stride(2);
      shape.Key[set] = b[0] + (n[0] + 1) * (b[1] + (n[1] + 1) * b[2]);
    }
    for (int i = 0; i < 4; ++i)
    {
      shape.Labels[i] =
        work.Nodes.Labels(LatticeNodes::Kind(tet.Slot[1 << i])) + shape.Block[1 << i];
    }
  }
}

TetTopology BuildTets(const CartesianGrid& grid, const LatticeNodes& nodes, bool meshVoid,
  const NarrowVoid& narrow, Runtime& runtime, const CoarseTets& coarse)
{
  Work work{ grid, nodes, meshVoid, narrow, runtime, coarse };
  PlaceShapes(work);
  ForRows(NodesOf(work.Box), [&](Index j, Index k) { work.Rows.emplace_back(j, k); });
  if (!work.Levels.IsUniform())
  {
    OverRows(work, [&](Row& row) { MarkNextToCoarse(work, row); });
  }
  OverRows(work, [&](Row& row) { Count(work, row); });
  work.FinePoints = MakeBlockPoints(
    grid, coarse, runtime,
    [&](const Index3&, Index n) { return work.Slots[n].load(std::memory_order_relaxed); },
    [&](const Index3& block, Index n, int slot) { return PositionOf(work, block, n, slot); },
    work.FirstPoint, work.Result);
  MakeTets(work);
  work.Result.Tets.HasBarrier = !narrow.IsEmpty();
  return std::move(work.Result);
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
    tets.Faces = FindTetFaces(tets.Topology.Tets, tets.Topology.Positions, grid);
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
