#include "Phases/ReadCells.h"

#include "Input/ArrayNames.h"
#include "Input/InputArrays.h"
#include "Input/InputFractions.h"
#include "Input/InputLabels.h"
#include "Levels/GreyLabels.h"
#include "Levels/PeriodicFields.h"
#include "Materials/ZeroLabels.h"
#include "Options/SetOptions.h"
#include "Options/ValueRanges.h"

#include <algorithm>

namespace vfm
{
namespace
{

LevelCells OpenCells(const MesherJob& job)
{
  if (!AreLabels(job) && !job.Options.Threshold.empty())
  {
    throw InputError(
      "Threshold makes materials of ranges of the values of one array, which must be "
      "chosen as labels (" +
      job.Input.Arrays.LabelsOption + " ARRAY), not as volume fractions.");
  }
  const std::vector<InputBlocks>& levels = job.Input.Levels.Levels;
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

/// Checks whether labels look like grey values: an error if the user did not select them, otherwise
/// a warning.
void CheckGreyLabels(const MesherJob& job, const LevelFields& fields)
{
  const std::string found = AreLabels(job) && job.Options.Threshold.empty()
    ? DescribeGreyLabels(fields, job.Run.Group())
    : "";
  if (found.empty())
  {
    return;
  }
  const std::string& name = job.Input.Arrays.Labels;
  const std::string text = "The array '" + name + "' looks like grey values, not labels: " + found +
    ". Threshold (--threshold LOW:HIGH) makes materials of ranges of values.";
  if (job.Input.Arrays.AreGuessed)
  {
    throw InputError(text + " If each value is a material, choose the array as labels (" +
      job.Input.Arrays.LabelsOption + " " + name + ").");
  }
  Warn(job, text);
}

/// Returns whether the materials are one array of bytes whose name does not say volume fraction.
/// @pre Collective
bool IsPlainByte(const MesherJob& job)
{
  const std::vector<std::string>& names = job.Input.Arrays.Fractions;
  if (names.size() != 1 || IsFractionName(names[0]))
  {
    return false;
  }
  bool areBytes = true;
  for (const InputBlocks& level : job.Input.Levels.Levels)
  {
    for (const InputBlock& block : level.Blocks)
    {
      areBytes = areBytes && FindMaterialArray(block, names[0])->Type == ValueType::UnsignedChar;
    }
  }
  return !job.Run.Group().Any(!areBytes);
}

/// Checks whether fractions of 255 look like grey values, as CheckGreyLabels.
void CheckGreyFractions(const MesherJob& job, const LevelFields& fields)
{
  const std::string found = IsPlainByte(job) ? DescribeGreyFractions(fields, job.Run.Group()) : "";
  if (found.empty())
  {
    return;
  }
  const std::string& name = job.Input.Arrays.Fractions[0];
  const std::string text = "The array '" + name +
    "' looks like grey values or labels, not volume fractions of 255: " + found +
    ". Threshold (--threshold LOW:HIGH) makes materials of ranges of values.";
  if (job.Input.Arrays.AreGuessed)
  {
    throw InputError(text + " If each value is a material, choose the array as labels (" +
      job.Input.Arrays.LabelsOption + " " + name +
      "); if they are volume fractions, choose it as fractions (--fractions " + name + ").");
  }
  Warn(job, text);
}

/// Returns the user-selected cells that are to be refined.
InputRequests FindRequests(const MesherJob& job)
{
  const bool isAutomatic = job.Options.Refinement == RefinementMode::Automatic;
  InputRequests requests = FindInputRequests(job.Input.Levels, FindRefinementArray(job.Options),
    isAutomatic ? job.Options.RefinementBoxes : std::vector<RefinementBox>(), job.Run.Group());
  Warn(job, requests.Warning);
  return requests;
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

/// Returns the cells of level 0 that each rank meshes.
std::vector<BlockPlace> FindOwners(
  const MesherJob& job, const LevelCells& cells, const LevelSetup& setup)
{
  const InputLevels& levels = job.Input.Levels;
  return job.Input.StaysInPlace ? levels.Levels[0].Places
                                : DistributeCells(levels, cells, setup, job.Run.Group());
}

/// Returns the names of materials by id.
std::map<int, std::string> NamesOf(const Materials& table)
{
  std::map<int, std::string> names;
  for (std::size_t m = 0; m < table.Names.size(); ++m)
  {
    names[table.Labels[m]] = table.Names[m];
  }
  return names;
}

} // namespace

std::unique_ptr<Cells> ReadCells(const MesherJob& job)
{
  const InputLevels& levels = job.Input.Levels;
  const MesherArrays& arrays = job.Input.Arrays;
  const MesherOptions& options = job.Options;
  Ranks& ranks = job.Run.Group();
  LevelCells source = OpenCells(job);
  NoteZeroLabel(job);
  const std::vector<StateArray> states = FindStateArrays(levels, arrays.State.Arrays, ranks);
  InputRequests requests = FindRequests(job);
  const LevelSetup setup = SetUpLevels(job, requests);
  CheckPeriods(options);
  std::vector<BlockPlace> owners = FindOwners(job, source, setup);
  requests = DistributeRequests(requests, levels, owners, ranks);
  LevelFields fields = MakeLevelFields(
    levels, source, setup, options.ChildFractions, RepeatingAxes(options), owners, job.Run);
  std::unique_ptr<Cells> cells(new Cells{ std::move(source), setup, std::move(requests),
    std::move(owners), std::move(fields), {}, {}, {} });
  CheckGreyLabels(job, cells->Fields);
  CheckGreyFractions(job, cells->Fields);
  Materials& table = cells->Fields.Field.Table;
  NameLabels(arrays.Names, table);
  const std::map<int, std::string> names = NamesOf(table);
  cells->SplitPairs = ReadPairs("SplitInterfaces", options.SplitInterfaces, names);
  cells->LayerPairs = ReadPairs("LayerInterfaces", options.LayerInterfaces, names);
  cells->State = StoreState(levels, cells->Source, arrays.State, states, cells->Fields,
    cells->Setup, options, cells->Owners, job.Run);
  return cells;
}

} // namespace vfm
