#include "Mesher.h"

#include "Elements/SelectPoints.h"
#include "Fractions/GhostFractions.h"
#include "Geometry/JoinCopies.h"
#include "Geometry/LeaveCovering.h"
#include "Input/InputFractions.h"
#include "Input/InputLabels.h"
#include "Labels/SmallRegions.h"
#include "Labels/SmoothLabels.h"
#include "Levels/GreyLabels.h"
#include "Levels/PeriodicFields.h"
#include "Materials/UseLabels.h"
#include "Materials/ZeroLabels.h"
#include "Modify/AddLayers.h"
#include "Modify/AddMidNodes.h"
#include "Modify/CurvedVolumes.h"
#include "Modify/SplitInterfaces.h"
#include "Options/SetOptions.h"
#include "Options/ValueRanges.h"
#include "Phases/MeshOfCells.h"
#include "Ranks/Agreement.h"
#include "Report/SeamFacets.h"
#include "State/ViewMesh.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double LabelVolumeTolerance = 1e-6; // relative volume error of smoothed labels
constexpr double LargestSafeRatio = 1000.0;   // of widths; no overlaps were seen below

/// Data of a run that all steps use; all steps are collective.
struct MesherJob
{
  const MesherInput& Input;
  const MesherOptions& Options;
  Runtime& Run;
};

void Warn(const MesherJob& job, const std::string& text)
{
  if (job.Run.Group().Rank() == 0 && !text.empty() && job.Input.Warn)
  {
    job.Input.Warn(text);
  }
}

bool AreLabels(const MesherJob& job)
{
  return !job.Input.Arrays.Labels.empty();
}

LevelCells OpenCells(const MesherJob& job)
{
  if (!AreLabels(job) && !job.Options.Threshold.empty())
  {
    throw InputError(
      "Threshold makes materials of ranges of the values of one array, which must be "
      "chosen as labels (--labels ARRAY), not as volume fractions.");
  }
  const std::vector<InputBlocks>& levels = job.Input.Levels.Levels;
  const MesherArrays& arrays = job.Input.Arrays;
  Ranks& ranks = job.Run.Group();
  return AreLabels(job)
    ? OpenLabels(levels,
        { arrays.Labels, *ParseRanges(job.Options.Threshold),
          job.Options.Zero == ZeroLabel::Material },
        ranks)
    : OpenFractions(levels, arrays.Fractions, job.Options.FractionTolerance, ranks);
}

/// Warns if label 0 may be a material.
void NoteZeroLabel(const MesherJob& job)
{
  const MesherArrays& arrays = job.Input.Arrays;
  if (AreLabels(job) && job.Options.Threshold.empty() && job.Options.Zero == ZeroLabel::Void &&
    !arrays.IsZeroVoid)
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
    throw InputError(
      text + " If each value is a material, choose the array as labels (--labels " + name + ").");
  }
  Warn(job, text);
}

/// Returns the user-selected cells that are to be refined.
InputRequests FindRequests(const MesherJob& job)
{
  const bool isAutomatic = job.Options.Where == Refinement::Automatic;
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
  LevelSetup setup = DecideLevels(job.Options.Where, job.Options.MaximumLevel, coarsest.Coordinates,
    levels.Finest(), std::min(alignment, periodic), requests.Finest);
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
    DivideFields(fields, job.Options.MaximumAspectRatio, job.Options.Children, job.Run);
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
  if (job.Options.Where == Refinement::Automatic)
  {
    finer = FindRefinements(job, setup, requests, finer, fields);
  }
  RefineFields(fields, finer, job.Options.Children, job.Run);
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

Mesh MakeMesh(
  const MesherJob& job, const LevelFields& fields, const MeshOptions& options, MeshReport& report)
{
  const FractionField& fractions = fields.Field.Fractions;
  if (job.Options.Elements == ElementKind::Hexes)
  {
    return MakeHexMesh(fields.Grid, fractions, options, job.Run, report);
  }
  Mesh mesh = MakeTetMesh(fields.Grid, fractions, options, job.Run, report);
  if (report.RefusedParts > 0)
  {
    Warn(job,
      "TetGen rejected " + std::to_string(report.RefusedParts) +
        " parts of the mesh; they keep the tetrahedra of the method Cells.");
  }
  return mesh;
}

/// Turns a periodic mesh into a mesh of the domain.
void LeaveCopies(const MesherJob& job, LevelFields& fields, Mesh& mesh)
{
  if (fields.Grid.IsPeriodic())
  {
    const bool joins = job.Options.PeriodicSides == Sides::Joined;
    LeaveCovering(
      Partition(fields.Grid, job.Run.Group()), joins ? Partner::Upper : Partner::Lowest, mesh);
    RemoveCopies(job.Run.Group(), fields);
    if (!joins)
    {
      AddSeamFacets(
        ListDomain(fields.Grid, ImageFrame(), RepeatingAxes(job.Options)), job.Run.Group(), mesh);
    }
  }
}

/// Joins the copies of points. Their velocities are equal.
void JoinSides(const MesherJob& job, MesherResult& result)
{
  const std::vector<Index> kept = JoinCopies(job.Run, result.TheMesh);
  if (std::optional<TransferredArray>& velocity = result.State.NodalVelocity)
  {
    const Index size = 3 * sizeof(double);
    velocity->Values = Select(velocity->Values, kept, job.Run, size);
  }
}

/// Returns the lengths after which the domain repeats; 0 along other axes.
Vector3 FindPeriods(const MesherOptions& options, const CartesianGrid& grid)
{
  Vector3 periods{};
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    periods[a] = RepeatingAxes(options)[a] ? x.back() - x.front() : 0.0;
  }
  return periods;
}

