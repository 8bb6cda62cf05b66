#include "Tet/CellTets.h"

#include "Tet/CoarseTets.h"
#include "Tet/LatticeStencils.h"

#include <numeric>

namespace vfm
{
namespace
{

class CellTetBuilder
{
public:
  CellTetBuilder(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid,
    Runtime& runtime, const CoarseTets& coarse) :
    Grid(grid),
    Labels(labels),
    Box(grid.HexBox()),
    Nodes(NodesOf(this->Box)),
    MeshVoid(meshVoid),
    Run(runtime),
    Coarse(coarse)
  {
  }

  TetTopology Build()
  {
    Mesh& mesh = this->Result.Tets;
    mesh.Corners = 4;
    mesh.Ids = TetIds;
    mesh.Levels = this->Coarse.Levels().shared_from_this();
    CheckIds(this->Grid, TetIds.ElementSlots);
    this->FirstPoint = Buffer<int>(this->Grid.NumberOfEntries(), -1);
    this->MakePoints();
    const Index fineTets = this->CountTets();
    const Index tets = fineTets + this->Coarse.NumberOfTets();
    mesh.Elements = Buffer<Index>(4 * tets);
    mesh.ElementIds = Buffer<Index>(tets);
    mesh.Material = Buffer<int>(tets);
    ForRows(
      this->Run, this->Nodes, [this](Index j, Index k, Index row) { this->FillTets(j, k, row); });
    this->Coarse.Fill(this->Result, this->FinePoints, fineTets,
      [this](Index at, Index slot)
      { return slot == CentreSlot ? this->Centre(at) : Index(this->FirstPoint[at]); });
    return std::move(this->Result);
  }

private:
  struct Face
  {
    Index3 Block;
    Index Node;
    int Axis;
    int Lower, Upper; // labels of the cells; -1 outside the domain
  };

  bool IsFine(const Index3& cell) const { return this->Coarse.Levels().IsFine(cell); }

  /// Bits of the slots that a block uses.
  int SlotsOf(const Index3& p, Index node) const
  {
    const bool isCentre =
      this->Box.Contains(p) && IsMeshed(this->Labels[node], this->MeshVoid) && this->IsFine(p);
    int slots = isCentre << CentreSlot;
    const bool isVertex = this->Coarse.Levels().TouchesFine(p);
    for (int c = 0; isVertex && c < 8; ++c)
    {
      const Index3 cell = CellOfStar(p, c);
      const bool meshed = this->Box.Contains(cell) &&
        IsMeshed(this->Labels[this->Grid.CellOfNode(node, c)], this->MeshVoid);
      slots |= meshed << VertexSlot;
    }
    return slots;
  }

  template <class Body>
  void OverBlocks(Index j, Index k, const Body& body) const
  {
    Index3 p{ { this->Box.Lower[0], j, k } };
    Index node = this->Grid.Linear(p);
    for (; p[0] <= this->Box.Upper[0]; ++p[0], ++node)
    {
      body(p, node);
    }
  }

  void MakePoints()
  {
    std::vector<Index> offset(this->Nodes.Size(1) * this->Nodes.Size(2) + 1, 0);
    ForRows(this->Run, this->Nodes,
      [&](Index j, Index k, Index row)
      {
        this->OverBlocks(j, k,
          [&](const Index3& p, Index node)
          {
            const int slots = this->SlotsOf(p, node);
            offset[row + 1] += (slots & 1) + (slots >> 1);
          });
      });
    std::partial_sum(offset.begin(), offset.end(), offset.begin());
    this->FinePoints = offset.back();
    const Index points = this->FinePoints + this->Coarse.NumberOfPoints();
    CheckNumberOfPoints(points, this->Run.Group());
    Mesh& mesh = this->Result.Tets;
    mesh.Points = Buffer<double>(3 * points);
    mesh.PointIds = Buffer<Index>(points);
    this->Result.Positions.assign(points, PointPosition::Inside);
    ForRows(this->Run, this->Nodes,
      [&](Index j, Index k, Index row)
      {
        Index point = offset[row];
        this->OverBlocks(
          j, k, [&](const Index3& p, Index node) { this->FillPoints(p, node, point); });
      });
  }

  void FillPoints(const Index3& p, Index node, Index& point)
  {
    const int slots = this->SlotsOf(p, node);
    Mesh& mesh = this->Result.Tets;
    this->FirstPoint[node] = static_cast<int>(point);
    const Vector3 low = this->Grid.NodePoint(p);
    for (Index slot : { VertexSlot, CentreSlot })
    {
      if (!(slots >> slot & 1))
      {
        continue;
      }
      Vector3 x = low;
      for (int a = 0; slot == CentreSlot && a < 3; ++a)
      {
        x[a] = 0.5 * (low[a] + this->Grid.Coordinates(a)[p[a] + 1]);
      }
      std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * point);
      mesh.PointIds[point] = TetIds.PointSlots * this->Grid.NodeKey(p) + slot + 1;
      if (slot == VertexSlot)
      {
        this->Result.Positions[point] = this->PositionOf(p, node);
      }
      ++point;
    }
  }

  PointPosition PositionOf(const Index3& p, Index node) const
  {
    const std::array<int, 8> star = StarOfNode(this->Grid, this->Labels, node);
    const bool mixed =
      std::any_of(star.begin(), star.end(), [&](int label) { return label != star[0]; });
    return mixed
      ? PointPosition::OnInterface
      : (this->Grid.DomainSides(p) != 0 ? PointPosition::OnDomain : PointPosition::Inside);
  }

