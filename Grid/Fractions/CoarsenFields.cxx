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

struct Work
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const CartesianGrid& Coarse;
  const int Halvings;
  const Index Factor = Index(1) << Halvings;
};

void AddMixed(Index end, Runs& pieces)
{
  if ((pieces.empty() ? 0 : pieces.back().End) < end)
  {
    AddRun(end, Mixed, pieces);
  }
}

/// Merges the runs of all rows of fine cells in a row of coarse cells.
Runs MergeRows(const Work& work, Index j, Index k)
{
  const IndexBox& box = work.Coarse.Local();
  Runs all, row, merged;
  const IndexBox rows{ { { box.Lower[0], j, k } }, { { box.Upper[0], j + 1, k + 1 } } };
  ForRows(ChangeLevel(rows, work.Halvings),
    [&](Index y, Index z)
    {
      const Index first = work.Grid.Linear({ { box.Lower[0] * work.Factor, y, z } });
      FindRuns(work.Fractions, first, first + box.Size(0) * work.Factor, row);
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

FractionSum Average(const Work& work, const Index3& cell)
{
  FractionSum sum;
  ForCells(ChangeLevel(BoxOfCell(cell), work.Halvings),
    [&](const Index3& p)
    {
      double share = 1.0;
      for (int a = 0; a < 3; ++a)
      {
        share *= work.Grid.Width(a, p[a]) / work.Coarse.Width(a, cell[a]);
      }
      sum.Add(work.Fractions, work.Grid.Linear(p), share);
    });
  return sum;
}

void MakeRow(const Work& work, Index j, Index k, CoarseRow& row)
{
  row = CoarseRow();
  const IndexBox& box = work.Coarse.Local();
  Index begin = 0;
  for (const Run& run : MergeRows(work, j, k))
  {
    // Coarse cells inside the run; a cell shared with the previous run is mixed.
    const Index first = (begin + work.Factor - 1) / work.Factor, last = run.End / work.Factor;
    if (run.Label != Mixed && first < last)
    {
      AddMixed(first, row.Pieces);
      AddRun(last, run.Label, row.Pieces);
    }
    begin = run.End;
  }
  AddMixed(box.Size(0), row.Pieces);
  begin = 0;
  for (const Run& run : row.Pieces)
  {
    for (Index i = begin; run.Label == Mixed && i < run.End; ++i)
    {
      row.Mixed.push_back(Average(work, { { box.Lower[0] + i, j, k } }));
    }
    begin = run.End;
  }
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
  const Work work{ grid, fractions, coarse, halvings };
  const IndexBox& box = coarse.Local();
  if (box.NumberOfCells() == 0)
  {
    return field;
  }
  std::vector<CoarseRow> rows(box.Size(1)); // one per row of a layer
  FractionField::RowWriter writer(field);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    ForEach(
      runtime, box.Size(1), [&](Index row) { MakeRow(work, box.Lower[1] + row, k, rows[row]); });
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
