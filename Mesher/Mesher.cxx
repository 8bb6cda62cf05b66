#include "Mesher.h"

#include "Fractions/GhostFractions.h"
#include "HexPipeline.h"
#include "Input/InputFractions.h"
#include "Input/InputLabels.h"
#include "Input/UseLabels.h"
#include "Labels/SmallRegions.h"
#include "Labels/SmoothLabels.h"
#include "Options/SetOptions.h"
#include "Ranks/Agreement.h"
#include "TetPipeline.h"

#include <algorithm>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double LabelVolumeTolerance = 1e-6; // relative, of smoothed labels

/// One run, stage by stage. All of it is collective.
class MesherRun
{
public:
  MesherRun(const MesherInput& input, const MesherOptions& options, Runtime& runtime) :
    Input(input), Levels(input.Levels), Options(options), Run(runtime), Group(runtime.Group())
  {
  }

  MesherResult Make();

private:
  void Warn(const std::string& text) const
  {
    if (this->Group.Rank() == 0 && !text.empty() && this->Input.Warn)
    {
      this->Input.Warn(text);
    }
  }

  bool AreLabels() const { return !this->Input.Arrays.Labels.empty(); }
  bool KeepsInterfacesFine() const
  {
    return this->Options.FineInterfaces || this->Options.Elements == ElementKind::Tets;
  }

  LevelCells OpenCells() const;
  InputWishes FindWishes() const;
  LevelSetup SetUpLevels(const InputWishes& wishes) const;
  RemovedRegions PrepareFractions(LevelFields& fields) const;
  LevelPlan Refine(const LevelSetup& setup, const InputWishes& wishes, LevelFields& fields) const;
  Mesh MakeMesh(const LevelFields& fields, const MeshOptions& options, MeshReport& report) const;
  void WarnOfMesh(const MeshReport& report, const InputField& field) const;
  void Finish(const LevelFields& fields, const MeshOptions& options, MesherResult& result) const;

  const MesherInput& Input;
  const InputLevels& Levels;
  const MesherOptions& Options;
  Runtime& Run;
  Ranks& Group;
};

LevelCells MesherRun::OpenCells() const
{
  const MesherArrays& arrays = this->Input.Arrays;
  return this->AreLabels() ? OpenLabels(this->Levels.Levels, arrays.Labels, this->Group)
                           : OpenFractions(this->Levels.Levels, arrays.Fractions,
                               this->Options.FractionTolerance, this->Group);
}

/// The cells that are to be refined by name.
InputWishes MesherRun::FindWishes() const
{
  const bool isAutomatic = this->Options.Where == Refinement::Automatic;
  const InputWishes wishes = FindInputWishes(this->Levels, FindRefinementArray(this->Options),
    isAutomatic ? this->Options.RefinementBoxes : std::vector<RefinementBox>(), this->Group);
  this->Warn(wishes.Warning);
  return wishes;
}

LevelSetup MesherRun::SetUpLevels(const InputWishes& wishes) const
{
  const InputBlocks& coarsest = this->Levels.Levels[0];
  const int alignment =
    this->Input.StaysInPlace ? CountAlignedLevels(coarsest.Boxes(), this->Group) : AnyLevel;
  LevelSetup setup = DecideLevels(this->Options.Where, this->Options.MaximumLevel,
    coarsest.Coordinates, this->Levels.Finest(), alignment, wishes.Finest);
  this->Warn(setup.Warning);
  return setup;
}

/// Removes small regions, smooths labels and cuts long cells, as asked.
RemovedRegions MesherRun::PrepareFractions(LevelFields& fields) const
{
  FractionField& fractions = fields.Field.Fractions;
  RemovedRegions removed;
  if (this->Options.MinimumRegionCells > 1)
  {
    this->Run.Progress(0.0, "Removing small regions");
    removed = RemoveSmallRegions(fields.Grid, this->Options.MinimumRegionCells,
      this->Options.IsoValue, Partition(fields.Grid, this->Group), fractions);
  }
  if (this->Options.LabelSmoothing > 0 && this->AreLabels())
  {
    this->Run.Progress(0.0, "Smoothing labels");
    const double error = SmoothLabels(fields.Grid, this->Options.LabelSmoothing,
      Partition(fields.Grid, this->Group), this->Run, fractions);
    if (error > LabelVolumeTolerance)
    {
      std::ostringstream text;
      text << "Smoothing could not keep the volumes of all labels: the worst is off by "
           << 100.0 * error << " %. Fewer passes, or MinimumRegionCells, may help.";
      this->Warn(text.str());
    }
  }
  // after labels: the parts of a slice would keep its steps
  DivideFields(fields, this->Options.MaximumAspectRatio, this->Options.Children, this->Run);
  return removed;
}

