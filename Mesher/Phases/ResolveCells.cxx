#include "Phases/ResolveCells.h"

#include "Phases/MakeLevels.h"

namespace vfm
{

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
