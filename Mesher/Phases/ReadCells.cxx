#include "Phases/ReadCells.h"

#include "Input/InputFractions.h"
#include "Input/InputLabels.h"
#include "Input/InputRoute.h"
#include "Levels/GreyLabels.h"
#include "Levels/LevelSets.h"
#include "Levels/NewCells.h"
#include "Levels/PeriodicFields.h"
#include "Materials/ZeroLabels.h"
#include "Options/SetOptions.h"
#include "Options/ValueRanges.h"
#include "Phases/WidenCells.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Returns the blocks with the fractions of level sets; none if the arrays are no level sets.
/// @pre Collective
std::vector<InputBlocks> ConvertLevelSets(
  const MesherJob& job, const std::vector<InputBlocks>& levels)
{
  const LevelSetRule rule = job.Options.LevelSets;
  if (rule == LevelSetRule::Off)
  {
    return {};
  }
  if (AreLabels(job))
  {
    throw InputError("LevelSets applies to arrays that are chosen as volume fractions, not to "
                     "labels. Choose the level sets as fractions, one per material.");
  }
  return FractionsOfLevelSets(levels,
    { job.Input.Arrays.Fractions, rule, job.Options.LevelSetInside == LevelSetSign::Positive },
    job.Run);
}

LevelCells OpenCells(const MesherJob& job, const std::vector<InputBlocks>& levels)
{
  if (!AreLabels(job) && !job.Options.Threshold.empty())
  {
    throw InputError(
      "Threshold makes materials of ranges of the values of one array, which must be "
      "chosen as labels (" +
      job.Input.Arrays.LabelsOption + " ARRAY), not as volume fractions.");
  }
  const MesherArrays& arrays = job.Input.Arrays;
  Ranks& ranks = job.Run.Group();
  return AreLabels(job) ? OpenLabels(levels,
                            { arrays.Labels, *ParseRanges(job.Options.Threshold),
                              job.Options.ZeroLabel == ZeroLabelMeaning::Material },
                            ranks)
                        : OpenFractions(levels, arrays.Fractions, job.Options.FractionTolerance,
                            arrays.LabelsOption, ranks);
}

/// Warns if label 0 may be a material.
void NoteZeroLabel(const MesherJob& job)
{
  const MesherArrays& arrays = job.Input.Arrays;
  if (AreLabels(job) && job.Options.Threshold.empty() &&
    job.Options.ZeroLabel == ZeroLabelMeaning::Void && !arrays.IsZeroVoid)
  {
    Warn(job, DescribeZeroLabel(job.Input.Levels.Levels[0], arrays.Labels, job.Run.Group()));
  }
}

/// Checks whether values look like grey values: an error if the user did not select the array,
/// otherwise a warning.
std::string CheckGreyValues(const MesherJob& job, const LevelFields& fields)
{
  const MesherArrays& arrays = job.Input.Arrays;
  const bool areLabels = AreLabels(job);
  if (areLabels ? !job.Options.Threshold.empty() : arrays.Fractions.size() != 1)
  {
    return "";
  }
  const ArrayChoice choice{ areLabels ? arrays.Labels : arrays.Fractions[0], arrays.LabelsOption,
    arrays.AreGuessed };
  if (job.Options.LevelSets != LevelSetRule::Off)
  {
    return "";
  }
  return areLabels ? CheckGreyLabels(fields, choice, job.Run.Group())
                   : CheckGreyFractions(fields, choice, job.Input.Levels, job.Run.Group());
}

LevelSetup SetUpLevels(const MesherJob& job, const InputRequests& requests)
{
  const InputLevels& levels = job.Input.Levels;
  const InputBlocks& coarsest = levels.Levels[0];
  const int alignment =
    job.Input.StaysInPlace ? CountAlignedLevels(coarsest.Boxes(), job.Run.Group()) : AnyLevel;
  const int periodic = CountPeriodicLevels(job.Options, coarsest.Coordinates);
  LevelSetup setup = DecideLevels(job.Options.Refinement, job.Options.MaximumLevel,
    coarsest.Coordinates, levels.Finest(), std::min(alignment, periodic), requests.Finest);
  Warn(job, setup.Warning);
  return setup;
}

/// Decides which cells each rank meshes.
/// @param[in,out] levels  gets the blocks near the cells of this rank
/// @return cells of level 0, of this rank and of ranks near it
/// @pre Collective
std::vector<BlockPlace> ChooseOwners(
  const MesherJob& job, const LevelCells& source, const LevelSetup& setup, InputLevels& levels)
{
  Ranks& ranks = job.Run.Group();
  const bool staysInPlace = job.Input.StaysInPlace;
  if (staysInPlace && !ReplacesCells(job.Options))
  {
    return levels.Levels[0].Places; // of the neighbours that the host named
  }
  const IndexBox owned = staysInPlace ? BoxOfRank(levels.Levels[0].Places, ranks.Rank())
                                      : DistributeCells(levels, source, setup, ranks);
  return FindOwners(owned, RepeatingAxes(job.Options), ranks, levels);
}

} // namespace

std::unique_ptr<Cells> ReadCells(const MesherJob& job)
{
  InputLevels levels = job.Input.Levels; // a copy, with other Places
  const MesherArrays& arrays = job.Input.Arrays;
  const MesherOptions& options = job.Options;
  Ranks& ranks = job.Run.Group();
  std::vector<InputBlocks> levelSets = ConvertLevelSets(job, levels.Levels);
  LevelCells source = OpenCells(job, levelSets.empty() ? levels.Levels : levelSets);
  NoteZeroLabel(job);
  const std::vector<StateArray> states = FindStateArrays(levels, arrays.State.Arrays, ranks);
  InputRequests requests = FindInputRequests(levels, options, ranks);
  Warn(job, requests.Warning);
  const bool isWidened = ReplacesCells(options);
  const LevelSetup setup = isWidened ? SetUpReading(levels) : SetUpLevels(job, requests);
  CheckPeriods(options);
  std::vector<BlockPlace> owners = ChooseOwners(job, source, setup, levels);
  LevelFields fields = MakeLevelFields(
    levels, source, setup, options.ChildFractions, RepeatingAxes(options), owners, job.Run);
  std::unique_ptr<Cells> cells(new Cells{ std::move(source), setup, {}, std::move(levels),
    std::move(owners), std::move(fields), {}, {}, {} });
  cells->LevelSets = std::move(levelSets);
  Warn(job, CheckGreyValues(job, cells->Fields));
  Materials& table = cells->Fields.Field.Table;
  NameLabels(arrays.Names, table);
  const NamesById names = NamesOf(table);
  cells->SplitPairs = ReadPairs("SplitInterfaces", options.SplitInterfaces, names);
  cells->LayerPairs = ReadPairs("LayerInterfaces", options.LayerInterfaces, names);
  if (isWidened)
  {
    WidenCells(job, requests, states, *cells);
    return cells;
  }
  cells->Requests = DistributeRequests(requests, cells->Input, cells->Owners, ranks);
  cells->State = StoreState(cells->Input, cells->Source, arrays.State, states, cells->Fields,
    cells->Setup, options, cells->Owners, job.Run);
  return cells;
}

} // namespace vfm