/// Makes the grid as fine as the finest cells of the mesh, with the ghost layers that meshing needs.
LevelPlan MesherRun::Refine(
  const LevelSetup& setup, const InputWishes& wishes, LevelFields& fields) const
{
  const int top = std::min(setup.Finest, this->Levels.Finest());
  int finer = setup.Finest - top;
  if (this->Options.Where == Refinement::Automatic)
  {
    this->Run.Progress(0.0, "Looking for places to refine");
    const int layers = this->KeepsInterfacesFine() ? 0 : this->Options.FineLayers;
    RefinementCriteria criteria{ this->Options.ThinCells, this->Options.CurvaturePerCell,
      this->Options.RefineFlippedCells, this->Options.InterfaceLayers, {}, finer };
    WorkTogether(this->Group, [&] { criteria.Chosen = TakeWishes(wishes, setup, layers, fields); });
    if (finer > 0)
    {
      finer = FindFinerLevels(fields, criteria, this->Options.IsoValue, layers, this->Run);
    }
  }
  RefineFields(fields, finer, this->Options.Children, this->Run);
  LevelPlan plan;
  plan.FineInterfaces = this->KeepsInterfacesFine();
  plan.FineLayers = this->Options.FineLayers;
  if (!setup.IsUniform)
  {
    plan.Refinements = top - setup.Base + finer;
    plan.Families = std::move(fields.Families);
  }
  if (InterfacesCrossLevels(plan))
  {
    WidenGrid(LayersFor(plan), this->Group, fields.Grid, fields.Field.Fractions);
  }
  return plan;
}

Mesh MesherRun::MakeMesh(
  const LevelFields& fields, const MeshOptions& options, MeshReport& report) const
{
  if (this->Options.Elements == ElementKind::Hexes)
  {
    return MakeHexMesh(fields.Grid, fields.Field.Fractions, options, this->Run, report);
  }
  Mesh mesh = MakeTetMesh(fields.Grid, fields.Field.Fractions, options, this->Run, report);
  if (report.RefusedParts > 0)
  {
    this->Warn("TetGen refused " + std::to_string(report.RefusedParts) +
      " parts of the mesh: they keep the tetrahedra of the method Cells.");
  }
  return mesh;
}

/// Of what may surprise in the mesh.
void MesherRun::WarnOfMesh(const MeshReport& report, const InputField& field) const
{
  const MendedCells& mended = field.Mended;
  if (mended.Clipped > 0)
  {
    this->Warn("Volume fractions of " + std::to_string(mended.Clipped) +
      " cells lay outside [0, 1] and were clipped.");
  }
  if (mended.Normalised > 0)
  {
    this->Warn("The volume fractions of " + std::to_string(mended.Normalised) +
      " cells sum to slightly more than 1 and were scaled back.");
  }
  const bool isEmpty = std::all_of(report.Materials.begin(), report.Materials.end(),
    [](const MeshReport::Material& material) { return material.Elements == 0; });
  this->Warn(isEmpty ? "The mesh is empty: no cell is filled by its materials to the iso value."
                     : DescribeLostMaterials(report, field.Table));
}

/// Turns the mesh, and tells of it.
void MesherRun::Finish(
  const LevelFields& fields, const MeshOptions& options, MesherResult& result) const
{
  const auto append = [](FieldArrays more, FieldArrays& to)
  { std::move(more.begin(), more.end(), std::back_inserter(to)); };
  const Materials& table = fields.Field.Table;
  TurnMesh(this->Levels.Reading.Frame, result.TheMesh);
  UseLabels(table, result.TheMesh);
  append(ListSides(result.TheMesh.Tables), result.Fields);
  append(
    ListReport(result.TheMesh, result.Report, table, options, fields.Field.Mended), result.Fields);
  append(ListDomain(fields.Grid, this->Levels.Reading.Frame), result.Fields);
  append(ListMaterials(result.Report, table, options), result.MaterialFields);
  if (result.State.IsConserved)
  {
    append(ListBalance(result.State.Balance, options.MeshVoid), result.Fields);
    append(ListBalance(result.State.Balance, options.MeshVoid), result.MaterialFields);
  }
}

MesherResult MesherRun::Make()
{
  const LevelCells cells = this->OpenCells();
  StateCarrier states(this->Levels, this->Input.Arrays.State, this->Group);
  InputWishes wishes = this->FindWishes();
  const LevelSetup setup = this->SetUpLevels(wishes);
  const std::vector<BlockPlace> owners = this->Input.StaysInPlace
    ? this->Levels.Levels[0].Places
    : ShareOutCells(this->Levels, cells, setup, this->Group);
  wishes = ShareOutWishes(wishes, this->Levels, owners, this->Group);
  LevelFields fields =
    MakeLevelFields(this->Levels, cells, setup, this->Options.Children, owners, this->Run);
  NameLabels(this->Input.Arrays.Names, fields.Field.Table);
  states.Keep(cells, fields, setup, this->Options.MeshVoid, owners, this->Run);
  const RemovedRegions removed = this->PrepareFractions(fields);
  const MeshOptions options{ this->Options, this->Refine(setup, wishes, fields) };
  MesherResult result;
  MeshReport& report = result.Report;
  result.TheMesh = this->MakeMesh(fields, options, report);
  report.RemovedRegions = removed.Regions;
  report.RemovedCells = removed.Cells;
  report.ChosenCells = wishes.Cells;
  this->Run.Progress(0.98, "Filling output");
  const int finest = setup.IsUniform ? setup.Finest : setup.Base + options.Levels.Refinements;
  const MeshedGrid meshed{ fields.Grid, fields.Field.Fractions, finest,
    fields.Division.OfHalves(finest - setup.Base) };
  result.State = states.Carry(result.TheMesh, meshed, this->Options, owners, this->Run);
  WorkTogether(this->Group, [&] { this->Finish(fields, options, result); });
  this->WarnOfMesh(report, fields.Field);
  this->Warn(DescribeUnmeshed(result.State.Balance, fields.Field.Table));
  return result;
}

} // namespace

MesherResult RunMesher(const MesherInput& input, const MesherOptions& options, Runtime& runtime)
{
  CheckOptions(options);
  return MesherRun(input, options, runtime).Make();
}

} // namespace vfm
