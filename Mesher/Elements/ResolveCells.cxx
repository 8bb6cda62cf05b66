#include "Elements/ResolveCells.h"

namespace vfm
{

void ReportFlips(const ResolveReport& resolved, MeshReport& report)
{
  report.FlippedCells = resolved.FlippedCells;
  report.LostCells = resolved.LostCells;
  report.GainedCells = resolved.GainedCells;
  report.ResolveRounds = resolved.Rounds;
}

LabelArray ResolveCells(const MeshCells& cells, bool keepsSeam, MeshRun& run)
{
  run.Clock.Start("Assigning materials", 0.0);
  LabelArray labels = AssignMaterials(cells.Grid, cells.Fractions, cells.Options.IsoValue);
  run.Clock.Start("Resolving labels", 0.05);
  ReportFlips(ResolveLabels(
                cells.Grid, cells.Fractions, labels, run.Parts, run.TheRuntime, nullptr, keepsSeam),
    run.Report);
  return labels;
}

} // namespace vfm
