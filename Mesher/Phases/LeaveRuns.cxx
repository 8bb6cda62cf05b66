#include "Phases/LeaveRuns.h"

namespace vfm
{

bool CanLeaveRuns(const MesherJob& job, const Cells& cells)
{
  const MesherOptions& options = job.Options;
  const bool isKept = options.ElementOrder == InterpolationOrder::Linear && options.Layers <= 1 &&
    options.Periodic == 0 && !cells.SplitPairs && !cells.Wide.IsUsed();
  const bool hasState = !cells.State.Copied.empty() || cells.State.Conserved ||
    options.UnmeshedMaterial == Unmeshed::Particles;
  return options.Elements == ElementKind::Hexes && isKept && !hasState &&
    (options.ImageAxes || job.Input.Levels.Reading.Frame.IsIdentity()) &&
    job.Run.Group().Count() == 1;
}

void UseLabels(const Materials& table, CellRuns& runs)
{
  for (CellRuns::Run& run : runs.Runs)
  {
    run.Material = table.Labels[run.Material];
  }
}

} // namespace vfm
