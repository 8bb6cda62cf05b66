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

const int* PointNumbering::CodesOf(Index first, Index count, std::vector<int>& copy) const
{
  if (!this->Codes.empty())
  {
    return this->Codes.data() + first;
  }
  copy.resize(count);
  this->SomeCodes.Visit(
    first, first + count,
    [&](Index begin, Index end, int code) { std::fill_n(&copy[begin - first], end - begin, code); },
    [&](Index begin, Index end, const int* codes)
    { std::copy_n(codes, end - begin, &copy[begin - first]); });
  return copy.data();
}

void PointNumbering::SetCodes(Index first, Index count, Index code, int step)
{
  if (this->Codes.empty())
  {
    for (Index n = 0; n < count; ++n)
    {
      this->SomeCodes.Set(first + n, static_cast<int>(code) + step * static_cast<int>(n));
    }
    return;
  }
  int* codes = this->Codes.data() + first;
  for (int n = 0; n < count; ++n)
  {
    codes[n] = static_cast<int>(code) + step * n;
  }
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
    const Index finePoints = this->CountPoints();
    const Index points = finePoints + this->Coarse.NumberOfPoints();
    CheckNumberOfPoints(points, this->Run.Group());
    Mesh& mesh = this->Result;
    mesh.Points = Buffer<double>(3 * points);
    mesh.PointIds = Buffer<Index>(points);
    ForRows(this->Run, NodesOf(this->Box),
      [this](Index j, Index k, Index row) { this->FillPoints(j, k, row); });
    const Index fineHexes = this->CountHexes();
    const Index hexes = fineHexes + this->Coarse.NumberOfHexes();
    mesh.Elements = Buffer<Index>(8 * hexes);
    mesh.ElementIds = Buffer<Index>(hexes);
    mesh.Material = Buffer<int>(hexes);
    mesh.WholeCells = this->StairStep ? fineHexes : 0;
    ForRows(
      this->Run, this->Box, [this](Index j, Index k, Index row) { this->FillHexes(j, k, row); });
    this->Coarse.Fill(mesh, finePoints, fineHexes,
      { [this](Index node) { return this->Numbering.FirstPoint(node); },
        [this](Index node, int label) { return this->Numbering.InnerPoint(node, label); } });
    return std::move(mesh);
  }

