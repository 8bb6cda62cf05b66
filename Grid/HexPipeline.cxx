#include "HexPipeline.h"

#include "Fractions/GhostFractions.h"
#include "Hex/ActiveHexes.h"
#include "Hex/ActiveLevelHexes.h"
#include "Hex/CoarseSmoothing.h"
#include "Hex/HexGeometry.h"
#include "Mesh/Quality.h"
#include "Pipeline.h"
#include "Smoothing/GuardedHexEnergy.h"
#include "Smoothing/LeafVolumes.h"

namespace vfm
{
namespace
{

const SmoothingRamp Ramp{ { 1, 1.0, 0.1, 5, 0.0 }, { 2, 10.0, 0.05, 10, 0.0 },
  { 8, 60.0, 0.01, 40, 2e-3 } };

double TargetJacobian(const FractionField& fractions, const MeshOptions& options)
{
  const bool several = fractions.NumberOfMaterials() > 1 || options.MeshVoid;
  return options.TargetScaledJacobian > 0.0 ? options.TargetScaledJacobian : (several ? 0.5 : 0.55);
}

/// The stages, on a grid with as many ghost layers as they need.
class HexStages
{
public:
  HexStages(const CartesianGrid& grid, const FractionField& fractions, const MeshOptions& options,
    Runtime& runtime, MeshReport& report) :
    Grid(grid),
    Fractions(fractions),
    Options(options),
    Run(runtime),
    Report(report),
    Clock(runtime, report),
    Parts(grid, runtime.Group())
  {
  }