MeshedGrid DescribeGrid(const LevelFields& fields, const LevelSetup& setup, const LevelPlan& plan)
{
  const int finest = setup.IsUniform ? setup.Finest : setup.Base + plan.Refinements;
  return { fields.Grid, fields.Field.Fractions, finest,
    fields.Division.OfHalves(finest - setup.Base) };
}

void AppendFields(FieldArrays more, FieldArrays& to)
{
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

/// Transforms the mesh to world coordinates, and lists its fields.
void Finish(
  const MesherJob& job, const LevelFields& fields, const MeshOptions& options, MesherResult& result)
{
  const Materials& table = fields.Field.Table;
  const ImageFrame frame = job.Options.ImageAxes ? ImageFrame() : job.Input.Levels.Reading.Frame;
  TurnMesh(frame, result.TheMesh);
  UseLabels(table, result.TheMesh);
  AppendFields(ListSides(result.TheMesh.Tables), result.Fields);
  AppendFields(ListReport(result.TheMesh, result.Report, table, options, fields.Field.Corrected),
    result.Fields);
  AppendFields(ListDomain(fields.Grid, frame, RepeatingAxes(job.Options)), result.Fields);
  AppendFields(ListMaterials(result.Report, table, options), result.MaterialFields);
  if (result.State.IsConserved)
  {
    AppendFields(ListBalance(result.State.Balance, options.MeshVoid), result.Fields);
    AppendFields(ListBalance(result.State.Balance, options.MeshVoid), result.MaterialFields);
  }
}

/// Returns the pairs of materials in an option, or nothing if it is empty.
std::optional<MaterialPairs> ReadPairs(
  const std::string& option, const std::string& text, const Materials& table)
{
  if (text.empty())
  {
    return std::nullopt;
  }
  std::map<int, std::string> names;
  for (std::size_t m = 0; m < table.Names.size(); ++m)
  {
    names[table.Labels[m]] = table.Names[m];
  }
  return MaterialPairs(option, text, names);
}

/// Splits the interfaces between the pairs of materials.
void Split(const MesherJob& job, const MaterialPairs& pairs, MesherResult& result)
{
  Warn(job, SplitMesh(pairs, job.Options, job.Run, result.Fields, result.TheMesh, result.State));
  result.Cohesive =
    FindCohesiveBlocks(ViewMesh(result.TheMesh, result.State, result.Fields), job.Run.Group());
}

/// Adds mid nodes, and reports the volumes of the curved elements.
void AddOrder(
  const MesherJob& job, const LevelFields& fields, const MeshOptions& options, MesherResult& result)
{
  const Materials& table = fields.Field.Table;
  Mesh& mesh = result.TheMesh;
  AppendFields(
    AddMidNodes(job.Options.Order, result.Fields, job.Run, mesh, result.State), result.Fields);
  result.Report.MeshVolume = MeasureCurvedVolumes(mesh, table.Labels, result.Fields, job.Run);
  ReplaceFields(
    ListReport(mesh, result.Report, table, options, fields.Field.Corrected), result.Fields);
  ReplaceFields(ListMaterials(result.Report, table, options), result.MaterialFields);
}

/// Warns of corrected input, an empty mesh, and materials without elements or with wrong volumes.
void WarnOfMesh(const MesherJob& job, const MeshReport& report, const InputField& field)
{
  const CorrectedCells& corrected = field.Corrected;
  if (corrected.Clipped > 0)
  {
    Warn(job,
      "Volume fractions of " + std::to_string(corrected.Clipped) +
        " cells lay outside [0, 1] and were clipped.");
  }
  if (corrected.Normalised > 0)
  {
    Warn(job,
      "The volume fractions of " + std::to_string(corrected.Normalised) +
        " cells sum to slightly more than 1 and were scaled back.");
  }
  const bool isEmpty = std::all_of(report.Materials.begin(), report.Materials.end(),
    [](const MeshReport::Material& material) { return material.Elements == 0; });
  Warn(job,
    isEmpty ? "The mesh is empty: no cell is filled by its materials to the iso value."
            : DescribeLostMaterials(report, field.Table));
  if (MovesPoints(job.Options) && ConservesVolume(job.Options))
  {
    Warn(job, DescribeInexactMaterials(report, field.Table, AreLabels(job)));
  }
}

} // namespace

