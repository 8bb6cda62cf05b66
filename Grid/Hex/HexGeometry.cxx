#include "Hex/HexGeometry.h"

#include "Hex/CoarseHexes.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{
namespace
{

class HexFacets
{
public:
  HexFacets(const CartesianGrid& grid, const LabelArray& labels, const std::vector<Index>& mixed,
    const Fragments& fragments, const PointNumbering& numbering, const Partition& partition,
    const CoarseHexes* coarse, Mesh& mesh) :
    Grid(grid),
    Labels(labels),
    Mixed(mixed),
    Pieces(fragments),
    Points(numbering),
    Parts(partition),
    Coarse(coarse),
    Box(grid.HexBox()),
    Result(mesh)
  {
  }

  std::vector<Facet> Run()
  {
    this->FillVolumes();
    this->AddInterfaceQuads();
    if (this->Coarse && this->Coarse->Splits())
    {
      this->AddCoarseQuads();
    }
    return std::move(this->Quads);
  }

private:
  /// Fragments of hexes, and the quads on the sides of the domain.
  void FillVolumes()
  {
    Mesh& mesh = this->Result;
    mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
    mesh.GeometryDimension = Buffer<int>(mesh.PointIds.size(), 3);
    mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
    const IndexBox& box = this->Box;
    Index row = 0;
    for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
    {
      for (Index j = box.Lower[1]; j < box.Upper[1]; ++j, ++row)
      {
        this->FillRow(j, k, mesh.RowOffset[row], mesh.RowOffset[row + 1]);
      }
    }
    for (Index h = mesh.RowOffset.back(); h < static_cast<Index>(mesh.ElementIds.size()); ++h)
    {
      this->FillCoarseHex(h);
    }
    this->FillInnerPoints();
  }

  void FillCoarseHex(Index h)
  {
    Mesh& mesh = this->Result;
    const RefinedGrid& levels = *mesh.Levels;
    const OctreeKeys::LevelIndex leaf =
      levels.CellOfCoarseElement(mesh.ElementIds[h], mesh.Ids.ElementSlots);
    const Index3 cell = levels.NearestCell(leaf.Level, leaf.At);
    const bool isNear = this->Box.Contains(cell); // the others only serve smoothing
    const int fragment = isNear ? this->Pieces.FragmentOfCell(cell) : 0;
    mesh.Fragment[h] = fragment;
    std::array<int, 8> sides;
    for (int c = 0; c < 8; ++c)
    {
      const Index point = mesh.Elements[8 * h + VtkCorner[c]];
      mesh.GeometryId[point] = isNear ? fragment : mesh.GeometryId[point];
      sides[c] = FindDomainSides(this->Grid, mesh.Points.data() + 3 * point);
    }
    for (const std::array<int, 4>& face : FaceCorners)
    {
      const int common = sides[face[0]] & sides[face[1]] & sides[face[2]] & sides[face[3]];
      for (int side = 0; isNear && common != 0 && side < 6; ++side)
      {
        if (common >> side & 1)
        {
          this->AddDomainQuad(h, face, side, this->Parts.OwnsCell(cell));
        }
      }
    }
  }

  void FillRow(Index j, Index k, Index first, Index last)
  {
    Mesh& mesh = this->Result;
    const Index key = this->Grid.CellKey({ { 0, j, k } });
    const Index3& n = this->Grid.Global().Upper;
    const bool rim = j == 0 || k == 0 || j == n[1] - 1 || k == n[2] - 1;
    Index runEnd = -1;
    int fragment = 0;
    for (Index h = first; h < last; ++h)
    {
      const Index id = mesh.ElementIds[h] - 1;
      const Index i = id / HexIds.ElementSlots - key;
      if (i >= runEnd)
      {
        fragment = this->Pieces.FragmentOfCell({ { i, j, k } }, runEnd);
      }
      mesh.Fragment[h] = fragment;
      mesh.GeometryId[mesh.Elements[8 * h]] = fragment; // enough for points G inside the domain
      if (rim || i == 0 || i == n[0] - 1)
      {
        this->AddDomainQuads(h, static_cast<int>(id % HexIds.ElementSlots), { { i, j, k } });
      }
    }
  }

  /// Fragments of the points I.
  void FillInnerPoints()
  {
    for (Index node : this->Mixed)
    {
      const Index3 p = this->Grid.Position(node);
      // Nodes of no cell in the box have no numbers.
      const bool isSplit = this->Box.Touches(p) && this->Points.IsSplit(node);
      const std::array<int, 8> star = StarOfNode(this->Grid, this->Labels, node);
      for (int c = 0; isSplit && c < 8; ++c)
      {
        const int label = star[c];
        const Index3 cell{ { p[0] - 1 + (c & 1), p[1] - 1 + (c >> 1 & 1),
          p[2] - 1 + (c >> 2 & 1) } };
        if (this->Points.IsMeshed(label) && this->Box.Contains(cell))
        {
          this->Result.GeometryId[this->Points.InnerPoint(node, label)] =
            this->Pieces.FragmentOfCell(cell);
        }
      }
    }
  }

