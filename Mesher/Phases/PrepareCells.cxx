#include "Phases/PrepareCells.h"

#include "Levels/PeriodicFields.h"
#include "Phases/PlaceSurfaces.h"
#include "Phases/WidenCells.h"

namespace vfm
{
namespace
{

RemovedRegions RemoveRegions(const MesherJob& job, LevelFields& fields)
{
  if (job.Options.MinimumRegionCells <= 1)
  {
    return {};
  }
  job.Run.Progress(0.0, "Removing small regions");
  return RemoveSmallRegions(fields.Grid, job.Options.MinimumRegionCells, job.Options.IsoValue,
    Partition(fields.Grid, job.Run.Group()), fields.Field.Fractions);
}

/// Divides cells of high aspect ratio. Labels are smooth before: the parts of a slice would keep
/// its steps.
void Divide(const MesherJob& job, const LevelSetup& setup, LevelFields& fields)
{
  if (job.Options.MaximumAspectRatio > 0.0)
  {
    RemoveCopies(job.Run.Group(), fields);
    DivideFields(fields, job.Options.MaximumAspectRatio, job.Options.ChildFractions, job.Run);
    AddCopies(job.Options, setup, job.Run.Group(), fields);
  }
}

/// Refines the cells; those of surfaces by the surfaces, unless the domain repeats.
LevelPlan Refine(const MesherJob& job, Cells& cells)
{
  const int finest = FinestLevel(job, cells);
  const bool usesBodies = cells.Setup.Finest > finest && job.Options.Periodic == 0;
  const std::unique_ptr<const BodySurfaces> bodies =
    usesBodies ? PlaceSurfaces(job, cells) : nullptr;
  return RefineFields(
    job.Options, cells.Setup, cells.Requests, finest, bodies.get(), job.Run, cells.Fields);
}

} // namespace

PreparedCells PrepareCells(const MesherJob& job, Cells& cells)
{
  Ranks& ranks = job.Run.Group();
  LevelFields& fields = cells.Fields;
  AddCopies(job.Options, cells.Setup, ranks, fields);
  Warn(job, DescribeSeams(fields, job.Options.IsoValue, ranks));
  const RemovedRegions removed = RemoveRegions(job, fields);
  if (!cells.Wide.IsUsed()) // labels were smoothed before
  {
    SmoothFields(job, fields);
  }
  Divide(job, cells.Setup, fields);
  MeshOptions options{ job.Options, Refine(job, cells),
    job.Options.UnmeshedMaterial == Unmeshed::Particles };
  Warn(job, DescribeWidths(fields.Grid));
  options.ThinParts = options.ThinParts && !AreLabels(job);
  return { options, removed };
}

} // namespace vfm
