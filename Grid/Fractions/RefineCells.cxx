#include "Fractions/RefineCells.h"

#include "Base/GlobalIds.h"
#include "Fractions/ChildFractions.h"

namespace vfm
{
namespace
{

constexpr int ReadLayers = GhostLayers / 2; // ghost layers whose cells are divided

/// Field that is divided.
struct ParentField
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const CellDivision& Division;
  ChildRule Rule;
  const KnownChildren& Known;
};

/// Writes the rows of children of a row of cells.
class ChildRows
{
public:
  ChildRows(const ParentField& parents, RefinedCells& refined) : Parents(parents), Refined(refined)
  {
  }

  void Start(const Index3& cell)
  {
    const IndexBox first = this->Parents.Division.Divide(BoxOfCell(cell));
    this->Rows.clear();
    ForRows(first,
      [&](Index j, Index k)
      {
        this->Rows.emplace_back(this->Refined.Fractions);
        this->Rows.back().Start(this->Refined.Grid.Linear({ { first.Lower[0], j, k } }));
      });
  }
  void AddLabel(int label, Index begin, Index end)
  {
    const Index3 first = this->Parents.Grid.Position(begin);
    const Index3 last = { { first[0] + end - begin, first[1] + 1, first[2] + 1 } };
    const Index count = this->Parents.Division.Divide(IndexBox{ first, last }).Size(0);
    for (Writer& row : this->Rows)
    {
      row.AddLabel(label, count);
    }
  }
  void AddMixed(Index cell, const std::vector<ChildFractions>& children)
  {
    const FractionField::Range parts = this->Parents.Fractions.Parts(cell);
    const std::size_t along = children[0].size() / this->Rows.size();
    for (std::size_t c = 0; c < children[0].size(); ++c)
    {
      this->AddChild(parts, children, c, this->Rows[c / along]);
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

  static void AddChild(FractionField::Range parts, const std::vector<ChildFractions>& children,
    std::size_t c, Writer& row)
  {
    std::vector<FractionField::Part> own;
    for (std::size_t p = 0; p < children.size(); ++p)
    {
      if (children[p][c] > 0.0)
      {
        own.push_back({ parts.First[p].Material, children[p][c] });
      }
    }
    row.CopyParts(own);
  }

  const ParentField& Parents;
  RefinedCells& Refined;
  std::vector<Writer> Rows; // y fastest
};

/// Run of cells of a row.
struct CellRun
{
  Index Begin, End; // linear indices
  int Label;        // -1: mixed
};

/// Makes skipped cells void, as runs of their own.
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

/// Lists the runs of the cells of a box, row by row.
std::vector<CellRun> ListRuns(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& box)
{
  std::vector<CellRun> runs;
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      fractions.VisitRuns(first, first + box.Size(0),
        [&runs](Index begin, Index end, int label) {
          runs.push_back({ begin, end, label });
        });
    });
  return runs;
}

/// Returns the fractions of the parts of a mixed cell in its children.
std::vector<ChildFractions> Distribute(const ParentField& parents, const Index3& cell)
{
  if (parents.Known)
  {
    std::vector<ChildFractions> known = parents.Known(cell);
    if (!known.empty())
    {
      return known;
    }
  }
  const Index3 counts = parents.Division.Parts(cell);
  if (parents.Rule == ChildRule::Planes && counts != Index3{ { 1, 1, 1 } })
  {
    return SplitCell(parents.Grid, parents.Fractions, cell, counts);
  }
  std::vector<ChildFractions> children;
  for (const FractionField::Part& part : parents.Fractions.Parts(parents.Grid.Linear(cell)))
  {
    children.emplace_back(counts[0] * counts[1] * counts[2], part.Fraction);
  }
  return children;
}

/// Returns the fractions in the children of the mixed cells among the runs.
std::vector<std::vector<ChildFractions>> Distribute(
  const ParentField& parents, const std::vector<CellRun>& runs, Runtime& runtime)
{
  std::vector<Index> mixed;
  for (const CellRun& run : runs)
  {
    if (run.Label < 0)
    {
      mixed.push_back(run.Begin);
    }
  }
  std::vector<std::vector<ChildFractions>> children(mixed.size());
  ForEach(runtime, mixed.size(),
    [&](Index m) { children[m] = Distribute(parents, parents.Grid.Position(mixed[m])); });
  return children;
}

/// Writes the children of the cells of a layer.
/// @param runs  cells of the layer
/// @param mixed  fractions in the children of its mixed cells
void WriteLayer(const ParentField& parents, const IndexBox& layer, const std::vector<CellRun>& runs,
  const std::vector<std::vector<ChildFractions>>& mixed, RefinedCells& refined)
{
  ChildRows children(parents, refined);
  auto run = runs.begin();
  auto split = mixed.begin();
  ForRows(layer,
    [&](Index j, Index k)
    {
      const Index end = parents.Grid.Linear({ { layer.Upper[0], j, k } });
      children.Start({ { layer.Lower[0], j, k } });
      for (; run != runs.end() && run->End <= end; ++run)
      {
        if (run->Label >= 0)
        {
          children.AddLabel(run->Label, run->Begin, run->End);
          continue;
        }
        children.AddMixed(run->Begin, *split++);
      }
      children.Finish();
    });
}

/// Divides the cells of a box, layer by layer along z.
void Cut(const ParentField& parents, const IndexBox& box,
  const std::function<bool(const Index3&)>& skips, Runtime& runtime, RefinedCells& refined)
{
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    IndexBox layer = box;
    layer.Lower[2] = k;
    layer.Upper[2] = k + 1;
    std::vector<CellRun> runs = ListRuns(parents.Grid, parents.Fractions, layer);
    if (skips)
    {
      SkipCells(parents.Grid, skips, runs);
    }
    WriteLayer(parents, layer, runs, Distribute(parents, runs, runtime), refined);
  }
}