private:
  /// Where a row of cells has hexes of its own: the codes of the nodes around it, from its first cell on, and its labels.
  struct CellRun
  {
    Index3 First;
    Index Cell; // the first
    int Label;  // of all
    std::array<const int*, 4> Codes;
    bool IsSplit(Index i) const
    {
      int signs = 0;
      for (const int* codes : this->Codes)
      {
        signs |= codes[i] | codes[i + 1];
      }
      return signs < 0;
    }
  };

  /// Calls visit(run, length) for cells of one label that are hexes of their own.
  template <class Visitor>
  void ForCells(Index j, Index k, const Visitor& visit) const
  {
    std::array<std::vector<int>, 4> copies;
    const auto visitRun = [&](Index first, Index last)
    {
      const Index3 p{ { first, j, k } };
      const Index row = this->Grid.Linear(p);
      std::array<const int*, 4> codes;
      for (int r = 0; r < 4; ++r)
      {
        codes[r] =
          this->Numbering.CodesOf(this->Grid.NodeOfCell(row, 2 * r), last - first + 1, copies[r]);
      }
      const auto visitLabel = [&](Index begin, Index end, int label)
      {
        if (!this->Numbering.IsMeshed(label))
        {
          return;
        }
        CellRun run{ { { first + begin - row, j, k } }, begin, label, codes };
        for (const int*& at : run.Codes)
        {
          at += begin - row;
        }
        visit(run, end - begin);
      };
      this->Labels.Visit(row, row + last - first, visitLabel,
        [&](Index begin, Index end, const int* labels)
        {
          for (Index next; begin < end; begin = next)
          {
            const int label = *labels;
            for (next = begin; next < end && *labels == label; ++next, ++labels)
            {
            }
            visitLabel(begin, next, label);
          }
        });
    };
    this->Coarse.Levels().ForFineCells(j, k, this->Box.Lower[0], this->Box.Upper[0], visitRun);
  }

  /// For the nodes of such cells in a row calls mixed(p, node) for a mixed one, plain(p, node, count, label) for those of one label between
  /// two.
  template <class Plain, class MixedOne>
  void ForNodes(Index j, Index k, const Plain& plain, const MixedOne& mixed) const
  {
    const auto visitRun = [&](Index first, Index last)
    {
      Index3 p{ { first, j, k } };
      Index node = this->Grid.Linear(p);
      const Index end = node + last - first;
      auto next = std::lower_bound(this->Mixed.begin(), this->Mixed.end(), node);
      while (node < end)
      {
        const Index stop = next == this->Mixed.end() ? end : std::min(*next, end);
        if (node < stop)
        {
          plain(p, node, stop - node, this->Labels[node]);
          p[0] += stop - node;
          node = stop;
          continue;
        }
        mixed(p, node);
        ++next;
        ++node;
        ++p[0];
      }
    };
    this->Coarse.Levels().ForFineNodes(j, k, this->Box.Lower[0], this->Box.Upper[0] + 1, visitRun);
  }

  int PointsOfMixed(Index node) const
  {
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
        this->ForNodes(
          j, k,
          [&](const Index3&, Index, Index nodes, int label)
          { count += this->Numbering.IsMeshed(label) ? nodes : 0; },
          [&](const Index3&, Index node) { count += this->PointsOfMixed(node); });
        this->PointOffset[row] = count;
      });
    return MakeOffsets(this->PointOffset);
  }

  /// After the points.
  Index CountHexes()
  {
    std::vector<Index>& offset = this->Result.RowOffset;
    offset.resize(this->Box.Size(1) * this->Box.Size(2));
    ForRows(this->Run, this->Box,
      [&](Index j, Index k, Index row)
      {
        Index count = 0;
        this->ForCells(j, k,
          [&](const CellRun& run, Index length)
          {
            count += length;
            for (Index i = 0; !this->StairStep && i < length; ++i)
            {
              count += run.IsSplit(i) ? this->CountBufferHexes(run.Cell + i, run.Label) : 0;
            }
          });
        offset[row] = count;
      });
    const Index total = MakeOffsets(offset);
    offset.push_back(total);
    return total;
  }

  int CountBufferHexes(Index cell, int label) const
  {
    int count = 0;
    for (int face = 0; face < 6; ++face)
    {
      count += this->Labels[this->Grid.Neighbour(cell, face)] != label;
    }
    return count;
  }

  void FillPoints(Index j, Index k, Index row)
  {
    Index point = this->PointOffset[row];
    this->ForNodes(
      j, k,
      [&](const Index3& p, Index node, Index count, int label)
      {
        const bool isMeshed = this->Numbering.IsMeshed(label);
        this->Numbering.SetCodes(node, count, point, isMeshed ? 1 : 0);
        if (isMeshed)
        {
          this->FillPlainPoints(p, count, point);
          point += count;
        }
      },
      [&](const Index3& p, Index node)
      {
        this->Numbering.SetCode(node, static_cast<int>(this->StairStep ? point : ~point));
        this->SetPoint(point, this->Grid.NodePoint(p), this->Grid.NodeKey(p), 0);
        if (!this->StairStep)
        {
          this->FillInnerPoints(p, node, point + 1);
        }
        point += this->PointsOfMixed(node);
      });
  }

  /// One at each of some nodes of a row.
  void FillPlainPoints(const Index3& first, Index count, Index point)
  {
    const double* x = this->Grid.Coordinates(0).data() + first[0];
    const double y = this->Grid.Coordinates(1)[first[1]], z = this->Grid.Coordinates(2)[first[2]];
    const Index id = HexIds.PointSlots * this->Grid.NodeKey(first) + 1;
    double* points = this->Result.Points.data() + 3 * point;
    Index* ids = this->Result.PointIds.data() + point;
    for (Index i = 0; i < count; ++i)
    {
      points[3 * i] = x[i];
      points[3 * i + 1] = y;
      points[3 * i + 2] = z;
      ids[i] = id + HexIds.PointSlots * i;
    }
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
      [&](const CellRun& run, Index length)
      {
        for (Index i = 0, next; i < length; i = next)
        {
          for (next = i; next < length && (this->StairStep || !run.IsSplit(next)); ++next)
          {
          }
          this->FillPlainHexes(run, i, next - i, hex);
          hex += next - i;
          if (next < length)
          {
            hex = this->FillSplitCell(run, next++, hex);
          }
        }
      });
  }

  /// Of cells without split nodes, from the i-th of a run on.
  void FillPlainHexes(const CellRun& run, Index i, Index count, Index hex)
  {
    const int *a = run.Codes[0] + i, *b = run.Codes[1] + i, *c = run.Codes[2] + i,
              *d = run.Codes[3] + i;
    const Index id = this->IdOfCell(run, i);
    Index* points = this->Result.Elements.data() + 8 * hex;
    Index* ids = this->Result.ElementIds.data() + hex;
    for (Index n = 0; n < count; ++n, points += 8)
    {
      points[0] = a[n];
      points[1] = a[n + 1];
      points[2] = b[n + 1];
      points[3] = b[n];
      points[4] = c[n];
      points[5] = c[n + 1];
      points[6] = d[n + 1];
      points[7] = d[n];
      ids[n] = id + HexIds.ElementSlots * n;
    }
    std::fill_n(this->Result.Material.data() + hex, count, run.Label);
  }

  Index IdOfCell(const CellRun& run, Index i) const
  {
    return HexIds.ElementSlots * (this->Grid.CellKey(run.First) + i) + 1;
  }

  /// Writes the hexes of the i-th cell of a run from one on; returns the next.
  Index FillSplitCell(const CellRun& run, Index i, Index hex)
  {
    const Index cell = run.Cell + i, id = this->IdOfCell(run, i);
    std::array<Index, 8> inner, surface;
    for (int c = 0; c < 8; ++c)
    {
      surface[c] = this->Numbering.FirstPoint(this->Grid.NodeOfCell(cell, c));
      inner[c] = this->Numbering.InnerPoint(this->Grid.NodeOfCell(cell, c), run.Label);
    }
    this->SetHex(hex++, inner, id, run.Label);
    for (int face = 0; face < 6; ++face)
    {
      if (this->Labels[this->Grid.Neighbour(cell, face)] != run.Label)
      {
        this->SetHex(hex++, BufferHex(surface, inner, face), id + 1 + face, run.Label);
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
