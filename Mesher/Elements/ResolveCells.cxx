#include "Elements/ResolveCells.h"

#include "Labels/LeafLabels.h"
#include "Ranks/Agreement.h"

namespace vfm
{

void ReportFlips(const ResolveReport& resolved, MeshReport& report)
{
  report.FlippedCells = resolved.FlippedCells;
  report.LostCells = resolved.LostCells;
  report.GainedCells = resolved.GainedCells;
  report.ResolveRounds = resolved.Rounds;
}

std::vector<ThinCell> LabelThinCells(const MeshCells& cells, MeshRun& run, LabelArray& labels)
{
  if (!KeepsThinParts(cells.Options))
  {
    return {};
  }
  run.Clock.Start("Finding thin parts", 0.02);
  return LabelThinParts(
    cells.Grid, cells.Fractions, cells.Options.LeastThickness, run.Parts, run.TheRuntime, labels);
}

void ReportThinCells(const MeshCells& cells, const std::vector<ThinCell>& thin, MeshRun& run)
{
  if (KeepsThinParts(cells.Options))
  {
    const auto owned = std::count_if(thin.begin(), thin.end(),
      [&](const ThinCell& cell) { return run.Parts.OwnsCell(cells.Grid.Position(cell.Cell)); });
    run.Report.ThinPartCells = SumOverRanks(static_cast<Index>(owned), run.Group());
  }
}

ResolvedCells ResolveCells(const MeshCells& cells, bool keepsSeam, MeshRun& run)
{
  run.Clock.Start("Assigning materials", 0.0);
  LabelArray labels = AssignMaterials(cells.Grid, cells.Fractions, cells.Options.IsoValue);
  const std::vector<ThinCell> thin = LabelThinCells(cells, run, labels);
  ReportThinCells(cells, thin, run);
  run.Clock.Start("Resolving labels", 0.05);
  ReportFlips(ResolveLabels(cells.Grid, WithClaims(cells.Fractions, labels, thin).Field(), labels,
                run.Parts, run.TheRuntime, nullptr, keepsSeam),
    run.Report);
  return { std::move(labels), CellsOf(thin) };
}

CellLabels LabelCellsOfLeaves(const MeshCells& cells, MeshRun& run)
{
  CellLabels result{ AssignMaterials(cells.Grid, cells.Fractions, cells.Options.IsoValue), {}, {} };
  result.ThinLabels = KeepsThinParts(cells.Options) ? result.Labels : LabelArray();
  result.Thin = LabelThinCells(cells, run, result.ThinLabels);
  return result;
}

namespace
{

/// Gives leaves of the finest level the labels of thin parts; larger leaves keep their labels.
/// Returns these leaves.
std::vector<ThinCell> LabelThinLeaves(
  const RefinedGrid& levels, const CellLabels& ofCells, LabelArray& labels)
{
  const CartesianGrid& grid = levels.Finest();
  const LabelUnits units(grid, &levels);
  std::vector<ThinCell> leaves;
  for (const ThinCell& cell : ofCells.Thin)
  {
    const IndexBox leaf = units.CellsOf(units.UnitOf(grid.Position(cell.Cell)));
    if (leaf.NumberOfCells() == 1)
    {
      FillLabels(grid, leaf, ofCells.ThinLabels[cell.Cell], labels);
      leaves.push_back(cell);
    }
  }
  return leaves;
}

} // namespace

ResolvedLeaves ResolveLeaves(const MeshCells& cells, const RefinedGrid& levels,
  const CellLabels& ofCells, bool keepsSeam, MeshRun& run)
{
  LabelArray labels =
    AssignLeafMaterials(levels, cells.Fractions, ofCells.Labels, cells.Options.IsoValue);
  const std::vector<ThinCell> leaves = LabelThinLeaves(levels, ofCells, labels);
  ReportThinCells(cells, leaves, run);
  ResolveReport resolved =
    ResolveLabels(cells.Grid, WithClaims(cells.Fractions, ofCells.ThinLabels, leaves).Field(),
      labels, run.Parts, run.TheRuntime, &levels, keepsSeam);
  ReportFlips(resolved, run.Report);
  return { { std::move(labels), CellsOf(leaves) }, std::move(resolved.CostlyFlips) };
}

} // namespace vfm