MesherResult RunMesher(const MesherInput& input, const MesherOptions& given, Runtime& runtime)
{
  CheckOptions(given);
  MesherOptions options = given;
  options.FineInterfaces |= options.Elements == ElementKind::Tets; // tets support nothing else
  const MesherJob job{ input, options, runtime };
  const InputLevels& levels = input.Levels;
  const MesherArrays& arrays = input.Arrays;
  Ranks& ranks = runtime.Group();

  const LevelCells cells = OpenCells(job);
  NoteZeroLabel(job);
  const std::vector<StateArray> states = FindStateArrays(levels, arrays.State.Arrays, ranks);
  InputRequests requests = FindRequests(job);
  const LevelSetup setup = SetUpLevels(job, requests);
  CheckPeriods(options);
  const std::vector<BlockPlace> owners = FindOwners(job, cells, setup);
  requests = DistributeRequests(requests, levels, owners, ranks);

  LevelFields fields = MakeLevelFields(
    levels, cells, setup, options.Children, RepeatingAxes(options), owners, runtime);
  CheckGreyLabels(job, fields);
  NameLabels(arrays.Names, fields.Field.Table);
  const Materials& table = fields.Field.Table;
  const std::optional<MaterialPairs> split =
    ReadPairs("SplitInterfaces", options.SplitInterfaces, table);
  const std::optional<MaterialPairs> layers =
    ReadPairs("LayerInterfaces", options.LayerInterfaces, table);
  const StoredState kept =
    StoreState(levels, cells, arrays.State, states, fields, setup, options, owners, runtime);

  AddCopies(options, setup, ranks, fields);
  Warn(job, DescribeSeams(fields, options.IsoValue, ranks));
  const RemovedRegions removed = RemoveRegions(job, fields);
  SmoothFields(job, fields);
  Divide(job, setup, fields);
  const MeshOptions meshOptions{ options, Refine(job, setup, requests, fields) };

  WarnOfWidths(job, fields.Grid);

  MesherResult result;
  result.TheMesh = MakeMesh(job, fields, meshOptions, result.Report);
  result.Report.RemovedRegions = removed.Regions;
  result.Report.RemovedCells = removed.Cells;
  result.Report.ChosenCells = requests.Cells;

  runtime.Progress(0.98, "Filling output");
  result.State = MakeOutputState(kept, levels, result.TheMesh,
    DescribeGrid(fields, setup, meshOptions.Levels), options, owners, runtime);
  LeaveCopies(job, fields, result.TheMesh); // after the state, which takes cells across sides
  AddLayers(options,
    { fields.Grid.MeanWidth(), FindPeriods(options, fields.Grid), table.Labels,
      layers ? &*layers : nullptr },
    runtime, result.TheMesh, result.State, result.Report);
  if (options.Periodic != 0 && options.PeriodicSides == Sides::Joined)
  {
    JoinSides(job, result);
  }
  WorkTogether(ranks, [&] { Finish(job, fields, meshOptions, result); });
  if (split)
  {
    Split(job, *split, result);
  }
  if (options.Order != ElementOrder::Linear)
  {
    runtime.Progress(0.99, "Adding mid nodes");
    AddOrder(job, fields, meshOptions, result);
  }
  WarnOfMesh(job, result.Report, fields.Field);
  Warn(job, DescribeUnmeshed(result.State.Balance, fields.Field.Table));
  return result;
}

} // namespace vfm
