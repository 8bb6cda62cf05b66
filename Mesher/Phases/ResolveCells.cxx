#include "Phases/ResolveCells.h"

#include "Labels/ThinParts.h"
#include "Phases/MakeLevels.h"

namespace vfm
{

LabelArray ResolveCells(const MeshCells& cells, bool keepsSeam, MeshRun& run)
{
  run.Clock.Start("Assigning materials", 0.0);
  LabelArray labels = AssignMaterials(cells.Grid, cells.Fractions, cells.Options.IsoValue);
  std::vector<ThinCell> thin;
  if (KeepsThinParts(cells.Options))
  {
    run.Clock.Start("Finding thin parts", 0.02);
    thin = LabelThinParts(
      cells.Grid, cells.Fractions, cells.Options.LeastThickness, run.Parts, run.TheRuntime, labels);
    ReportThinCells(cells.Grid, thin, run.Group(), run.Report);
  }
  run.Clock.Start("Resolving labels", 0.05);
  ReportFlips(ResolveLabels(cells.Grid, WithClaims(cells.Fractions, labels, thin).Field(), labels,
                run.Parts, run.TheRuntime, nullptr, keepsSeam),
    run.Report);
  return labels;
}

} // namespace vfm