  /// Calls body(face) for the faces of a row of blocks whose cells are all fine and in the box, in the order of ids.
  template <class Body>
  void OverFaces(Index j, Index k, const Body& body) const
  {
    this->OverBlocks(j, k,
      [&](const Index3& p, Index node)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          Index3 below = p;
          --below[axis];
          const bool inLower = below[axis] >= 0;
          const bool inUpper = p[axis] < this->Grid.Global().Upper[axis];
          if (p[u] < this->Box.Upper[u] && p[v] < this->Box.Upper[v] &&
            (!inLower || (this->Box.Contains(below) && this->IsFine(below))) &&
            (!inUpper || (this->Box.Contains(p) && this->IsFine(p))))
          {
            body(Face{ p, node, axis, inLower ? this->Labels[node - this->Grid.Stride(axis)] : -1,
              inUpper ? this->Labels[node] : -1 });
          }
        }
      });
  }

  Index CountTets()
  {
    this->FirstTet.assign(this->Nodes.Size(1) * this->Nodes.Size(2) + 1, 0);
    ForRows(this->Run, this->Nodes,
      [this](Index j, Index k, Index row)
      {
        this->OverFaces(j, k,
          [&](const Face& face)
          {
            this->FirstTet[row + 1] +=
              2 * (IsMeshed(face.Lower, this->MeshVoid) + IsMeshed(face.Upper, this->MeshVoid));
          });
      });
    std::partial_sum(this->FirstTet.begin(), this->FirstTet.end(), this->FirstTet.begin());
    return this->FirstTet.back();
  }

  Index Centre(Index cell) const
  {
    const Index first = this->FirstPoint[cell];
    return first + (SlotOfPoint(this->Result.Tets.PointIds[first]) == VertexSlot);
  }

  void FillTets(Index j, Index k, Index row)
  {
    Index tet = this->FirstTet[row];
    this->OverFaces(j, k,
      [&](const Face& face)
      {
        if (face.Lower == face.Upper)
        {
          this->FillInnerFace(face, tet);
          return;
        }
        this->FillHalves(face, face.Lower, 0, tet);
        this->FillHalves(face, face.Upper, face.Lower < 0 ? 0 : 2, tet);
      });
  }

  /// The corners around a face, seen from above against the clock.
  std::array<Index, 4> CornersOf(const Face& face) const
  {
    const Index u = this->Grid.Stride((face.Axis + 1) % 3),
                v = this->Grid.Stride((face.Axis + 2) % 3);
    return { { this->FirstPoint[face.Node], this->FirstPoint[face.Node + u],
      this->FirstPoint[face.Node + u + v], this->FirstPoint[face.Node + v] } };
  }

  /// Four tets around the edge between the centres.
  void FillInnerFace(const Face& face, Index& tet)
  {
    if (!IsMeshed(face.Lower, this->MeshVoid))
    {
      return;
    }
    const std::array<Index, 4> q = this->CornersOf(face);
    const Index below = this->Centre(face.Node - this->Grid.Stride(face.Axis));
    const Index above = this->Centre(face.Node);
    for (int t = 0; t < 4; ++t)
    {
      this->SetTet(tet++, { { below, above, q[t], q[(t + 1) % 4] } }, face, t, face.Lower);
    }
  }

  /// Two tets between the halves of the quad and the centre on one side. They stand one after the other, the halves
  /// (q0 q1 q2) and (q0 q2 q3) as seen from the centre against the clock: what DiagonalFlips relies on.
  void FillHalves(const Face& face, int label, int firstPiece, Index& tet)
  {
    if (!IsMeshed(label, this->MeshVoid))
    {
      return;
    }
    const bool isUpper = label == face.Upper;
    std::array<Index, 4> q = this->CornersOf(face);
    std::rotate(q.begin(), q.begin() + LatticeTables::Diagonal(face.Block), q.end());
    if (!isUpper)
    {
      std::swap(q[1], q[3]);
    }
    const Index centre =
      this->Centre(isUpper ? face.Node : face.Node - this->Grid.Stride(face.Axis));
    this->SetTet(tet++, { { q[0], q[1], q[2], centre } }, face, firstPiece, label);
    this->SetTet(tet++, { { q[0], q[2], q[3], centre } }, face, firstPiece + 1, label);
  }

  void SetTet(Index tet, const std::array<Index, 4>& points, const Face& face, int t, int label)
  {
    Mesh& mesh = this->Result.Tets;
    std::copy(points.begin(), points.end(), mesh.Elements.data() + 4 * tet);
    mesh.ElementIds[tet] =
      TetIds.ElementSlots * this->Grid.NodeKey(face.Block) + (4 * face.Axis + t) * PiecesPerTet + 1;
    mesh.Material[tet] = label;
  }

  const CartesianGrid& Grid;
  const LabelArray& Labels;
  IndexBox Box, Nodes;
  bool MeshVoid;
  Runtime& Run;
  const CoarseTets& Coarse;
  Buffer<int> FirstPoint; // of each block
  Index FinePoints = 0;
  std::vector<Index> FirstTet; // of each row
  TetTopology Result;
};

} // namespace

TetTopology BuildCellTets(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid,
  Runtime& runtime, const CoarseTets& coarse)
{
  return CellTetBuilder(grid, labels, meshVoid, runtime, coarse).Build();
}

} // namespace vfm
