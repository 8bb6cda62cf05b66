#include "Fractions/ResampleFields.h"

#include "Fractions/FractionSum.h"
#include "Fractions/GhostFractions.h"

namespace vfm
{
namespace
{

constexpr int Mixed = -1; // label of mixed cells, and of cells that overlap several labels

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

/// Sums of fractions whose rounding errors do not grow with the number of cells: the error of each
/// addition is kept (A. Neumaier, ZAMM 54, 1974).
class CarefulSum
{
public:
  void Add(const FractionField& fractions, Index cell, double share)
  {
    fractions.ForParts(cell,
      [&](int material, double fraction)
      {
        const double value = share * fraction;
        Term& term = this->TermOf(material);
        const double next = term.Sum + value;
        term.Error += term.Sum >= value ? (term.Sum - next) + value : (value - next) + term.Sum;
        term.Sum = next;
      });
  }
  /// Returns the parts in the order of their materials.
  std::vector<FractionField::Part> Parts() const
  {
    std::vector<FractionField::Part> parts;
    for (const Term& term : this->Terms)
    {
      parts.push_back({ term.Material, term.Sum + term.Error });
    }
    return parts;
  }

private:
  struct Term
  {
    int Material;
    double Sum, Error;
  };

  Term& TermOf(int material)
  {
    if (this->Last >= this->Terms.size() || this->Terms[this->Last].Material != material)
    {
      const auto at = std::lower_bound(this->Terms.begin(), this->Terms.end(), material,
        [](const Term& term, int m) { return term.Material < m; });
      this->Last = at - this->Terms.begin();
      if (at == this->Terms.end() || at->Material != material)
      {
        this->Terms.insert(at, { material, 0.0, 0.0 });
      }
    }
    return this->Terms[this->Last];
  }

