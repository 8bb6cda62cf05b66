#include "Fractions/CoarsenFields.h"

#include "Fractions/FractionSum.h"
#include "Fractions/RefineCells.h"

namespace vfm
{
namespace
{

constexpr int Mixed = -1; // label of mixed cells, and of blocks with several labels

/// Cells of a row, from the end of the previous run to End.
struct Run
{
  Index End;
  int Label;
};
using Runs = std::vector<Run>;

void AddRun(Index end, int label, Runs& runs)
{
  if (!runs.empty() && runs.back().Label == label)
  {
    runs.back().End = end;
    return;
  }
  runs.push_back({ end, label });
}

/// Finds the runs of the cells [first, last) of a row; ends count from first.
void FindRuns(const FractionField& fractions, Index first, Index last, Runs& runs)
{
  runs.clear();
  fractions.VisitRuns(
    first, last, [&](Index, Index end, int label) { AddRun(end - first, label, runs); });
}

/// Merges the runs of two rows: cells keep the label on which both agree, others are mixed.
void Merge(const Runs& a, const Runs& b, Runs& merged)
{
  merged.clear();
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();)
  {
    const Index end = std::min(a[i].End, b[j].End);
    AddRun(end, a[i].Label == b[j].Label ? a[i].Label : Mixed, merged);
    i += a[i].End == end;
    j += b[j].End == end;
  }
}

/// Row of coarse cells: its runs, and the sums of its mixed cells in order.
struct CoarseRow
{
  Runs Pieces;
  std::vector<FractionSum> Mixed;
};

void AddMixed(Index end, Runs& pieces)
{
  if ((pieces.empty() ? 0 : pieces.back().End) < end)
  {
    AddRun(end, Mixed, pieces);
  }
}

/// Merges the runs of all rows of a box of fine cells.
Runs MergeRows(const CartesianGrid& grid, const FractionField& fractions, const IndexBox& box)
{
  Runs all, row, merged;
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      FindRuns(fractions, first, first + box.Size(0), row);
      if (all.empty())
      {
        all.swap(row);
        return;
      }
      Merge(all, row, merged);
      all.swap(merged);
    });
  return all;
}

/// Returns the runs of a row of coarse cells; a cell with several labels is mixed.
/// @param fine  runs of its fine cells, factor for each coarse cell
Runs CoarsenRuns(const Runs& fine, Index factor)
{
  Runs pieces;
  Index begin = 0;
  for (const Run& run : fine)
  {
    // Coarse cells inside the run; a cell shared with the previous run is mixed.
    const Index first = (begin + factor - 1) / factor, last = run.End / factor;
    if (run.Label != Mixed && first < last)
    {
      AddMixed(first, pieces);
      AddRun(last, run.Label, pieces);
    }
    begin = run.End;
  }
  AddMixed(begin / factor, pieces);
  return pieces;
}

/// Averages the fractions of the fine cells in a coarse cell.
/// @param widths  widths of the coarse cell
FractionSum Average(const CartesianGrid& grid, const FractionField& fractions,
  const IndexBox& cells, const Vector3& widths)
{
  FractionSum sum;
  ForCells(cells,
    [&](const Index3& p)
    {
      double share = 1.0;
      for (int a = 0; a < 3; ++a)
      {
        share *= grid.Width(a, p[a]) / widths[a];
      }
      sum.Add(fractions, grid.Linear(p), share);
    });
  return sum;
}

/// Averages the fractions in a row of cells of a coarse grid, 2^halvings times as wide.
CoarseRow MakeRow(const CartesianGrid& grid, const FractionField& fractions, int halvings,
  const CartesianGrid& coarse, const IndexBox& cells)
{
  CoarseRow row;
  row.Pieces =
    CoarsenRuns(MergeRows(grid, fractions, ChangeLevel(cells, halvings)), Index(1) << halvings);
  Index begin = 0;
  for (const Run& run : row.Pieces)
  {
    for (Index i = begin; run.Label == Mixed && i < run.End; ++i)
    {
      const Index3 cell{ { cells.Lower[0] + i, cells.Lower[1], cells.Lower[2] } };
      const Vector3 widths{ { coarse.Width(0, cell[0]), coarse.Width(1, cell[1]),
        coarse.Width(2, cell[2]) } };
      row.Mixed.push_back(Average(grid, fractions, ChangeLevel(BoxOfCell(cell), halvings), widths));
    }
    begin = run.End;
  }
  return row;
}

void StoreRow(const CoarseRow& row, FractionField::RowWriter& writer)
{
  auto sum = row.Mixed.begin();
  Index begin = 0;
  for (const Run& run : row.Pieces)
  {
    if (run.Label != Mixed)
    {
      writer.AddLabel(run.Label, run.End - begin);
    }
    for (Index i = begin; run.Label == Mixed && i < run.End; ++i, ++sum)
    {
      writer.CopyParts(sum->Parts());
    }
    begin = run.End;
  }
}

} // namespace

CartesianGrid CoarsenGrid(const CartesianGrid& grid, int halvings, int ghostLayers)
{
  if (halvings == 0)
  {
    return CartesianGrid(grid, grid.Owned(), ghostLayers);
  }
  const Index factor = Index(1) << halvings;
  for (int a = 0; a < 3; ++a)
  {
    for (Index n : { grid.Domain().Lower[a], grid.Domain().Upper[a], grid.Owned().Lower[a],
           grid.Owned().Upper[a] })
    {
      if (n % factor != 0)
      {
        throw InputError("A grid of " + std::to_string(grid.Domain().Size(a)) +
          " cells along an axis, or a rank's part of it, does not consist of blocks of " +
          std::to_string(factor) + ": use fewer levels.");
      }
    }
  }
  return ChangeLevel(grid, -halvings, ghostLayers);
}

int CountCoarseGhosts(const CartesianGrid& grid, int halvings, int most)
{
  Index levels = most;
  for (int a = 0; a < 3; ++a)
  {
    const Index low = grid.Local().Lower[a], high = grid.Local().Upper[a];
    if (low > 0 || grid.Period(a) > 0)
    {
      levels = std::min(levels, (grid.Owned().Lower[a] - low) >> halvings);
    }
    if (high < grid.Global().Upper[a] || grid.Period(a) > 0)
    {
      levels = std::min(levels, (high - grid.Owned().Upper[a]) >> halvings);
    }
  }
  return static_cast<int>(levels);
}

FractionField CoarsenFractions(const CartesianGrid& grid, const FractionField& fractions,
  int halvings, const CartesianGrid& coarse, Runtime& runtime)
{
  FractionField field(coarse, fractions.NumberOfMaterials());
  const IndexBox& box = coarse.Local();
  if (box.NumberOfCells() == 0)
  {
    return field;
  }
  std::vector<CoarseRow> rows(box.Size(1)); // one per row of a layer
  FractionField::RowWriter writer(field);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    ForEach(runtime, box.Size(1),
      [&](Index row)
      {
        const Index j = box.Lower[1] + row;
        const IndexBox cells{ { { box.Lower[0], j, k } }, { { box.Upper[0], j + 1, k + 1 } } };
        rows[row] = MakeRow(grid, fractions, halvings, coarse, cells);
      });
    for (Index row = 0; row < box.Size(1); ++row)
    {
      writer.Start(coarse.Linear({ { box.Lower[0], box.Lower[1] + row, k } }));
      StoreRow(rows[row], writer);
      writer.Finish();
    }
  }
  return field;
}

} // namespace vfm