  /// slot: 0 core hex, 1 + face buffer hex, whose faces along its own axis are not on the boundary.
  void AddDomainQuads(Index h, int slot, const Index3& cell)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (slot > 0 && (slot - 1) / 2 == a)
      {
        continue;
      }
      if (cell[a] == 0)
      {
        this->AddDomainQuad(h, FaceCorners[2 * a], 2 * a, this->Parts.OwnsCell(cell));
      }
      if (cell[a] == this->Grid.Global().Upper[a] - 1)
      {
        this->AddDomainQuad(h, FaceCorners[2 * a + 1], 2 * a + 1, this->Parts.OwnsCell(cell));
      }
    }
  }

  void AddDomainQuad(Index h, const std::array<int, 4>& face, int side, bool owned)
  {
    Facet quad;
    for (int c = 0; c < 4; ++c)
    {
      quad.Points[c] = this->Result.Elements[8 * h + VtkCorner[face[c]]];
    }
    quad.Sides = { { -1 - side, this->Result.Fragment[h] } };
    quad.Materials = { { 0, this->Result.Material[h] } };
    quad.DomainSide = side;
    quad.IsOwned = owned;
    this->Quads.push_back(quad);
  }

  void AddInterfaceQuads()
  {
    for (Index node : this->Mixed)
    {
      const Index3 upper = this->Grid.Position(node);
      for (int axis = 0; axis < 3; ++axis)
      {
        Index3 lower = upper;
        --lower[axis];
        const int a = this->Labels[node - this->Grid.Stride(axis)], b = this->Labels[node];
        if (a == b || !this->Box.Contains(upper) || !this->Box.Contains(lower) ||
          !this->TouchesFine(lower, upper))
        {
          continue;
        }
        this->AddInterfaceQuad(node, axis, a < b,
          a < b ? this->Pieces.FragmentOfCell(lower) : this->Pieces.FragmentOfCell(upper),
          a < b ? this->Pieces.FragmentOfCell(upper) : this->Pieces.FragmentOfCell(lower));
        this->Quads.back().Materials = { { std::min(a, b), std::max(a, b) } };
        this->Quads.back().IsOwned = this->Parts.OwnsCell(this->Points.IsMeshed(a) ? lower : upper);
      }
    }
  }

  bool TouchesFine(const Index3& lower, const Index3& upper) const
  {
    const RefinedGrid* levels = this->Result.Levels.get();
    return !levels || levels->IsFine(lower) || levels->IsFine(upper);
  }

  /// Faces of which no side is a finest cell.
  void AddCoarseQuads()
  {
    const RefinedGrid& levels = *this->Result.Levels;
    for (const SplitNodes::Face& face : this->Coarse->Splits()->Faces())
    {
      Facet quad;
      bool isNear = true;
      for (int side = 0; side < 2; ++side)
      {
        const OctreeKeys::LevelIndex& leaf = face.Sides[side].Cell;
        const Index3 cell = levels.NearestCell(leaf.Level, leaf.At);
        isNear = isNear && leaf.Level < levels.NumberOfRefinements() && this->Box.Contains(cell);
        quad.Sides[side] = isNear ? this->Pieces.FragmentOfCell(cell) : 0;
        quad.Materials[side] = face.Sides[side].Label;
      }
      for (int c = 0; c < 4; ++c)
      {
        quad.Points[c] = this->Coarse->SplitPoints()[face.Nodes[(4 - c) % 4]];
        isNear = isNear && quad.Points[c] >= 0;
      }
      if (isNear)
      {
        const bool isFirst = this->Points.IsMeshed(face.Sides[0].Label);
        const OctreeKeys::LevelIndex& leaf = face.Sides[isFirst ? 0 : 1].Cell;
        quad.IsOwned = this->Parts.OwnsCell(levels.FinestNode(leaf.Level, leaf.At));
        quad.DomainSide = -1;
        std::sort(quad.Sides.begin(), quad.Sides.end());
        this->Quads.push_back(quad);
      }
    }
  }

  /// first, second: the fragments of the smaller and of the larger label. downward: the smaller label lies below.
  void AddInterfaceQuad(Index node, int axis, bool downward, int first, int second)
  {
    const Index b = this->Grid.Stride((axis + 1) % 3), c = this->Grid.Stride((axis + 2) % 3);
    Facet quad;
    quad.Points = { { this->Points.FirstPoint(node), this->Points.FirstPoint(node + b),
      this->Points.FirstPoint(node + b + c), this->Points.FirstPoint(node + c) } };
    if (downward)
    {
      std::swap(quad.Points[1], quad.Points[3]);
    }
    quad.Sides = { { std::min(first, second), std::max(first, second) } };
    quad.DomainSide = -1;
    this->Quads.push_back(quad);
  }

  const CartesianGrid& Grid;
  const LabelArray& Labels;
  const std::vector<Index>& Mixed;
  const Fragments& Pieces;
  const PointNumbering& Points;
  const Partition& Parts;
  const CoarseHexes* Coarse; // null without levels
  IndexBox Box;
  Mesh& Result;
  std::vector<Facet> Quads;
};

} // namespace

void FindHexGeometry(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, const Fragments& fragments, const PointNumbering& numbering,
  const Partition& partition, const CoarseHexes* coarse, Mesh& mesh, MeshReport& report)
{
  const std::vector<Facet> quads =
    HexFacets(grid, labels, mixed, fragments, numbering, partition, coarse, mesh).Run();
  ClassifyGeometry(quads, grid, partition, mesh, report);
}

} // namespace vfm
