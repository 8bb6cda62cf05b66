#include "Elements/Tet/CellTets.h"

#include "Elements/Tet/BlockPoints.h"
#include "Labels/InterfaceFaces.h"

#include <numeric>

namespace vfm
{
namespace
{

/// Face of the grid. The label outside the domain is -1.
struct BlockFace : InterfaceFace
{
  Index3 Block;
};

/// Cells that have tets.
struct TetCells
{
  const LabelArray& Labels;
  const NarrowVoid& Narrow;
  bool MeshVoid;

  bool Has(Index cell, int label) const
  {
    return IsMeshed(label, this->MeshVoid) || (label == 0 && this->Narrow.Has(cell));
  }
  bool Has(Index cell) const { return this->Has(cell, this->Labels[cell]); }
};

/// Returns the slots in use of a block, one bit per slot.
/// @param box  CartesianGrid::HexBox
int SlotsOf(const RefinedGrid& levels, const TetCells& cells, const IndexBox& box, const Index3& p,
  Index node)
{
  const bool isCentre = box.Contains(p) && cells.Has(node) && levels.IsFine(p);
  int slots = isCentre << CentreSlot;
  const bool isVertex = levels.TouchesFine(p);
  for (int c = 0; isVertex && c < 8; ++c)
  {
    const bool hasTets =
      box.Contains(CellOfStar(p, c)) && cells.Has(levels.Finest().CellOfNode(node, c));
    slots |= hasTets << VertexSlot;
  }
  return slots;
}

PointPosition PositionOf(
  const CartesianGrid& grid, const LabelArray& labels, const Index3& p, Index node)
{
  return IsMixedStar(StarOfNode(grid, labels, node))
    ? PointPosition::OnInterface
    : (grid.DomainSides(p) != 0 ? PointPosition::OnDomain : PointPosition::Inside);
}

/// Calls body(face) for the faces of a row of blocks whose cells are all fine and in the box, in
/// the order of ids.
template <class Body>
void OverFaces(
  const RefinedGrid& levels, const LabelArray& labels, Index j, Index k, const Body& body)
{
  const CartesianGrid& grid = levels.Finest();
  const IndexBox box = grid.HexBox();
  const auto isIn = [&](const Index3& cell) { return box.Contains(cell) && levels.IsFine(cell); };
  Index3 p{ { box.Lower[0], j, k } };
  Index node = grid.Linear(p);
  for (; p[0] <= box.Upper[0]; ++p[0], ++node)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Index3 below = p;
      --below[axis];
      const bool inLower = below[axis] >= 0;
      const bool inUpper = p[axis] < grid.Global().Upper[axis];
      if (p[u] < box.Upper[u] && p[v] < box.Upper[v] && (!inLower || isIn(below)) &&
        (!inUpper || isIn(p)))
      {
        body(BlockFace{ { node, axis, inLower ? labels[node - grid.Stride(axis)] : -1,
                          inUpper ? labels[node] : -1 },
          p });
      }
    }
  }
}

Index LowerCell(const CartesianGrid& grid, const BlockFace& face)
{
  return face.Node - grid.Stride(face.Axis);
}

/// Returns whether the tets of a face surround the edge between the centres of its cells.
bool IsInner(const CartesianGrid& grid, const BlockFace& face)
{
  return face.LowerLabel == face.UpperLabel && !grid.IsOnFlatSeam(face.Block, face.Axis);
}

/// Returns the first tet of each row of blocks, and the number of tets.
std::vector<Index> FindFirstTets(const RefinedGrid& levels, const TetCells& cells, Runtime& runtime)
{
  const CartesianGrid& grid = levels.Finest();
  const IndexBox nodes = NodesOf(grid.HexBox());
  std::vector<Index> firsts(nodes.Size(1) * nodes.Size(2) + 1, 0);
  ForRows(runtime, nodes,
    [&](Index j, Index k, Index row)
    {
      OverFaces(levels, cells.Labels, j, k,
        [&](const BlockFace& face)
        {
          const bool lower = cells.Has(LowerCell(grid, face), face.LowerLabel);
          const bool upper = cells.Has(face.Node, face.UpperLabel);
          firsts[row + 1] += IsInner(grid, face) ? 4 * (lower && upper) : 2 * (lower + upper);
        });
    });
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  return firsts;
}

/// Writes the tets of faces.
class FaceTetWriter
{
public:
  /// @param firstPoint  first point of each block
  /// @param tets  its points are made and its elements have space
  FaceTetWriter(
    const CartesianGrid& grid, const TetCells& cells, const Buffer<int>& firstPoint, Mesh& tets) :
    Grid(grid), Cells(cells), FirstPoint(firstPoint), Tets(tets)
  {
  }

