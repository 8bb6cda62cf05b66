#include "Elements/Tet/CellTets.h"

#include "Elements/Tet/BlockPoints.h"
#include "Labels/InterfaceFaces.h"

#include <numeric>

namespace vfm
{
namespace
{

/// Face of the grid. The label outside the domain is -1.
struct Face : InterfaceFace
{
  Index3 Block;
};

struct Work
{
  const CartesianGrid& Grid;
  const LabelArray& Labels;
  bool MeshVoid;
  const NarrowVoid& Narrow;
  Runtime& Run;
  const CoarseTets& Coarse;
  const IndexBox Box = Grid.HexBox(), Nodes = NodesOf(Box);
  // First point of each block, and first tet of each row.
  Buffer<int> FirstPoint{ static_cast<std::size_t>(Grid.NumberOfEntries()), -1 };
  std::vector<Index> FirstTet{};
  TetTopology Result{};
};

/// Returns whether a cell has tets.
bool HasTets(const Work& work, Index cell, int label)
{
  return IsMeshed(label, work.MeshVoid) || (label == 0 && work.Narrow.Has(cell));
}
bool HasTets(const Work& work, Index cell)
{
  return HasTets(work, cell, work.Labels[cell]);
}

bool IsFine(const Work& work, const Index3& cell)
{
  return work.Coarse.Levels().IsFine(cell);
}

/// Returns the slots in use of a block, one bit per slot.
int SlotsOf(const Work& work, const Index3& p, Index node)
{
  const bool isCentre = work.Box.Contains(p) && HasTets(work, node) && IsFine(work, p);
  int slots = isCentre << CentreSlot;
  const bool isVertex = work.Coarse.Levels().TouchesFine(p);
  for (int c = 0; isVertex && c < 8; ++c)
  {
    const Index3 cell = CellOfStar(p, c);
    const bool hasTets = work.Box.Contains(cell) && HasTets(work, work.Grid.CellOfNode(node, c));
    slots |= hasTets << VertexSlot;
  }
  return slots;
}

template <class Body>
void OverBlocks(const Work& work, Index j, Index k, const Body& body)
{
  Index3 p{ { work.Box.Lower[0], j, k } };
  Index node = work.Grid.Linear(p);
  for (; p[0] <= work.Box.Upper[0]; ++p[0], ++node)
  {
    body(p, node);
  }
}

PointPosition PositionOf(const Work& work, const Index3& p, Index node)
{
  const std::array<int, 8> star = StarOfNode(work.Grid, work.Labels, node);
  const bool mixed =
    std::any_of(star.begin(), star.end(), [&](int label) { return label != star[0]; });
  return mixed ? PointPosition::OnInterface
               : (work.Grid.DomainSides(p) != 0 ? PointPosition::OnDomain : PointPosition::Inside);
}

/// Calls body(face) for the faces of a row of blocks whose cells are all fine and in the box, in
/// the order of ids.
template <class Body>
void OverFaces(const Work& work, Index j, Index k, const Body& body)
{
  OverBlocks(work, j, k,
    [&](const Index3& p, Index node)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        Index3 below = p;
        --below[axis];
        const bool inLower = below[axis] >= 0;
        const bool inUpper = p[axis] < work.Grid.Global().Upper[axis];
        if (p[u] < work.Box.Upper[u] && p[v] < work.Box.Upper[v] &&
          (!inLower || (work.Box.Contains(below) && IsFine(work, below))) &&
          (!inUpper || (work.Box.Contains(p) && IsFine(work, p))))
        {
          body(Face{ { node, axis, inLower ? work.Labels[node - work.Grid.Stride(axis)] : -1,
                       inUpper ? work.Labels[node] : -1 },
            p });
        }
      }
    });
}

Index LowerCell(const Work& work, const Face& face)
{
  return face.Node - work.Grid.Stride(face.Axis);
}

/// Returns whether the tets of a face surround the edge between the centres of its cells.
bool IsInner(const Work& work, const Face& face)
{
  return face.LowerLabel == face.UpperLabel && !work.Grid.IsOnFlatSeam(face.Block, face.Axis);
}

Index CountTets(Work& work)
{
  work.FirstTet.assign(work.Nodes.Size(1) * work.Nodes.Size(2) + 1, 0);
  ForRows(work.Run, work.Nodes,
    [&](Index j, Index k, Index row)
    {
      OverFaces(work, j, k,
        [&](const Face& face)
        {
          const bool lower = HasTets(work, LowerCell(work, face), face.LowerLabel);
          const bool upper = HasTets(work, face.Node, face.UpperLabel);
          const bool isInner = IsInner(work, face);
          work.FirstTet[row + 1] += isInner ? 4 * (lower && upper) : 2 * (lower + upper);
        });
    });
  std::partial_sum(work.FirstTet.begin(), work.FirstTet.end(), work.FirstTet.begin());
  return work.FirstTet.back();
}

