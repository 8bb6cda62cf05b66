#include "Phases/WidenCells.h"

#include "Labels/SmoothLabels.h"
#include "Levels/PeriodicFields.h"
#include "Options/CellWidths.h"

namespace vfm
{
namespace
{

/// Smooths labels as read, on a domain that may repeat.
void SmoothInput(const MesherJob& job, Cells& cells)
{
  Ranks& ranks = job.Run.Group();
  if (SmoothsLabels(job))
  {
    AddCopies(job.Options, cells.Setup, ranks, cells.Fields);
    SmoothFields(job, cells.Fields);
    RemoveCopies(ranks, cells.Fields);
  }
}

LevelSetup DecideLevels(
  const MesherOptions& options, const GridNodes& nodes, const InputRequests& requests)
{
  return DecideLevels(options.Refinement, options.MaximumLevel, nodes, 0,
    CountPeriodicLevels(options, nodes), requests.Finest);
}

} // namespace

LevelSetup SetUpReading(const InputLevels& levels)
{
  LevelSetup setup;
  setup.Finest = levels.Finest();
  setup.IsUniform = true;
  return setup;
}

void WidenCells(
  const MesherJob& job, const InputRequests& requests, std::vector<StateArray> states, Cells& cells)
{
  const MesherOptions& options = job.Options;
  const InputLevels& levels = job.Input.Levels;
  const StateChoice& choice = job.Input.Arrays.State;
  Ranks& ranks = job.Run.Group();
  job.Run.Progress(0.0, "Replacing cells by wider ones");
  const GridNodes nodes = cells.Fields.Grid.Coordinates();
  GridNodes wide = ReplaceNodes(nodes, *ParseWidths(options.CellWidth));
  const int coarser = std::max(-DecideLevels(options, wide, InputRequests()).Base, 0);
  const WidePlan plan = PlanCells(levels, cells.Fields.Grid, std::move(wide), coarser, ranks);
  cells.Owners = plan.Places;
  cells.State = StoreState(levels, cells.Source, choice, std::move(states),
    NeedsState(choice, options) ? HoldNeeded(plan, cells.Fields, ranks) : cells.Fields, cells.Setup,
    options, cells.Owners, job.Run);
  SmoothInput(job, cells);
  cells.Wide = WidenFields(plan, options.IsoValue, job.Run, cells.Fields);
  WidenState(cells.Fields.Grid, job.Run, cells.State);
  cells.State.InputNodes = nodes;
  cells.Requests = WidenRequests(requests, levels, plan, cells.Fields.Grid, ranks);
  cells.Setup = DecideLevels(options, plan.Nodes, cells.Requests);
  Warn(job, cells.Setup.Warning);
}

void SmoothFields(const MesherJob& job, LevelFields& fields)
{
  if (!SmoothsLabels(job))
  {
    return;
  }
  job.Run.Progress(0.0, "Smoothing labels");
  Warn(job,
    DescribeVolumeError(SmoothLabels(fields.Grid, job.Options.LabelSmoothing,
      Partition(fields.Grid, job.Run.Group()), job.Run, fields.Field.Fractions)));
}

} // namespace vfm