  /// Returns the point in the centre of a cell.
  Index Centre(Index cell) const
  {
    const Index first = this->FirstPoint[cell];
    return first + (SlotOfPoint(this->Tets.PointIds[first]) == VertexSlot);
  }
  /// Writes the tets of a face from index `tet` on and advances it.
  void Write(const BlockFace& face, Index& tet)
  {
    if (IsInner(this->Grid, face))
    {
      this->WriteInner(face, tet);
      return;
    }
    this->WriteHalves(face, false, 0, tet);
    this->WriteHalves(face, true, face.LowerLabel < 0 ? 0 : 2, tet);
  }

private:
  /// Returns the corners of a face, counterclockwise as seen from above.
  std::array<Index, 4> CornersOf(const BlockFace& face) const
  {
    std::array<Index, 4> corners = NodesOfFace(this->Grid, face);
    std::for_each(
      corners.begin(), corners.end(), [&](Index& corner) { corner = this->FirstPoint[corner]; });
    return corners;
  }
  void SetTet(
    Index tet, const std::array<Index, 4>& points, const BlockFace& face, int t, int label)
  {
    this->Tets.SetElement(tet, points,
      TetIds.ElementSlots * this->Grid.NodeKey(face.Block) + (4 * face.Axis + t) * PiecesPerTet + 1,
      label);
  }
  void WriteInner(const BlockFace& face, Index& tet);
  void WriteHalves(const BlockFace& face, bool isUpper, int firstPiece, Index& tet);

  const CartesianGrid& Grid;
  const TetCells& Cells;
  const Buffer<int>& FirstPoint;
  Mesh& Tets;
};

/// Makes the four tets around the edge between the centres.
void FaceTetWriter::WriteInner(const BlockFace& face, Index& tet)
{
  const Index lower = LowerCell(this->Grid, face);
  if (!this->Cells.Has(lower) || !this->Cells.Has(face.Node))
  {
    return;
  }
  const std::array<Index, 4> q = this->CornersOf(face);
  const Index below = this->Centre(lower), above = this->Centre(face.Node);
  for (int t = 0; t < 4; ++t)
  {
    this->SetTet(tet++, { { below, above, q[t], q[(t + 1) % 4] } }, face, t, face.LowerLabel);
  }
}

/// Makes the two tets between the halves of a quad and the centre on one side. DiagonalFlips relies
/// on their order: they are consecutive, with the halves (q0 q1 q2) and (q0 q2 q3),
/// counterclockwise as seen from the centre.
void FaceTetWriter::WriteHalves(const BlockFace& face, bool isUpper, int firstPiece, Index& tet)
{
  const int label = isUpper ? face.UpperLabel : face.LowerLabel;
  const Index cell = isUpper ? face.Node : LowerCell(this->Grid, face);
  if (!this->Cells.Has(cell, label))
  {
    return;
  }
  std::array<Index, 4> q = this->CornersOf(face);
  std::rotate(
    q.begin(), q.begin() + LatticeTables::Diagonal(this->Grid.Canonical(face.Block)), q.end());
  if (!isUpper)
  {
    std::swap(q[1], q[3]);
  }
  const Index centre = this->Centre(cell);
  this->SetTet(tet++, { { q[0], q[1], q[2], centre } }, face, firstPiece, label);
  this->SetTet(tet++, { { q[0], q[2], q[3], centre } }, face, firstPiece + 1, label);
}

} // namespace

TetTopology BuildCellTets(const LabelArray& labels, bool meshVoid, const NarrowVoid& narrow,
  Runtime& runtime, const CoarseTets& coarse)
{
  const RefinedGrid& levels = coarse.Levels();
  const CartesianGrid& grid = levels.Finest();
  const TetCells cells{ labels, narrow, meshVoid };
  const IndexBox box = grid.HexBox();
  CheckIds(grid, TetIds.ElementSlots);
  Buffer<int> firstPoint(static_cast<std::size_t>(grid.NumberOfEntries()), -1);
  TetTopology result;
  const Index finePoints = MakeBlockPoints(
    grid, coarse, runtime,
    [&](const Index3& p, Index node) { return SlotsOf(levels, cells, box, p, node); },
    [&](const Index3& p, Index node, Index slot)
    { return slot == VertexSlot ? PositionOf(grid, labels, p, node) : PointPosition::Inside; },
    firstPoint, result);
  const std::vector<Index> firstTet = FindFirstTets(levels, cells, runtime);
  const Index fineTets = firstTet.back();
  result.Tets.ResizeElements(fineTets + coarse.NumberOfTets());
  FaceTetWriter writer(grid, cells, firstPoint, result.Tets);
  ForRows(runtime, NodesOf(box),
    [&](Index j, Index k, Index row)
    {
      Index tet = firstTet[row];
      OverFaces(levels, labels, j, k, [&](const BlockFace& face) { writer.Write(face, tet); });
    });
  coarse.Fill(result, finePoints, fineTets,
    [&](Index at, Index slot)
    { return slot == CentreSlot ? writer.Centre(at) : Index(firstPoint[at]); });
  result.Barrier = { !narrow.IsEmpty() };
  return result;
}

} // namespace vfm
