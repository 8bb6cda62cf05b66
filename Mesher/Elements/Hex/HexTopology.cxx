#include "Elements/Hex/HexTopology.h"

#include "Elements/Hex/CoarseHexes.h"
#include "Elements/Hex/NearCells.h"
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

/// Finest cells, which get hexes of their own, and their nodes.
struct FineCells
{
  const RefinedGrid& Levels;
  const LabelArray& Labels;
  const std::vector<Index>& Mixed; ///< mixed nodes, ascending
  const PointNumbering& Numbering;
  bool StairStep;
  const NearCells* Near; ///< null: all finest cells

  const CartesianGrid& Grid() const { return this->Levels.Finest(); }
  std::array<int, 8> StarOf(Index node) const
  {
    return StarOfNode(this->Grid(), this->Labels, node);
  }
};

/// Visits the nodes of finest cells in row (j, k). Calls mixed(p, node) for each mixed node, and
/// plain(p, node, count, hasPoint) for runs of nodes with one label between mixed ones.
template <class Plain, class MixedOne>
void ForNodes(const FineCells& cells, Index j, Index k, const Plain& plain, const MixedOne& mixed)
{
  const IndexBox box = cells.Grid().HexBox();
  const auto visitRun = [&](Index first, Index last)
  {
    Index3 p{ { first, j, k } };
    Index node = cells.Grid().Linear(p);
    const Index end = node + last - first;
    auto next = std::lower_bound(cells.Mixed.begin(), cells.Mixed.end(), node);
    while (node < end)
    {
      const Index stop = next == cells.Mixed.end() ? end : std::min(*next, end);
      if (node < stop)
      {
        cells.Numbering.ForNodes(node, stop, cells.Labels[node],
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
  if (cells.Near)
  {
    cells.Near->ForNodes(j, k, visitRun);
    return;
  }
  cells.Levels.ForFineNodes(j, k, box.Lower[0], box.Upper[0] + 1, visitRun);
}

int PointsOfMixed(const FineCells& cells, Index node)
{
  if (cells.StairStep)
  {
    return 1;
  }
  const StarLabels star(cells.StarOf(node));
  return 1 + star.Count - (cells.Numbering.HasPoint(node, star.Label[0]) ? 0 : 1);
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

/// Returns the number of points.
/// @param[out] firsts  first point of each row of nodes
Index CountPoints(const FineCells& cells, Runtime& runtime, std::vector<Index>& firsts)
{
  const IndexBox nodes = NodesOf(cells.Grid().HexBox());
  firsts.resize(nodes.Size(1) * nodes.Size(2));
  ForRows(runtime, nodes,
    [&](Index j, Index k, Index row)
    {
      Index count = 0;
      ForNodes(
        cells, j, k,
        [&](const Index3&, Index, Index run, bool hasPoint) { count += hasPoint ? run : 0; },
        [&](const Index3&, Index node) { count += PointsOfMixed(cells, node); });
      firsts[row] = count;
    });
  return MakeOffsets(firsts);
}

/// Calls visit(run, length) for the runs of finest cells with hexes in row (j, k).
template <class Visitor>
void ForCells(const FineCells& cells, Index j, Index k, const Visitor& visit)
{
  const IndexBox box = cells.Grid().HexBox();
  std::array<std::vector<int>, 4> copies;
  const auto visitRun = [&](Index first, Index last)
  {
    const Index3 p{ { first, j, k } };
    const Index row = cells.Grid().Linear(p);
    std::array<const int*, 4> codes;
    for (int r = 0; r < 4; ++r)
    {
      codes[r] =
        cells.Numbering.CodesOf(cells.Grid().NodeOfCell(row, 2 * r), last - first + 1, copies[r]);
    }
    const auto visitLabel = [&](Index begin, Index end, int label)
    {
      cells.Numbering.ForCells(begin, end, label,
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
    cells.Labels.Visit(row, row + last - first, visitLabel,
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
  if (cells.Near)
  {
    cells.Near->ForCells(j, k, visitRun);
    return;
  }
  cells.Levels.ForFineCells(j, k, box.Lower[0], box.Upper[0], visitRun);
}

int CountBufferHexes(const FineCells& cells, Index cell, int label)
{
  int count = 0;
  for (int face = 0; face < 6; ++face)
  {
    count += cells.Labels[cells.Grid().Neighbour(cell, face)] != label;
  }
  return count;
}

/// Returns the number of hexes. The points must have codes.
/// @param[out] offset  first hex of each row of cells, and the number of hexes
Index CountHexes(const FineCells& cells, Runtime& runtime, std::vector<Index>& offset)
{
  const IndexBox box = cells.Grid().HexBox();
  offset.resize(box.Size(1) * box.Size(2));
  ForRows(runtime, box,
    [&](Index j, Index k, Index row)
    {
      Index count = 0;
      ForCells(cells, j, k,
        [&](const CellRun& run, Index length)
        {
          count += length;
          for (Index i = 0; !cells.StairStep && i < length; ++i)
          {
            count += run.IsSplit(i) ? CountBufferHexes(cells, run.Cell + i, run.Label) : 0;
          }
        });
      offset[row] = count;
    });
  const Index total = MakeOffsets(offset);
  offset.push_back(total);
  return total;
}

/// Writes one point at each of `count` nodes of a row.
void FillPlainPoints(
  const CartesianGrid& grid, const Index3& first, Index count, Index point, Mesh& mesh)
{
  const double* x = grid.Coordinates(0).data() + first[0];
  const double y = grid.Coordinates(1)[first[1]], z = grid.Coordinates(2)[first[2]];
  const Index id = HexIds.PointSlots * grid.NodeKey(first) + 1;
  double* points = mesh.Points.data() + 3 * point;
  Index* ids = mesh.PointIds.data() + point;
  for (Index i = 0; i < count; ++i)
  {
    points[3 * i] = x[i];
    points[3 * i + 1] = y;
    points[3 * i + 2] = z;
    ids[i] = id + HexIds.PointSlots * i;
  }
}

void FillInnerPoints(const FineCells& cells, const Index3& p, Index node, Index point, Mesh& mesh)
{
  const StarLabels labels(cells.StarOf(node));
  for (int rank = 0; rank < labels.Count; ++rank)
  {
    if (!cells.Numbering.HasPoint(node, labels.Label[rank]))
    {
      continue;
    }
    const Vector3 x = StartOfInnerPoint(cells.Grid(), cells.Labels, p, labels.Label[rank]);
    mesh.SetPoint(point++, x, HexIds.PointSlots * cells.Grid().NodeKey(p) + 2 + rank);
  }
}

/// Writes the points of a row of nodes from index `point` on and sets their codes.
void FillPoints(
  const FineCells& cells, Index j, Index k, Index point, PointNumbering& numbering, Mesh& mesh)
{
  ForNodes(
    cells, j, k,
    [&](const Index3& p, Index node, Index count, bool hasPoint)
    {
      numbering.SetCodes(node, count, point, hasPoint ? 1 : 0);
      if (hasPoint)
      {
        FillPlainPoints(cells.Grid(), p, count, point, mesh);
        point += count;
      }
    },
    [&](const Index3& p, Index node)
    {
      numbering.SetCode(node, static_cast<int>(cells.StairStep ? point : ~point));
      mesh.SetPoint(
        point, cells.Grid().NodePoint(p), HexIds.PointSlots * cells.Grid().NodeKey(p) + 1);
      if (!cells.StairStep)
      {
        FillInnerPoints(cells, p, node, point + 1, mesh);
      }
      point += PointsOfMixed(cells, node);
    });
}

Index IdOfCell(const CartesianGrid& grid, const CellRun& run, Index i)
{
  return HexIds.ElementSlots * (grid.CellKey(run.First) + i) + 1;
}

/// Writes the hexes of cells without split nodes, from cell i of a run on.
/// @param id  id of the first hex
void FillPlainHexes(const CellRun& run, Index i, Index count, Index id, Index hex, Mesh& mesh)
{
  const int *a = run.Codes[0] + i, *b = run.Codes[1] + i, *c = run.Codes[2] + i,
            *d = run.Codes[3] + i;
  Index* points = mesh.Elements.data() + 8 * hex;
  Index* ids = mesh.ElementIds.data() + hex;
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
  std::fill_n(mesh.Material.data() + hex, count, run.Label);
}

/// Writes the hexes of cell i of a run from index `hex` on; returns the next index.
Index FillSplitCell(const FineCells& cells, const CellRun& run, Index i, Index hex, Mesh& mesh)
{
  const Index cell = run.Cell + i, id = IdOfCell(cells.Grid(), run, i);
  std::array<Index, 8> inner, surface;
  for (int c = 0; c < 8; ++c)
  {
    surface[c] = cells.Numbering.FirstPoint(cells.Grid().NodeOfCell(cell, c));
    inner[c] = cells.Numbering.InnerPoint(cells.Grid().NodeOfCell(cell, c), run.Label);
  }
  mesh.SetElement(hex++, InVtkOrder(inner), id, run.Label);
  for (int face = 0; face < 6; ++face)
  {
    if (cells.Labels[cells.Grid().Neighbour(cell, face)] != run.Label)
    {
      mesh.SetElement(hex++, InVtkOrder(BufferHex(surface, inner, face)), id + 1 + face, run.Label);
    }
  }
  return hex;
}

/// Writes the hexes of a row of cells from index `hex` on.
void FillHexes(const FineCells& cells, Index j, Index k, Index hex, Mesh& mesh)
{
  ForCells(cells, j, k,
    [&](const CellRun& run, Index length)
    {
      for (Index i = 0, next; i < length; i = next)
      {
        for (next = i; next < length && (cells.StairStep || !run.IsSplit(next)); ++next)
        {
        }
        FillPlainHexes(run, i, next - i, IdOfCell(cells.Grid(), run, i), hex, mesh);
        hex += next - i;
        if (next < length)
        {
          hex = FillSplitCell(cells, run, next++, hex, mesh);
        }
      }
    });
}

HexTopology BuildHexes(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, bool stairStep, PointNumbering& numbering, Runtime& runtime,
  CoarseHexes& coarse, const NearCells* near)
{
  const FineCells cells{ coarse.Levels(), labels, mixed, numbering, stairStep, near };
  const IndexBox box = grid.HexBox();
  HexTopology result;
  result.HasAllCells = near == nullptr;
  Mesh& mesh = result.Hexes;
  CheckIds(grid, mesh.Ids.PointSlots);
  std::vector<Index> firstPoint;
  const Index finePoints = CountPoints(cells, runtime, firstPoint);
  const Index points = finePoints + coarse.NumberOfPoints();
  CheckNumberOfPoints(points, runtime.Group());
  mesh.ResizePoints(points);
  ForRows(runtime, NodesOf(box),
    [&](Index j, Index k, Index row)
    { FillPoints(cells, j, k, firstPoint[row], numbering, mesh); });
  const Index fineHexes = CountHexes(cells, runtime, result.RowOffset);
  mesh.ResizeElements(fineHexes + coarse.NumberOfHexes());
  result.WholeCells = stairStep ? fineHexes : 0;
  ForRows(runtime, box,
    [&](Index j, Index k, Index row) { FillHexes(cells, j, k, result.RowOffset[row], mesh); });
  coarse.Fill(mesh, finePoints, fineHexes,
    { [&](Index node) { return numbering.FirstPoint(node); },
      [&](Index node, int label) { return numbering.InnerPoint(node, label); } });
  return result;
}

} // namespace vfm