Index Centre(const Work& work, Index cell)
{
  const Index first = work.FirstPoint[cell];
  return first + (SlotOfPoint(work.Result.Tets.PointIds[first]) == VertexSlot);
}

/// Returns the corners of a face, counterclockwise as seen from above.
std::array<Index, 4> CornersOf(const Work& work, const Face& face)
{
  std::array<Index, 4> corners = NodesOfFace(work.Grid, face);
  std::for_each(
    corners.begin(), corners.end(), [&](Index& corner) { corner = work.FirstPoint[corner]; });
  return corners;
}

void SetTet(
  Work& work, Index tet, const std::array<Index, 4>& points, const Face& face, int t, int label)
{
  work.Result.Tets.SetElement(tet, points,
    TetIds.ElementSlots * work.Grid.NodeKey(face.Block) + (4 * face.Axis + t) * PiecesPerTet + 1,
    label);
}

/// Makes the four tets around the edge between the centres.
void FillInnerFace(Work& work, const Face& face, Index& tet)
{
  if (!HasTets(work, LowerCell(work, face)) || !HasTets(work, face.Node))
  {
    return;
  }
  const std::array<Index, 4> q = CornersOf(work, face);
  const Index below = Centre(work, LowerCell(work, face));
  const Index above = Centre(work, face.Node);
  for (int t = 0; t < 4; ++t)
  {
    SetTet(work, tet++, { { below, above, q[t], q[(t + 1) % 4] } }, face, t, face.LowerLabel);
  }
}

/// Makes the two tets between the halves of a quad and the centre on one side. DiagonalFlips relies
/// on their order: they are consecutive, with the halves (q0 q1 q2) and (q0 q2 q3),
/// counterclockwise as seen from the centre.
void FillHalves(Work& work, const Face& face, bool isUpper, int firstPiece, Index& tet)
{
  const int label = isUpper ? face.UpperLabel : face.LowerLabel;
  const Index cell = isUpper ? face.Node : LowerCell(work, face);
  if (!HasTets(work, cell, label))
  {
    return;
  }
  std::array<Index, 4> q = CornersOf(work, face);
  std::rotate(
    q.begin(), q.begin() + LatticeTables::Diagonal(work.Grid.Canonical(face.Block)), q.end());
  if (!isUpper)
  {
    std::swap(q[1], q[3]);
  }
  const Index centre = Centre(work, cell);
  SetTet(work, tet++, { { q[0], q[1], q[2], centre } }, face, firstPiece, label);
  SetTet(work, tet++, { { q[0], q[2], q[3], centre } }, face, firstPiece + 1, label);
}

void FillTets(Work& work, Index j, Index k, Index row)
{
  Index tet = work.FirstTet[row];
  OverFaces(work, j, k,
    [&](const Face& face)
    {
      if (IsInner(work, face))
      {
        FillInnerFace(work, face, tet);
        return;
      }
      FillHalves(work, face, false, 0, tet);
      FillHalves(work, face, true, face.LowerLabel < 0 ? 0 : 2, tet);
    });
}

} // namespace

TetTopology BuildCellTets(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid,
  const NarrowVoid& narrow, Runtime& runtime, const CoarseTets& coarse)
{
  Work work{ grid, labels, meshVoid, narrow, runtime, coarse };
  CheckIds(grid, TetIds.ElementSlots);
  const Index finePoints = MakeBlockPoints(
    grid, coarse, runtime, [&](const Index3& p, Index node) { return SlotsOf(work, p, node); },
    [&](const Index3& p, Index node, Index slot)
    { return slot == VertexSlot ? PositionOf(work, p, node) : PointPosition::Inside; },
    work.FirstPoint, work.Result);
  const Index fineTets = CountTets(work);
  work.Result.Tets.ResizeElements(fineTets + coarse.NumberOfTets());
  ForRows(work.Run, work.Nodes, [&](Index j, Index k, Index row) { FillTets(work, j, k, row); });
  work.Coarse.Fill(work.Result, finePoints, fineTets,
    [&](Index at, Index slot)
    { return slot == CentreSlot ? Centre(work, at) : Index(work.FirstPoint[at]); });
  work.Result.Tets.HasBarrier = !narrow.IsEmpty();
  return std::move(work.Result);
}

} // namespace vfm
