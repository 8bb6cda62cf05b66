#include "Hex/HexTopology.h"

#include "Hex/CoarseHexes.h"
#include "Labels/LabelCondition.h"

namespace vfm
{
Vector3 StartOfInnerPoint(
  const CartesianGrid& grid, const LabelArray& labels, const Index3& node, int label)
{
  const std::array<int, 8> star = StarOfNode(grid, labels, grid.Linear(node));
  const RegionNormals normals = RegionNormalsTable[RegionOfLabel(star, label)];
  Vector3 x = grid.NodePoint(node);
  for (int a = 0; a < 3; ++a)
  {
    if (((normals.Minus | normals.Plus) >> a & 1) == 0)
    {
      continue;
    }
    // a normal occurs only where the node is inside the domain, so both widths exist
    const double width = std::min(grid.Width(a, node[a] - 1), grid.Width(a, node[a]));
    x[a] += (normals.Minus >> a & 1 ? BufferThickness : -BufferThickness) * width;
  }
  return x;
}

int PointNumbering::MeshedRank(Index node, int label) const
{
  const StarLabels star(StarOfNode(this->Grid, this->Labels, node));
  return star.RankOf(label) - (this->IsMeshed(star.Label[0]) ? 0 : 1);
}

int PointNumbering::PointsAt(Index node) const
{
  if (!this->IsSplit(node))
  {
    return this->IsMeshed(this->Labels[node]) ? 1 : 0;
  }
  const StarLabels star(StarOfNode(this->Grid, this->Labels, node));
  return 1 + star.Count - (this->IsMeshed(star.Label[0]) ? 0 : 1);
}

class HexTopologyBuilder
{
public:
  HexTopologyBuilder(const CartesianGrid& grid, const LabelArray& labels,
    const std::vector<Index>& mixed, bool stairStep, PointNumbering& numbering, Runtime& runtime,
    CoarseHexes& coarse) :
    Grid(grid),
    Labels(labels),
    Box(grid.HexBox()),
    StairStep(stairStep),
    Numbering(numbering),
    Run(runtime),
    Coarse(coarse),
    Mixed(mixed)
  {
  }

  Mesh Build()
  {
    CheckIds(this->Grid, this->Result.Ids.PointSlots);
    const Index finePoints = this->CountPoints(), fineHexes = this->CountHexes();
    const Index points = finePoints + this->Coarse.NumberOfPoints();
    const Index hexes = fineHexes + this->Coarse.NumberOfHexes();
    CheckNumberOfPoints(points, this->Run.Group());
    Mesh& mesh = this->Result;
    mesh.Points = Buffer<double>(3 * points);
    mesh.PointIds = Buffer<Index>(points);
    mesh.Elements = Buffer<Index>(8 * hexes);
    mesh.ElementIds = Buffer<Index>(hexes);
    mesh.Material = Buffer<int>(hexes);
    ForRows(this->Run, NodesOf(this->Box),
      [this](Index j, Index k, Index row) { this->FillPoints(j, k, row); });
    ForRows(
      this->Run, this->Box, [this](Index j, Index k, Index row) { this->FillHexes(j, k, row); });
    this->Coarse.Fill(mesh, finePoints, fineHexes,
      { [this](Index node) { return this->Numbering.FirstPoint(node); },
        [this](Index node, int label) { return this->Numbering.InnerPoint(node, label); } });
    return std::move(mesh);
  }

private:
  /// Calls visit(p, cell) for the cells of a row that are hexes of their own.
  template <class Visitor>
  void ForCells(Index j, Index k, const Visitor& visit) const
  {
    const auto visitRun = [&](Index first, Index last)
    {
      Index3 p{ { first, j, k } };
      for (Index cell = this->Grid.Linear(p); p[0] < last; ++p[0], ++cell)
      {
        visit(p, cell);
      }
    };
    this->Coarse.Levels().ForFineCells(j, k, this->Box.Lower[0], this->Box.Upper[0], visitRun);
  }

  /// Calls visit(p, node, whether it is mixed) for the nodes of such cells in a row.
  template <class Visitor>
  void ForNodes(Index j, Index k, const Visitor& visit) const
  {
    const auto visitRun = [&](Index first, Index last)
    {
      Index3 p{ { first, j, k } };
      Index node = this->Grid.Linear(p);
      const Index end = node + last - first;
      auto mixed = std::lower_bound(this->Mixed.begin(), this->Mixed.end(), node);
      Index next = mixed == this->Mixed.end() ? end : *mixed;
      for (; node < end; ++p[0], ++node)
      {
        const bool isMixed = node == next;
        if (isMixed)
        {
          ++mixed;
          next = mixed == this->Mixed.end() ? end : *mixed;
        }
        visit(p, node, isMixed);
      }
    };
    this->Coarse.Levels().ForFineNodes(j, k, this->Box.Lower[0], this->Box.Upper[0] + 1, visitRun);
  }

  int PointsOfNode(Index node, bool isMixed) const
  {
    if (!isMixed)
    {
      return this->Numbering.IsMeshed(this->Labels[node]) ? 1 : 0;
    }
    if (this->StairStep)
    {
      return 1;
    }
    const StarLabels star(StarOfNode(this->Grid, this->Labels, node));
    return 1 + star.Count - (this->Numbering.IsMeshed(star.Label[0]) ? 0 : 1);
  }

  static Index MakeOffsets(std::vector<Index>& counts)
  {
    Index total = 0;
    for (Index& count : counts)
    {
      const Index first = total;
      total += count;
      count = first;
    }
    return total;
  }