  Mesh MakeMesh();

private:
  void FindLabels();
  /// Both return which points of the mesh have been moved, where there are levels.
  std::vector<unsigned char> SmoothHexes(const PointNumbering& numbering,
    const Fragments& fragments, FragmentVolumes& volumes, Mesh& mesh);
  std::vector<unsigned char> SmoothLevelHexes(const PointNumbering& numbering,
    const Fragments& fragments, FragmentVolumes& volumes, Mesh& mesh);
  void ImproveHexes(ActiveMesh& active, const SurfaceTargets& targets, FragmentVolumes& volumes);

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const MeshOptions& Options;
  Runtime& Run;
  MeshReport& Report;
  StageClock Clock;
  const Partition Parts;
  LabelledGrid Labelled;
};

void HexStages::FindLabels()
{
  this->Clock.Start("Assigning materials", 0.0);
  if (InterfacesCrossLevels(this->Options))
  {
    LabelLeaves(this->Grid, this->Fractions, this->Options, this->Parts, this->Run, this->Report,
      this->Labelled);
    return;
  }
  LabelledGrid& result = this->Labelled;
  result.Labels = AssignMaterials(this->Grid, this->Fractions, this->Options.IsoValue);
  this->Clock.Start("Resolving labels", 0.05);
  const ResolveReport resolved =
    ResolveLabels(this->Grid, this->Fractions, result.Labels, this->Parts);
  this->Report.FlippedCells = resolved.FlippedCells;
  this->Report.ResolveRounds = resolved.Rounds;
  this->Clock.Start("Making hexahedra", 0.1);
  result.Mixed = FindMixedNodes(this->Grid, result.Labels);
  result.Levels = MakeLevels(this->Grid, result.Labels, result.Mixed, this->Options, this->Run);
}

void HexStages::ImproveHexes(
  ActiveMesh& active, const SurfaceTargets& targets, FragmentVolumes& volumes)
{
  const double target = TargetJacobian(this->Fractions, this->Options);
  const HexEnergy plain(target);
  const GuardedHexEnergy guarded(target);
  const ElementEnergy& energy = InterfacesCrossLevels(this->Options) ? guarded : plain;
  Improve({ active, targets, energy, Ramp, volumes,
            this->Options.ConserveVolume && this->Options.IsoValue == 0.5, {}, {} },
    this->Clock, this->Run);
}

std::vector<unsigned char> HexStages::SmoothHexes(
  const PointNumbering& numbering, const Fragments& fragments, FragmentVolumes& volumes, Mesh& mesh)
{
  const Interface interface(this->Grid, this->Fractions, this->Labelled.Labels,
    this->Labelled.Mixed, this->Options.IsoValue, this->Run);
  this->Clock.Start("Fitting surfaces", 0.2);
  const SurfaceTargets targets(interface, KindOfTargets(this->Options), this->Run);
  ActiveMesh active =
    MakeActiveHexes(interface, numbering, this->Labelled.Labels, fragments, this->Parts, mesh);
  this->ImproveHexes(active, targets, volumes);
  active.CopyTo(mesh, this->Grid);
  return this->Labelled.Levels.Coarse ? active.ListMoved(mesh) : std::vector<unsigned char>();
}

std::vector<unsigned char> HexStages::SmoothLevelHexes(
  const PointNumbering& numbering, const Fragments& fragments, FragmentVolumes& volumes, Mesh& mesh)
{
  const LevelInterfaces interfaces(*this->Labelled.Levels.Grid, this->Fractions,
    this->Labelled.Labels, this->Options.IsoValue, this->Run);
  this->Clock.Start("Fitting surfaces", 0.2);
  const SurfaceTargets targets(interfaces.All(), KindOfTargets(this->Options), this->Run);
  ActiveMesh active = MakeActiveLevelHexes(interfaces, *this->Labelled.Levels.Coarse,
    this->Labelled.Labels, this->Labelled.Mixed, numbering, fragments, this->Parts, mesh);
  this->ImproveHexes(active, targets, volumes);
  active.CopyTo(mesh, this->Grid);
  return active.ListMoved(mesh);
}

Mesh HexStages::MakeMesh()
{
  this->FindLabels();
  const LabelArray& labels = this->Labelled.Labels;
  CoarseHexes* coarse = this->Labelled.Levels.Coarse.get();
  PointNumbering numbering(this->Grid, labels, this->Options.MeshVoid, coarse != nullptr);
  Mesh mesh = BuildHexes(this->Grid, labels, this->Labelled.Mixed, this->Options.StairStep,
    numbering, this->Run, coarse);
  mesh.Levels = this->Labelled.Levels.Grid;
  this->Clock.Start("Finding geometry", 0.12);
  const Fragments fragments(this->Grid, labels, this->Options.MeshVoid, this->Parts);
  this->Report.NumberOfFragments = fragments.NumberOfFragments();
  FindHexGeometry(this->Grid, labels, this->Labelled.Mixed, fragments, numbering, this->Parts,
    coarse, mesh, this->Report);
  this->Clock.Start("Finding interfaces", 0.15);
  const bool crossesLevels = InterfacesCrossLevels(this->Options);
  const std::unique_ptr<FragmentLocator> locator = crossesLevels
    ? std::make_unique<LeafLocator>(*mesh.Levels, labels, fragments)
    : std::make_unique<CellLocator>(this->Grid, labels, fragments);
  FragmentVolumes volumes(
    this->Grid, this->Fractions, fragments.MaterialsOfFragments(), *locator, this->Parts);
  if (crossesLevels)
  {
    volumes.SetStart(MeasureHexes(mesh, this->Grid, fragments.NumberOfFragments(), this->Run));
  }
  if (!this->Options.StairStep && this->Options.Method != Smoothing::Off)
  {
    const std::vector<unsigned char> moved = crossesLevels
      ? this->SmoothLevelHexes(numbering, fragments, volumes, mesh)
      : this->SmoothHexes(numbering, fragments, volumes, mesh);
    if (coarse)
    {
      this->Clock.Start("Smoothing transitions", 0.9);
      ReleaseFreeMemory();
      SmoothCoarse(*coarse, moved, mesh, this->Run);
    }
  }
  KeepOwned(mesh, this->Grid);
  ReportLevels(mesh, this->Run.Group(), this->Report, this->Labelled.AskedFamilies);
  ReportVolumes(this->Grid, volumes, this->Report);
  if (this->Options.ComputeQuality)
  {
    this->Clock.Start("Measuring quality", 0.95);
    ComputeQuality(mesh, this->Run, this->Report);
  }
  return mesh;
}

/// With the ghost layers of the base: what moves with a node of the base is at hexes as far as a base cell away.
CartesianGrid WithLevels(const CartesianGrid& grid, int refinements)
{
  return CartesianGrid({ { grid.Coordinates(0), grid.Coordinates(1), grid.Coordinates(2) } },
    grid.Owned(), GhostLayers << refinements, std::max(HexLayers, 1 << refinements));
}

} // namespace

Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  CheckOptions(options);
  report = MeshReport();
  if (!InterfacesCrossLevels(options))
  {
    return HexStages(grid, fractions, options, runtime, report).MakeMesh();
  }
  const CartesianGrid wide = WithLevels(grid, options.Levels.Refinements);
  const bool isWide = grid.Local() == wide.Local() && grid.HexBox() == wide.HexBox();
  if (!runtime.Group().Any(!isWide))
  {
    return HexStages(grid, fractions, options, runtime, report).MakeMesh();
  }
  const FractionField ghosted = CopyWithGhosts(grid, fractions, wide, runtime.Group());
  return HexStages(wide, ghosted, options, runtime, report).MakeMesh();
}

} // namespace vfm
