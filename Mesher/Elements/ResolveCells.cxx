#include "Elements/ResolveCells.h"

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

} // namespace vfm
