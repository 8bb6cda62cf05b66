#include "Labels/Labels.h"

namespace vfm
{
namespace
{

using FourRows = std::array<LabelArray::RowView, 4>;

/// Copies the outer rows of the local box into the layer around it.
void MirrorRows(const CartesianGrid& grid, LabelArray& labels)
{
  const IndexBox& box = grid.Local();
  const IndexBox rim{ CellOfStar(box.Lower, 0), CornerOfCell(box.Upper, 7) };
  ForRows(rim,
    [&](Index j, Index k)
    {
      const Index3 row{ { box.Lower[0], j, k } }, inside = box.Nearest(row);
      if (inside != row)
      {
        labels.CopyRow(grid.Linear(inside), grid.Linear(row));
      }
    });
}

/// Returns whether four rows, or the p-th pages of four rows, are known to have one label.
bool AreOneLabel(const FourRows& rows)
{
  return std::all_of(rows.begin(), rows.end(),
    [&](const LabelArray::RowView& row) { return row.IsUniform() && row[0] == rows[0][0]; });
}
bool AreOneLabel(const FourRows& rows, Index p)
{
  return std::all_of(rows.begin(), rows.end(),
    [&](const LabelArray::RowView& row)
    { return row.IsUniform(p) && row.Page(p)[0] == rows[0].Page(p)[0]; });
}

/// Adds the mixed nodes of a row, except its first node. first: the first node; size: number of
/// nodes; rows: the cells around the row.
void AddMixedNodes(Index first, Index size, const FourRows& rows, std::vector<Index>& mixed)
{
  if (AreOneLabel(rows))
  {
    return;
  }
  constexpr Index PageSize = LabelArray::PageSize;
  bool before = false; // whether the four cells of the previous column differ
  int label = rows[0][0];
  for (Index p = 0; p * PageSize < size; ++p)
  {
    const Index start = first + p * PageSize, count = std::min(PageSize, size - p * PageSize);
    const int* row = rows[0].Page(p);
    const bool isFirst = p == 0;
    if (AreOneLabel(rows, p))
    {
      if (!isFirst && (before || row[0] != label))
      {
        mixed.push_back(start);
      }
      before = false;
      label = row[0];
      continue;
    }
    std::array<bool, PageSize> differs;
    const int *b = rows[1].Page(p), *c = rows[2].Page(p), *d = rows[3].Page(p);
    for (Index i = 0; i < PageSize; ++i)
    {
      differs[i] = ((row[i] ^ b[i]) | (row[i] ^ c[i]) | (row[i] ^ d[i])) != 0;
    }
    for (Index i = 0; i < count; ++i)
    {
      if ((differs[i] || before || row[i] != label) && !(isFirst && i == 0))
      {
        mixed.push_back(start + i);
      }
      before = differs[i];
      label = row[i];
    }
  }
}

} // namespace

LabelArray AssignMaterials(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue)
{
  LabelArray labels(grid, 0);
  const IndexBox& box = grid.Local();
  std::vector<int> values;
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } }), last = first + box.Size(0);
      // Each run includes its mirrored cell, so that rows of one label are written as one run.
      const auto begins = [&](Index begin) { return begin - (begin == first); };
      const auto ends = [&](Index end) { return end + (end == last); };
      fractions.Visit(
        first, last,
        [&](Index begin, Index end, int label) { labels.Fill(begins(begin), ends(end), label); },
        [&](Index begin, Index end)
        {
          values.clear();
          for (Index cell = begin; cell < end; ++cell)
          {
            values.push_back(MaterialOfCell(fractions, cell, isoValue));
          }
          if (begin == first)
          {
            values.insert(values.begin(), values.front());
          }
          values.push_back(values.back()); // read only where it is the mirrored cell
          labels.Write(begins(begin), ends(end), values.data());
        });
    });
  MirrorRows(grid, labels);
  return labels;
}

std::vector<Index> FindMixedNodes(const CartesianGrid& grid, const LabelArray& labels)
{
  std::vector<Index> mixed;
  const IndexBox& box = grid.Local();
  ForRows(NodesOf(box),
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0] - 1, j, k } });
      const Index y = grid.Stride(1), z = grid.Stride(2);
      AddMixedNodes(first, box.Size(0) + 2,
        { { labels.Row(first), labels.Row(first - y), labels.Row(first - z),
          labels.Row(first - y - z) } },
        mixed);
    });
  return mixed;
}

} // namespace vfm
