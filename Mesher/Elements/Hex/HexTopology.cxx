#include "Elements/Hex/HexTopology.h"

#include "Elements/Hex/CoarseHexes.h"
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
    // normals occur only where the node is inside the domain, so both widths exist
    const double width = std::min(grid.Width(a, node[a] - 1), grid.Width(a, node[a]));
    x[a] += (normals.Minus >> a & 1 ? BufferThickness : -BufferThickness) * width;
  }
  return x;
}

int PointNumbering::MeshedRank(Index node, int label) const
{
  const StarLabels star(StarOfNode(this->Grid, this->Labels, node));
  return star.RankOf(label) - (this->HasPoint(node, star.Label[0]) ? 0 : 1);
}

int PointNumbering::PointsAt(Index node) const
{
  if (!this->IsSplit(node))
  {
    return this->HasPoint(node, this->Labels[node]) ? 1 : 0;
  }
  const StarLabels star(StarOfNode(this->Grid, this->Labels, node));
  return 1 + star.Count - (this->HasPoint(node, star.Label[0]) ? 0 : 1);
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

/// Run of finest cells with one label in a row, and the codes of the nodes along its four edges
/// from its first cell on.
struct CellRun
{
  Index3 First;
  Index Cell; // first cell
  int Label;  // label of all cells
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

struct Work
{
  const CartesianGrid& Grid;
  const LabelArray& Labels;
  const std::vector<Index>& Mixed; // ascending
  bool StairStep;
  PointNumbering& Numbering;
  Runtime& Run;
  CoarseHexes& Coarse;
  const IndexBox Box = Grid.HexBox();
  std::vector<Index> PointOffset{};
  Mesh Result{};
};

/// Visits the nodes of finest cells in row (j, k). Calls mixed(p, node) for each mixed node, and
/// plain(p, node, count, hasPoint) for runs of nodes with one label between mixed ones.
template <class Plain, class MixedOne>
void ForNodes(const Work& work, Index j, Index k, const Plain& plain, const MixedOne& mixed)
{
  const auto visitRun = [&](Index first, Index last)
  {
    Index3 p{ { first, j, k } };
    Index node = work.Grid.Linear(p);
    const Index end = node + last - first;
    auto next = std::lower_bound(work.Mixed.begin(), work.Mixed.end(), node);
    while (node < end)
    {
      const Index stop = next == work.Mixed.end() ? end : std::min(*next, end);
      if (node < stop)
      {
        work.Numbering.ForNodes(node, stop, work.Labels[node],
          [&](Index begin, Index end, bool hasPoint)
          {
            plain(p, begin, end - begin, hasPoint);
            p[0] += end - begin;
          });
        node = stop;
        continue;
      }
      mixed(p, node);
      ++next;
      ++node;
      ++p[0];
    }
  };
  work.Coarse.Levels().ForFineNodes(j, k, work.Box.Lower[0], work.Box.Upper[0] + 1, visitRun);
}

int PointsOfMixed(const Work& work, Index node)
{
  if (work.StairStep)
  {
    return 1;
  }
  const StarLabels star(StarOfNode(work.Grid, work.Labels, node));
  return 1 + star.Count - (work.Numbering.HasPoint(node, star.Label[0]) ? 0 : 1);
}

Index MakeOffsets(std::vector<Index>& counts)
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

Index CountPoints(Work& work)
{
  work.PointOffset.resize((work.Box.Size(1) + 1) * (work.Box.Size(2) + 1));
  ForRows(work.Run, NodesOf(work.Box),
    [&](Index j, Index k, Index row)
    {
      Index count = 0;
      ForNodes(
        work, j, k,
        [&](const Index3&, Index, Index nodes, bool hasPoint) { count += hasPoint ? nodes : 0; },
        [&](const Index3&, Index node) { count += PointsOfMixed(work, node); });
      work.PointOffset[row] = count;
    });
  return MakeOffsets(work.PointOffset);
}

/// Calls visit(run, length) for the runs of finest cells with hexes in row (j, k).
template <class Visitor>
void ForCells(const Work& work, Index j, Index k, const Visitor& visit)
{
  std::array<std::vector<int>, 4> copies;
  const auto visitRun = [&](Index first, Index last)
  {
    const Index3 p{ { first, j, k } };
    const Index row = work.Grid.Linear(p);
    std::array<const int*, 4> codes;
    for (int r = 0; r < 4; ++r)
    {
      codes[r] =
        work.Numbering.CodesOf(work.Grid.NodeOfCell(row, 2 * r), last - first + 1, copies[r]);
    }
    const auto visitLabel = [&](Index begin, Index end, int label)
    {
      work.Numbering.ForCells(begin, end, label,
        [&](Index start, Index stop)
        {
          CellRun run{ { { first + start - row, j, k } }, start, label, codes };
          for (const int*& at : run.Codes)
          {
            at += start - row;
          }
          visit(run, stop - start);
        });
    };
    work.Labels.Visit(row, row + last - first, visitLabel,
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
  work.Coarse.Levels().ForFineCells(j, k, work.Box.Lower[0], work.Box.Upper[0], visitRun);
}

int CountBufferHexes(const Work& work, Index cell, int label)
{
  int count = 0;
  for (int face = 0; face < 6; ++face)
  {
    count += work.Labels[work.Grid.Neighbour(cell, face)] != label;
  }
  return count;
}

/// Counts the hexes. The points must have codes.
Index CountHexes(Work& work)
{
  std::vector<Index>& offset = work.Result.RowOffset;
  offset.resize(work.Box.Size(1) * work.Box.Size(2));
  ForRows(work.Run, work.Box,
    [&](Index j, Index k, Index row)
    {
      Index count = 0;
      ForCells(work, j, k,
        [&](const CellRun& run, Index length)
        {
          count += length;
          for (Index i = 0; !work.StairStep && i < length; ++i)
          {
            count += run.IsSplit(i) ? CountBufferHexes(work, run.Cell + i, run.Label) : 0;
          }
        });
      offset[row] = count;
    });
  const Index total = MakeOffsets(offset);
  offset.push_back(total);
  return total;
}

/// Writes one point at each of `count` nodes of a row.
void FillPlainPoints(Work& work, const Index3& first, Index count, Index point)
{
  const double* x = work.Grid.Coordinates(0).data() + first[0];
  const double y = work.Grid.Coordinates(1)[first[1]], z = work.Grid.Coordinates(2)[first[2]];
  const Index id = HexIds.PointSlots * work.Grid.NodeKey(first) + 1;
  double* points = work.Result.Points.data() + 3 * point;
  Index* ids = work.Result.PointIds.data() + point;
  for (Index i = 0; i < count; ++i)
  {
    points[3 * i] = x[i];
    points[3 * i + 1] = y;
    points[3 * i + 2] = z;
    ids[i] = id + HexIds.PointSlots * i;
  }
}

void FillInnerPoints(Work& work, const Index3& p, Index node, Index point)
{
  const StarLabels labels(StarOfNode(work.Grid, work.Labels, node));
  for (int rank = 0; rank < labels.Count; ++rank)
  {
    if (!work.Numbering.HasPoint(node, labels.Label[rank]))
    {
      continue;
    }
    const Vector3 x = StartOfInnerPoint(work.Grid, work.Labels, p, labels.Label[rank]);
    work.Result.SetPoint(point++, x, HexIds.PointSlots * work.Grid.NodeKey(p) + 2 + rank);
  }
}

void FillPoints(Work& work, Index j, Index k, Index row)
{
  Index point = work.PointOffset[row];
  ForNodes(
    work, j, k,
    [&](const Index3& p, Index node, Index count, bool hasPoint)
    {
      work.Numbering.SetCodes(node, count, point, hasPoint ? 1 : 0);
      if (hasPoint)
      {
        FillPlainPoints(work, p, count, point);
        point += count;
      }
    },
    [&](const Index3& p, Index node)
    {
      work.Numbering.SetCode(node, static_cast<int>(work.StairStep ? point : ~point));
      work.Result.SetPoint(
        point, work.Grid.NodePoint(p), HexIds.PointSlots * work.Grid.NodeKey(p) + 1);
      if (!work.StairStep)
      {
        FillInnerPoints(work, p, node, point + 1);
      }
      point += PointsOfMixed(work, node);
    });
}

Index IdOfCell(const Work& work, const CellRun& run, Index i)
{
  return HexIds.ElementSlots * (work.Grid.CellKey(run.First) + i) + 1;
}

/// Writes the hexes of cells without split nodes, from cell i of a run on.
void FillPlainHexes(Work& work, const CellRun& run, Index i, Index count, Index hex)
{
  const int *a = run.Codes[0] + i, *b = run.Codes[1] + i, *c = run.Codes[2] + i,
            *d = run.Codes[3] + i;
  const Index id = IdOfCell(work, run, i);
  Index* points = work.Result.Elements.data() + 8 * hex;
  Index* ids = work.Result.ElementIds.data() + hex;
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
  std::fill_n(work.Result.Material.data() + hex, count, run.Label);
}

/// Writes the hexes of cell i of a run from index `hex` on; returns the next index.
Index FillSplitCell(Work& work, const CellRun& run, Index i, Index hex)
{
  const Index cell = run.Cell + i, id = IdOfCell(work, run, i);
  std::array<Index, 8> inner, surface;
  for (int c = 0; c < 8; ++c)
  {
    surface[c] = work.Numbering.FirstPoint(work.Grid.NodeOfCell(cell, c));
    inner[c] = work.Numbering.InnerPoint(work.Grid.NodeOfCell(cell, c), run.Label);
  }
  work.Result.SetElement(hex++, InVtkOrder(inner), id, run.Label);
  for (int face = 0; face < 6; ++face)
  {
    if (work.Labels[work.Grid.Neighbour(cell, face)] != run.Label)
    {
      work.Result.SetElement(
        hex++, InVtkOrder(BufferHex(surface, inner, face)), id + 1 + face, run.Label);
    }
  }
  return hex;
}

void FillHexes(Work& work, Index j, Index k, Index row)
{
  Index hex = work.Result.RowOffset[row];
  ForCells(work, j, k,
    [&](const CellRun& run, Index length)
    {
      for (Index i = 0, next; i < length; i = next)
      {
        for (next = i; next < length && (work.StairStep || !run.IsSplit(next)); ++next)
        {
        }
        FillPlainHexes(work, run, i, next - i, hex);
        hex += next - i;
        if (next < length)
        {
          hex = FillSplitCell(work, run, next++, hex);
        }
      }
    });
}

Mesh BuildHexes(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, bool stairStep, PointNumbering& numbering, Runtime& runtime,
  CoarseHexes& coarse)
{
  Work work{ grid, labels, mixed, stairStep, numbering, runtime, coarse };
  CheckIds(work.Grid, work.Result.Ids.PointSlots);
  const Index finePoints = CountPoints(work);
  const Index points = finePoints + work.Coarse.NumberOfPoints();
  CheckNumberOfPoints(points, work.Run.Group());
  Mesh& mesh = work.Result;
  mesh.ResizePoints(points);
  ForRows(
    work.Run, NodesOf(work.Box), [&](Index j, Index k, Index row) { FillPoints(work, j, k, row); });
  const Index fineHexes = CountHexes(work);
  const Index hexes = fineHexes + work.Coarse.NumberOfHexes();
  mesh.ResizeElements(hexes);
  mesh.WholeCells = work.StairStep ? fineHexes : 0;
  ForRows(work.Run, work.Box, [&](Index j, Index k, Index row) { FillHexes(work, j, k, row); });
  work.Coarse.Fill(mesh, finePoints, fineHexes,
    { [&](Index node) { return work.Numbering.FirstPoint(node); },
      [&](Index node, int label) { return work.Numbering.InnerPoint(node, label); } });
  return std::move(mesh);
}

} // namespace vfm
