#include "Fractions/RefineCells.h"

#include "Base/GlobalIds.h"
#include "Fractions/ChildFractions.h"

namespace vfm
{
namespace
{

constexpr int ReadLayers = GhostLayers / 2; // coarse ghost layers whose cells are cut

/// The four rows of children of a row of cells.
class ChildRows
{
public:
  ChildRows(const FractionField& fractions, RefinedCells& refined) :
    Fractions(fractions),
    Refined(refined),
    Rows{ { Writer(refined.Fractions), Writer(refined.Fractions), Writer(refined.Fractions),
      Writer(refined.Fractions) } }
  {
  }

  void Start(const Index3& cell)
  {
    for (int r = 0; r < 4; ++r)
    {
      this->Rows[r].Start(this->Refined.Grid.Linear(ChildOfCell(cell, 2 * r)));
    }
  }
  void AddLabel(int label, Index count)
  {
    for (Writer& row : this->Rows)
    {
      row.AddLabel(label, 2 * count);
    }
  }
  void AddMixed(Index cell, const std::vector<OctantFractions>& octants)
  {
    const FractionField::Range parts = this->Fractions.Parts(cell);
    for (int c = 0; c < 8; ++c)
    {
      this->AddChild(parts, octants, c);
    }
  }
  void Finish()
  {
    for (Writer& row : this->Rows)
    {
      row.Finish();
    }
  }

private:
  using Writer = FractionField::RowWriter;

  void AddChild(FractionField::Range parts, const std::vector<OctantFractions>& octants, int c)
  {
    std::vector<FractionField::Part> own;
    for (std::size_t p = 0; p < octants.size(); ++p)
    {
      if (octants[p][c] > 0.0)
      {
        own.push_back({ parts.First[p].Material, octants[p][c] });
      }
    }
    this->Rows[c / 2].CopyParts(own);
  }

  const FractionField& Fractions;
  RefinedCells& Refined;
  std::array<Writer, 4> Rows; // cy + 2 cz
};

/// A run of cells of a row.
struct CellRun
{
  Index Begin, End; // linear
  int Label;        // -1: mixed
};

/// The runs of row (j, k) of a box; mixed ones hold one cell.
void FindRuns(const CartesianGrid& grid, const FractionField& fractions, const IndexBox& box,
  Index j, Index k, std::vector<CellRun>& runs)
{
  const Index first = grid.Linear({ { box.Lower[0], j, k } });
  fractions.Visit(
    first, first + box.Size(0),
    [&](Index begin, Index end, int label) {
      runs.push_back({ begin, end, label });
    },
    [&](Index begin, Index end)
    {
      for (Index cell = begin; cell < end; ++cell)
      {
        runs.push_back({ cell, cell + 1, fractions.IsMixed(cell) ? -1 : fractions.Label(cell) });
      }
    });
}

/// Makes the cells that are skipped void, in runs of their own.
void SkipCells(const CartesianGrid& grid, const std::function<bool(const Index3&)>& skips,
  std::vector<CellRun>& runs)
{
  std::vector<CellRun> cut;
  for (const CellRun& run : runs)
  {
    Index3 p = grid.Position(run.Begin);
    for (Index cell = run.Begin; cell < run.End; ++cell, ++p[0])
    {
      const int label = skips(p) ? 0 : run.Label;
      const bool joins = label >= 0 && cell > run.Begin && cut.back().Label == label;
      if (joins)
      {
        cut.back().End = cell + 1;
      }
      else
      {
        cut.push_back({ cell, cell + 1, label });
      }
    }
  }
  runs = std::move(cut);
}

/// The parts of a mixed cell in its octants.
std::vector<OctantFractions> ShareOut(
  const CartesianGrid& grid, const FractionField& fractions, const Index3& cell, ChildRule rule)
{
  if (rule == ChildRule::Planes)
  {
    return SplitCell(grid, fractions, cell);
  }
  std::vector<OctantFractions> octants;
  for (const FractionField::Part& part : fractions.Parts(grid.Linear(cell)))
  {
    octants.emplace_back();
    octants.back().fill(part.Fraction);
  }
  return octants;
}

/// Cuts the cells of a layer along z.
void RefineLayer(const CartesianGrid& grid, const FractionField& fractions, Index k,
  Runtime& runtime, ChildRule rule, const std::function<bool(const Index3&)>& skips,
  RefinedCells& refined)
{
  const IndexBox box = grid.Extended(ReadLayers);
  std::vector<CellRun> runs;
  for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
  {
    FindRuns(grid, fractions, box, j, k, runs);
  }
  if (skips)
  {
    SkipCells(grid, skips, runs);
  }
  std::vector<Index> mixed;
  for (const CellRun& run : runs)
  {
    if (run.Label < 0)
    {
      mixed.push_back(run.Begin);
    }
  }
  std::vector<std::vector<OctantFractions>> octants(mixed.size());
  ForEach(runtime, mixed.size(),
    [&](Index m) { octants[m] = ShareOut(grid, fractions, grid.Position(mixed[m]), rule); });
  ChildRows children(fractions, refined);
  auto run = runs.begin();
  auto split = octants.begin();
  for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
  {
    const Index end = grid.Linear({ { box.Upper[0], j, k } });
    children.Start({ { box.Lower[0], j, k } });
    for (; run != runs.end() && run->End <= end; ++run)
    {
      if (run->Label >= 0)
      {
        children.AddLabel(run->Label, run->End - run->Begin);
        continue;
      }
      children.AddMixed(run->Begin, *split++);
    }
    children.Finish();
  }
}

} // namespace

std::array<std::vector<double>, 3> HalveWidths(
  std::array<std::vector<double>, 3> coordinates, int times)
{
  for (std::vector<double>& x : coordinates)
  {
    for (int time = 0; time < times; ++time)
    {
      std::vector<double> halved;
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
      {
        halved.push_back(x[i]);
        halved.push_back(x[i] + 0.5 * (x[i + 1] - x[i]));
      }
      halved.push_back(x.back());
      x = std::move(halved);
    }
    const std::size_t step = std::size_t(1) << std::max(-times, 0);
    std::vector<double> joined;
    for (std::size_t i = 0; step > 1 && i < x.size(); i += step)
    {
      joined.push_back(x[i]);
    }
    if (step > 1)
    {
      x = std::move(joined);
    }
  }
  return coordinates;
}

RefinedCells RefineCells(const CartesianGrid& grid, const FractionField& fractions,
  Runtime& runtime, ChildRule rule, const std::function<bool(const Index3&)>& skips)
{
  CartesianGrid halved(HalveWidths(grid.Coordinates()), ChangeLevel(grid.Owned(), 1), GhostLayers);
  CheckIds(halved, TetIds.ElementSlots);
  FractionField field(halved, fractions.NumberOfMaterials());
  RefinedCells refined{ std::move(halved), std::move(field) };
  const IndexBox box = grid.Extended(ReadLayers);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    RefineLayer(grid, fractions, k, runtime, rule, skips, refined);
  }
  return refined;
}

} // namespace vfm
