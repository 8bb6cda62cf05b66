#include "Phases/WidenCells.h"

#include "Input/InputRoute.h"
#include "Labels/SmoothLabels.h"
#include "Levels/NewCells.h"
#include "Levels/PeriodicFields.h"

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
  const InputLevels& input = cells.Input;
  const StateChoice& choice = job.Input.Arrays.State;
  Ranks& ranks = job.Run.Group();
  CheckMaterialWidths(options);
  job.Run.Progress(0.0, "Replacing cells by wider ones");
  const GridNodes nodes = cells.Fields.Grid.Coordinates();
  const CellSizes sizes = PlanNewCells(options, cells.Fields,
    CountCells(cells.Fields.Grid, cells.Fields.Field.Fractions, options.IsoValue, ranks), job.Run);
  const WidePlan plan = PlanCells(input, cells.Fields.Grid, sizes.Nodes, sizes.Halvings);
  cells.Owners = FindOwners(plan.Place, RepeatingAxes(options), ranks, cells.Input);
  cells.State = StoreState(input, cells.Source, choice, std::move(states),
    NeedsState(choice, options) ? HoldNeeded(plan, cells.Fields, ranks) : cells.Fields, cells.Setup,
    options, cells.Owners, job.Run);
  SmoothInput(job, cells);
  cells.Wide = WidenFields(plan, sizes, options.IsoValue, job.Run, cells.Fields);
  WidenState(cells.Fields.Grid, job.Run, cells.State);
  cells.State.InputNodes = nodes;
  cells.Requests = WidenRequests(requests, input, cells.Owners, cells.Fields.Grid, ranks);
  cells.Setup = SetUpNewLevels(options, sizes, cells.Requests, cells.Fields);
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