RefinedCells MakeVoidCells(CartesianGrid grid, const FractionField& fractions)
{
  CheckIds(grid, TetIds.ElementSlots);
  FractionField field(grid, fractions.NumberOfMaterials());
  return { std::move(grid), std::move(field) };
}

} // namespace

std::array<std::vector<double>, 3> HalveWidths(
  std::array<std::vector<double>, 3> coordinates, int times)
{
  for (std::vector<double>& x : coordinates)
  {
    for (int time = 0; time < times; ++time)
    {
      x = DivideWidths(x, std::vector<Index>(x.size() - 1, 2));
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

CartesianGrid ChangeLevel(const CartesianGrid& grid, int levels, int ghostLayers)
{
  const CartesianGrid domain = grid.OfDomain();
  const IndexBox copies = ChangeLevel(IndexBox{ {}, grid.Domain().Lower }, levels);
  return grid.WithCells(HalveWidths(domain.Coordinates(), levels),
    ChangeLevel(domain.Owned(), levels), ghostLayers,
    *std::max_element(copies.Upper.begin(), copies.Upper.end()));
}

RefinedCells RefineCells(const CartesianGrid& grid, const FractionField& fractions,
  Runtime& runtime, ChildRule rule, const std::function<bool(const Index3&)>& skips,
  const KnownChildren& known)
{
  const CellDivision halves(grid.Global().Upper, 2);
  RefinedCells refined = MakeVoidCells(ChangeLevel(grid, 1, GhostLayers), fractions);
  Cut({ grid, fractions, halves, rule, known }, grid.Extended(ReadLayers), skips, runtime, refined);
  return refined;
}

RefinedCells DivideCells(const CartesianGrid& grid, const FractionField& fractions,
  const CellDivision& division, Runtime& runtime, ChildRule rule)
{
  RefinedCells refined = MakeVoidCells(
    CartesianGrid(division.Divide(grid.Coordinates()), division.Divide(grid.Owned()), GhostLayers),
    fractions);
  Cut({ grid, fractions, division, rule, {} }, grid.Owned(), {}, runtime, refined);
  return refined;
}

} // namespace vfm
