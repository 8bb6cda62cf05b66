#include "Phases/PrepareCells.h"

#include "Fractions/GhostFractions.h"
#include "Labels/SmoothLabels.h"
#include "Levels/PeriodicFields.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double LabelVolumeTolerance = 1e-6; // relative volume error of smoothed labels
constexpr double LargestSafeRatio = 1000.0;   // of widths; no overlaps were seen below

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

void SmoothFields(const MesherJob& job, LevelFields& fields)
{
  if (job.Options.LabelSmoothing <= 0 || !AreLabels(job))
  {
    return;
  }
  job.Run.Progress(0.0, "Smoothing labels");
  const double error = SmoothLabels(fields.Grid, job.Options.LabelSmoothing,
    Partition(fields.Grid, job.Run.Group()), job.Run, fields.Field.Fractions);
  if (error > LabelVolumeTolerance)
  {
    std::ostringstream text;
    text << "Smoothing could not keep the volumes of all labels: the largest error is "
         << 100.0 * error << " %. Fewer passes, or MinimumRegionCells, may help.";
    Warn(job, text.str());
  }
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

/// Returns the number of levels finer than the grid that criteria and selected cells request; adds
/// their families.
int FindRefinements(const MesherJob& job, const LevelSetup& setup, const InputRequests& requests,
  int finer, LevelFields& fields)
{
  const MesherOptions& options = job.Options;
  job.Run.Progress(0.0, "Looking for places to refine");
  const int layers = options.FineInterfaces ? 0 : options.FineLayers;
  RefinementCriteria criteria{ options.ThinCells, options.CurvaturePerCell,
    options.RefineFlippedCells, options.InterfaceLayers, {}, finer };
  WorkTogether(
    job.Run.Group(), [&] { criteria.Chosen = TakeRequests(requests, setup, layers, fields); });
  return finer > 0 ? FindFinerLevels(fields, criteria, options.IsoValue, layers, job.Run) : finer;
}

/// Refines the grid to the finest cells of the mesh, and adds the ghost layers that meshing needs.
LevelPlan Refine(
  const MesherJob& job, const LevelSetup& setup, const InputRequests& requests, LevelFields& fields)
{
  const int top = std::min(setup.Finest, job.Input.Levels.Finest());
  int finer = setup.Finest - top;
  if (job.Options.Refinement == RefinementMode::Automatic)
  {
    finer = FindRefinements(job, setup, requests, finer, fields);
  }
  RefineFields(fields, finer, job.Options.ChildFractions, job.Run);
  LevelPlan plan{ job.Options, 0, {} };
  if (!setup.IsUniform)
  {
    plan.Refinements = top - setup.Base + finer;
    plan.Families = std::move(fields.Families);
  }
  if (InterfacesCrossLevels(plan))
  {
    WidenGrid(LayersFor(plan), job.Run.Group(), fields.Grid, fields.Field.Fractions);
  }
  return plan;
}

/// Warns of cells with widths that differ so much that close bodies may overlap.
void WarnOfWidths(const MesherJob& job, const CartesianGrid& grid)
{
  double ratio = 1.0;
  std::array<std::array<double, 2>, 3> range; // smallest and largest width along each axis
  for (int a = 0; a < 3; ++a)
  {
    range[a] = { { grid.Width(a, 0), grid.Width(a, 0) } };
    for (Index i = 1; i < grid.Global().Upper[a]; ++i)
    {
      range[a][0] = std::min(range[a][0], grid.Width(a, i));
      range[a][1] = std::max(range[a][1], grid.Width(a, i));
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    ratio = std::max({ ratio, range[a][1] / range[b][0], range[b][1] / range[a][0] });
  }
  if (ratio > LargestSafeRatio)
  {
    std::ostringstream text;
    text << "The widths of a cell differ by a factor of " << ratio << ". Above " << LargestSafeRatio
         << ", elements have a poor quality, and bodies that are close may overlap. "
            "MaximumAspectRatio divides such cells.";
    Warn(job, text.str());
  }
}

} // namespace

PreparedCells PrepareCells(const MesherJob& job, Cells& cells)
{
  Ranks& ranks = job.Run.Group();
  LevelFields& fields = cells.Fields;
  AddCopies(job.Options, cells.Setup, ranks, fields);
  Warn(job, DescribeSeams(fields, job.Options.IsoValue, ranks));
  const RemovedRegions removed = RemoveRegions(job, fields);
  SmoothFields(job, fields);
  Divide(job, cells.Setup, fields);
  MeshOptions options{ job.Options, Refine(job, cells.Setup, cells.Requests, fields) };
  options.ThinParts = options.ThinParts && !AreLabels(job);
  WarnOfWidths(job, fields.Grid);
  return { options, removed };
}

} // namespace vfm