  Index CountPoints()
  {
    this->PointOffset.resize((this->Box.Size(1) + 1) * (this->Box.Size(2) + 1));
    ForRows(this->Run, NodesOf(this->Box),
      [this](Index j, Index k, Index row)
      {
        Index count = 0;
        this->ForNodes(j, k,
          [&](const Index3&, Index node, bool isMixed)
          { count += this->PointsOfNode(node, isMixed); });
        this->PointOffset[row] = count;
      });
    return MakeOffsets(this->PointOffset);
  }

  Index CountHexes()
  {
    std::vector<Index>& offset = this->Result.RowOffset;
    offset.resize(this->Box.Size(1) * this->Box.Size(2));
    ForRows(this->Run, this->Box,
      [&](Index j, Index k, Index row)
      {
        Index count = 0;
        this->ForCells(j, k,
          [&](const Index3&, Index cell)
          {
            if (this->Numbering.IsMeshed(this->Labels[cell]))
            {
              count += 1 + this->CountBufferHexes(cell);
            }
          });
        offset[row] = count;
      });
    const Index total = MakeOffsets(offset);
    offset.push_back(total);
    return total;
  }

  int CountBufferHexes(Index cell) const
  {
    int count = 0;
    for (int face = 0; !this->StairStep && face < 6; ++face)
    {
      count += this->Labels[this->Grid.Neighbour(cell, face)] != this->Labels[cell];
    }
    return count;
  }

  void FillPoints(Index j, Index k, Index row)
  {
    Index point = this->PointOffset[row];
    this->ForNodes(j, k,
      [&](const Index3& p, Index node, bool isMixed)
      {
        const int count = this->PointsOfNode(node, isMixed);
        const bool split = isMixed && !this->StairStep;
        this->Numbering.SetCode(node, static_cast<int>(split ? ~point : point));
        if (count > 0)
        {
          this->SetPoint(point, this->Grid.NodePoint(p), this->Grid.NodeKey(p), 0);
        }
        if (split)
        {
          this->FillInnerPoints(p, node, point + 1);
        }
        point += count;
      });
  }

  void FillInnerPoints(const Index3& p, Index node, Index point)
  {
    const StarLabels labels(StarOfNode(this->Grid, this->Labels, node));
    for (int rank = 0; rank < labels.Count; ++rank)
    {
      if (!this->Numbering.IsMeshed(labels.Label[rank]))
      {
        continue;
      }
      const Vector3 x = StartOfInnerPoint(this->Grid, this->Labels, p, labels.Label[rank]);
      this->SetPoint(point++, x, this->Grid.NodeKey(p), 1 + rank);
    }
  }

  void SetPoint(Index point, const Vector3& x, Index key, int slot)
  {
    std::copy(x.begin(), x.end(), this->Result.Points.data() + 3 * point);
    this->Result.PointIds[point] = HexIds.PointSlots * key + slot + 1;
  }

  void FillHexes(Index j, Index k, Index row)
  {
    Index hex = this->Result.RowOffset[row];
    this->ForCells(j, k,
      [&](const Index3& p, Index cell)
      {
        if (this->Numbering.IsMeshed(this->Labels[cell]))
        {
          hex = this->FillCell(p, cell, hex);
        }
      });
  }

  /// Writes the hexes of a cell from one on; returns the next.
  Index FillCell(const Index3& p, Index cell, Index hex)
  {
    const int label = this->Labels[cell];
    const Index key = HexIds.ElementSlots * this->Grid.CellKey(p) + 1;
    std::array<Index, 8> inner, surface;
    int signs = 0;
    for (int c = 0; c < 8; ++c)
    {
      const int code = this->Numbering.CodeOf(this->Grid.NodeOfCell(cell, c));
      inner[c] = code;
      signs |= code;
    }
    if (signs >= 0) // no node is split
    {
      this->SetHex(hex++, inner, key, label);
      return hex;
    }
    for (int c = 0; c < 8; ++c)
    {
      surface[c] = this->Numbering.FirstPoint(this->Grid.NodeOfCell(cell, c));
      inner[c] = this->Numbering.InnerPoint(this->Grid.NodeOfCell(cell, c), label);
    }
    this->SetHex(hex++, inner, key, label);
    for (int face = 0; face < 6; ++face)
    {
      if (this->Labels[this->Grid.Neighbour(cell, face)] != label)
      {
        this->SetHex(hex++, BufferHex(surface, inner, face), key + 1 + face, label);
      }
    }
    return hex;
  }

  void SetHex(Index hex, const std::array<Index, 8>& corners, Index id, int label)
  {
    Index* points = this->Result.Elements.data() + 8 * hex;
    for (int c = 0; c < 8; ++c)
    {
      points[VtkCorner[c]] = corners[c];
    }
    this->Result.ElementIds[hex] = id;
    this->Result.Material[hex] = label;
  }

  const CartesianGrid& Grid;
  const LabelArray& Labels;
  IndexBox Box;
  bool StairStep;
  PointNumbering& Numbering;
  Runtime& Run;
  CoarseHexes& Coarse;
  const std::vector<Index>& Mixed; // ascending
  std::vector<Index> PointOffset;
  Mesh Result;
};

Mesh BuildHexes(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, bool stairStep, PointNumbering& numbering, Runtime& runtime,
  CoarseHexes& coarse)
{
  return HexTopologyBuilder(grid, labels, mixed, stairStep, numbering, runtime, coarse).Build();
}

} // namespace vfm
