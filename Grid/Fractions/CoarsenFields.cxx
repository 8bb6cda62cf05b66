#include "Fractions/CoarsenFields.h"

#include "Fractions/FractionSum.h"
#include "Fractions/RefineCells.h"

namespace vfm
{
namespace
{

constexpr int Mixed = -1; // label of cells of several parts, or of several labels

/// Cells from the end of the run before, up to End, in a row.
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

/// The runs of the cells [first, last) of a row; ends count from first.
void FindRuns(const FractionField& fractions, Index first, Index last, Runs& runs)
{
  runs.clear();
  fractions.VisitRuns(
    first, last, [&](Index, Index end, int label) { AddRun(end - first, label, runs); });
}

/// Runs where two rows agree keep their label, the others are mixed.
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

/// A row of coarse cells: runs of them, and those that are mixed, in their order.
struct CoarseRow
{
  Runs Pieces;
  std::vector<FractionSum> Mixed;
};

class Coarsener
{
public:
  Coarsener(const CartesianGrid& grid, const FractionField& fractions, int halvings,
    const CartesianGrid& coarse) :
    Grid(grid),
    Fractions(fractions),
    Coarse(coarse),
    Halvings(halvings),
    Factor(Index(1) << halvings)
  {
  }

  void MakeRow(Index j, Index k, CoarseRow& row) const
  {
    row = CoarseRow();
    const IndexBox& box = this->Coarse.Local();
    Index begin = 0;
    for (const Run& run : this->MergeRows(j, k))
    {
      // whole cells of the run; those that it shares with the one before are mixed
      const Index first = (begin + this->Factor - 1) / this->Factor, last = run.End / this->Factor;
      if (run.Label != Mixed && first < last)
      {
        this->AddMixed(first, row.Pieces);
        AddRun(last, run.Label, row.Pieces);
      }
      begin = run.End;
    }
    this->AddMixed(box.Size(0), row.Pieces);
    begin = 0;
    for (const Run& run : row.Pieces)
    {
      for (Index i = begin; run.Label == Mixed && i < run.End; ++i)
      {
        row.Mixed.push_back(this->Average({ { box.Lower[0] + i, j, k } }));
      }
      begin = run.End;
    }
  }

private:
  static void AddMixed(Index end, Runs& pieces)
  {
    if ((pieces.empty() ? 0 : pieces.back().End) < end)
    {
      AddRun(end, Mixed, pieces);
    }
  }

  /// Of the rows of the grid's cells in a row of coarse ones.
  Runs MergeRows(Index j, Index k) const
  {
    const IndexBox& box = this->Coarse.Local();
    Runs all, row, merged;
    const IndexBox rows{ { { box.Lower[0], j, k } }, { { box.Upper[0], j + 1, k + 1 } } };
    ForRows(ChangeLevel(rows, this->Halvings),
      [&](Index y, Index z)
      {
        const Index first = this->Grid.Linear({ { box.Lower[0] * this->Factor, y, z } });
        FindRuns(this->Fractions, first, first + box.Size(0) * this->Factor, row);
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

  FractionSum Average(const Index3& cell) const
  {
    FractionSum sum;
    ForCells(ChangeLevel(BoxOfCell(cell), this->Halvings),
      [&](const Index3& p)
      {
        double share = 1.0;
        for (int a = 0; a < 3; ++a)
        {
          share *= this->Grid.Width(a, p[a]) / this->Coarse.Width(a, cell[a]);
        }
        sum.Add(this->Fractions, this->Grid.Linear(p), share);
      });
    return sum;
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const CartesianGrid& Coarse;
  int Halvings;
  Index Factor;
};

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
  const Index factor = Index(1) << halvings;
  for (int a = 0; a < 3; ++a)
  {
    for (Index n : { grid.Global().Upper[a], grid.Owned().Lower[a], grid.Owned().Upper[a] })
    {
      if (n % factor != 0)
      {
        throw InputError("A grid of " + std::to_string(grid.Global().Upper[a]) +
          " cells along an axis, or a rank's part of it, does not consist of blocks of " +
          std::to_string(factor) + ": use fewer levels.");
      }
    }
  }
  return CartesianGrid(
    HalveWidths(grid.Coordinates(), -halvings), ChangeLevel(grid.Owned(), -halvings), ghostLayers);
}

int CountCoarseGhosts(const CartesianGrid& grid, int halvings, int most)
{
  Index levels = most;
  for (int a = 0; a < 3; ++a)
  {
    const Index low = grid.Local().Lower[a], high = grid.Local().Upper[a];
    if (low > 0)
    {
      levels = std::min(levels, (grid.Owned().Lower[a] - low) >> halvings);
    }
    if (high < grid.Global().Upper[a])
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
  const Coarsener coarsener(grid, fractions, halvings, coarse);
  const IndexBox& box = coarse.Local();
  if (box.NumberOfCells() == 0)
  {
    return field;
  }
  std::vector<CoarseRow> rows(box.Size(1)); // of a layer
  FractionField::RowWriter writer(field);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    ForEach(runtime, box.Size(1),
      [&](Index row) { coarsener.MakeRow(box.Lower[1] + row, k, rows[row]); });
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