  std::vector<Term> Terms; // in the order of their materials
  std::size_t Last = 0;    // that of the last call
};

/// Row of new cells: its runs, and the sums of its mixed cells in order.
template <class Sum>
struct NewRow
{
  Runs Pieces;
  std::vector<Sum> Mixed;
};

/// Merges the runs of all rows of a box of old cells; ends count from its first cell.
Runs MergeRows(const CartesianGrid& grid, const FractionField& fractions, const IndexBox& box)
{
  Runs all, row, merged;
  ForRows(box,
    [&](Index j, Index k)
    {
      if (all.size() == 1 && all[0].Label == Mixed)
      {
        return;
      }
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

/// Returns the runs of a row of new cells; a cell that overlaps several labels is mixed.
/// @param old  runs of the old cells that the row overlaps; first: the first of these cells
Runs FindPieces(const Runs& old, Index first, const AxisOverlaps& overlaps)
{
  Runs pieces;
  Index cell = overlaps.Lower();
  for (const Run& run : old)
  {
    // New cells inside the run; a cell shared with the next run is mixed.
    const Index inside = std::max(overlaps.EndWithin(first + run.End), cell);
    const Index begun = std::max(overlaps.EndBefore(first + run.End), inside);
    if (cell < inside)
    {
      AddRun(inside - overlaps.Lower(), run.Label, pieces);
    }
    if (inside < begun)
    {
      AddRun(begun - overlaps.Lower(), Mixed, pieces);
    }
    cell = begun;
  }
  return pieces;
}

/// Averages the fractions of the old cells that a new cell overlaps.
template <class Sum>
Sum Average(const CartesianGrid& grid, const FractionField& fractions, const CellOverlaps& overlaps,
  const Index3& cell)
{
  Sum sum;
  const IndexBox old = Overlapped(overlaps, BoxOfCell(cell));
  ForRows(old,
    [&](Index j, Index k)
    {
      const double y = overlaps[1].Share(cell[1], j), z = overlaps[2].Share(cell[2], k);
      const Index row = grid.Linear({ { 0, j, k } });
      for (Index i = old.Lower[0]; i < old.Upper[0]; ++i)
      {
        sum.Add(fractions, row + i, overlaps[0].Share(cell[0], i) * y * z);
      }
    });
  return sum;
}

/// Averages the fractions in a row of new cells.
template <class Sum>
NewRow<Sum> MakeRow(const CartesianGrid& grid, const FractionField& fractions,
  const CellOverlaps& overlaps, const IndexBox& cells)
{
  const IndexBox old = Overlapped(overlaps, cells);
  NewRow<Sum> row;
  row.Pieces = FindPieces(MergeRows(grid, fractions, old), old.Lower[0], overlaps[0]);
  Index begin = 0;
  for (const Run& run : row.Pieces)
  {
    for (Index i = begin; run.Label == Mixed && i < run.End; ++i)
    {
      row.Mixed.push_back(Average<Sum>(
        grid, fractions, overlaps, { { cells.Lower[0] + i, cells.Lower[1], cells.Lower[2] } }));
    }
    begin = run.End;
  }
  return row;
}

template <class Sum>
void StoreRow(const NewRow<Sum>& row, FractionField::RowWriter& writer)
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

/// Returns the cell that contains the middle of each block along an axis.
std::vector<Index> FindHomes(
  const std::vector<double>& from, const std::vector<double>& to, Index block)
{
  const Index count = static_cast<Index>(to.size()) - 1;
  std::vector<Index> homes;
  for (Index first = 0; first < count; first += block)
  {
    const double middle = 0.5 * (to[first] + to[std::min(first + block, count)]);
    homes.push_back(std::upper_bound(from.begin(), from.end(), middle) - from.begin() - 1);
  }
  return homes;
}

/// Returns the number of layers of old cells that a rank needs around the cells that it owns.
Index FindReach(const std::vector<double>& from, const std::vector<double>& to, Index block)
{
  Index reach = 0;
  const std::vector<Index> homes = FindHomes(from, to, block);
  const Index count = static_cast<Index>(to.size()) - 1;
  for (std::size_t b = 0; b < homes.size(); ++b)
  {
    const Index first = static_cast<Index>(b) * block, last = std::min(first + block, count);
    const auto begin = std::upper_bound(from.begin(), from.end(), to[first]) - from.begin() - 1;
    const auto end = std::lower_bound(from.begin(), from.end(), to[last]) - from.begin();
    reach = std::max({ reach, homes[b] - begin, end - 1 - homes[b] });
  }
  return reach;
}

/// Does what MeanFractions does, with sums of a type.
template <class Sum>
FractionField MeansOf(const CartesianGrid& grid, const FractionField& fractions,
  const CellOverlaps& overlaps, const CartesianGrid& to, const IndexBox& box, Runtime& runtime)
{
  FractionField field(to, fractions.NumberOfMaterials());
  if (box.NumberOfCells() == 0)
  {
    return field;
  }
  std::vector<NewRow<Sum>> rows(box.Size(1)); // one per row of a layer
  FractionField::RowWriter writer(field);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    ForEach(runtime, box.Size(1),
      [&](Index row)
      {
        const Index j = box.Lower[1] + row;
        const IndexBox cells{ { { box.Lower[0], j, k } }, { { box.Upper[0], j + 1, k + 1 } } };
        rows[row] = MakeRow<Sum>(grid, fractions, overlaps, cells);
      });
    for (Index row = 0; row < box.Size(1); ++row)
    {
      writer.Start(to.Linear({ { box.Lower[0], box.Lower[1] + row, k } }));
      StoreRow(rows[row], writer);
      writer.Finish();
    }
  }
  return field;
}

} // namespace

FractionField MeanFractions(const CartesianGrid& grid, const FractionField& fractions,
  const CellOverlaps& overlaps, const CartesianGrid& to, const IndexBox& box, Runtime& runtime)
{
  return MeansOf<CarefulSum>(grid, fractions, overlaps, to, box, runtime);
}

FractionField MeanOfBlocks(const CartesianGrid& grid, const FractionField& fractions,
  const CellOverlaps& overlaps, const CartesianGrid& to, const IndexBox& box, Runtime& runtime)
{
  return MeansOf<FractionSum>(grid, fractions, overlaps, to, box, runtime);
}

IndexBox CellsOfOwner(const std::array<std::vector<double>, 3>& from,
  const std::array<std::vector<double>, 3>& to, Index block, const IndexBox& owned)
{
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<Index> homes = FindHomes(from[a], to[a], block);
    const Index count = static_cast<Index>(to[a].size()) - 1;
    const auto firstFrom = [&](Index cell)
    {
      const auto at = std::lower_bound(homes.begin(), homes.end(), cell);
      return std::min(static_cast<Index>(at - homes.begin()) * block, count);
    };
    cells.Lower[a] = firstFrom(owned.Lower[a]);
    cells.Upper[a] = firstFrom(owned.Upper[a]);
  }
  return cells;
}

ResampledFields ResampleFields(const CartesianGrid& grid, const FractionField& fractions,
  const std::array<std::vector<double>, 3>& nodes, Index block, Runtime& runtime)
{
  Index reach = 0;
  for (int a = 0; a < 3; ++a)
  {
    reach = std::max(reach, FindReach(grid.Coordinates(a), nodes[a], block));
  }
  CartesianGrid to(
    nodes, CellsOfOwner(grid.Coordinates(), nodes, block, grid.Owned()), GhostLayers);
  const CellOverlaps overlaps = FindOverlaps(grid.Coordinates(), nodes, to.Owned());
  const auto average = [&](const CartesianGrid& from, const FractionField& values)
  { return MeanFractions(from, values, overlaps, to, to.Owned(), runtime); };
  FractionField means(to, fractions.NumberOfMaterials());
  if (reach <= GhostLayers)
  {
    means = average(grid, fractions);
  }
  else
  {
    ResampledFields wide{ grid, fractions };
    WidenGrid({ static_cast<int>(reach), HexLayers }, runtime.Group(), wide.Grid, wide.Fractions);
    means = average(wide.Grid, wide.Fractions);
  }
  FillGhosts(Partition(to, runtime.Group()), means);
  return { std::move(to), std::move(means) };
}

} // namespace vfm
