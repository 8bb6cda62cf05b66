#include "HexPipeline.h"

#include "Hex/ActiveHexes.h"
#include "Hex/CoarseSmoothing.h"
#include "Hex/HexFacets.h"
#include "Mesh/Geometry.h"
#include "Mesh/KeepOwned.h"
#include "Mesh/MeasureFragments.h"
#include "Pipeline.h"
#include "Smoothing/Attach.h"
#include "Smoothing/CellLocator.h"
#include "Smoothing/HexEnergy.h"

#include <optional>
#include <stdexcept>

namespace vfm
{
namespace
{

const SmoothingPace Early{ 1.8, 4.0, 0.0, 2e-4, 5e-3 }, Late{ 1.75, 4.0, 0.0, 1e-4, 2.5e-3 };
const SmoothingRamp Ramp{ { 1, 1.0, 0.1, 4, 0.0, Early }, { 2, 10.0, 0.05, 7, 0.0, Early },
  { 8, 60.0, 0.01, 30, 2e-3, Late } };

double TargetJacobian(const FractionField& fractions, const MeshOptions& options)
{
  const bool several = fractions.NumberOfMaterials() > 1 || options.MeshVoid;
  return options.TargetScaledJacobian > 0.0 ? options.TargetScaledJacobian : (several ? 0.5 : 0.55);
}

/// The stages, on a grid with as many ghost layers as they need.
class HexStages : private MeshStages
{
public:
  using MeshStages::MeshStages;

  Mesh MakeMesh();

private:
  void FindLabels();
  FragmentVolumes FindVolumes(const Fragments& fragments, const Mesh& mesh);
  /// Returns which points of the mesh may have been moved.
  std::vector<unsigned char> Smooth(
    const std::vector<Facet>& facets, FragmentVolumes& volumes, Mesh& mesh);

  LabelledGrid Labelled;
  std::vector<CreaseKind> Kinds; // of the points of the mesh; empty: none carries an edge
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
  this->Resolve(result.Labels);
  this->Clock.Start("Making hexahedra", 0.1);
  result.Mixed = FindMixedNodes(this->Grid, result.Labels);
  LevelPlan plan = this->Options.Levels;
  MakeLevels(this->Grid, result.Labels, result.Mixed, { this->Options.MeshVoid, false, true }, plan,
    this->Run, this->Report, result.Levels);
}

FragmentVolumes HexStages::FindVolumes(const Fragments& fragments, const Mesh& mesh)
{
  const CellLocator locator(*mesh.Levels, this->Labelled.Labels, fragments);
  FragmentVolumes volumes(
    this->Grid, this->Fractions, fragments.MaterialsOfFragments(), locator, this->Run);
  if (!mesh.Levels->HasFineInterfaces())
  {
    volumes.SetStart(MeasureFragments(mesh, this->Grid, fragments.NumberOfFragments(), this->Run));
  }
  return volumes;
}

std::vector<unsigned char> HexStages::Smooth(
  const std::vector<Facet>& facets, FragmentVolumes& volumes, Mesh& mesh)
{
  const CoarseHexes& coarse = *this->Labelled.Levels.Coarse;
  std::optional<LevelInterfaces> interfaces(std::in_place, *mesh.Levels, this->Fractions,
    this->Labelled.Labels, this->Labelled.Mixed, this->Options.IsoValue, this->Run);
  this->Clock.Start("Fitting surfaces", 0.2);
  SurfaceTargets targets(interfaces->All(), KindOfTargets(this->Options), this->Run);
  this->Clock.Update(0.21);
  ActiveMesh active = MakeActiveHexes(this->Labelled, this->Parts, mesh, this->Run);
  this->Clock.Update(0.215);
  AttachHexes(*interfaces, coarse, mesh, facets, this->Run, active);
  this->Kinds = active.OfMesh(
    this->AttachToCreases(*interfaces->All().back(), facets, mesh, targets, active), mesh);
  SetFacets(facets, active);
  std::vector<int>().swap(active.PointOf);
  if (KindOfTargets(this->Options) == SurfaceTargets::Kind::Quadrics)
  {
    interfaces.reset(); // facets need it
  }
  const HexEnergy energy(TargetJacobian(this->Fractions, this->Options));
  Improve({ active, targets, energy, Ramp, volumes, this->Report,
            this->Options.ConserveVolume && this->Options.IsoValue == 0.5, {}, {} },
    this->Clock, this->Run);
  active.CopyTo(mesh, this->Grid);
  return active.ListMoved(mesh);
}

Mesh HexStages::MakeMesh()
{
  this->FindLabels();
  const LabelArray& labels = this->Labelled.Labels;
  CoarseHexes& coarse = *this->Labelled.Levels.Coarse;
  PointNumbering numbering(
    this->Grid, labels, this->Options.MeshVoid, !coarse.Levels().IsUniform());
  Mesh mesh = BuildHexes(this->Grid, labels, this->Labelled.Mixed, this->Options.StairStep,
    numbering, this->Run, coarse);
  mesh.Levels = this->Labelled.Levels.Grid;
  this->Clock.Start("Finding fragments", 0.12);
  const Fragments fragments(this->Grid, labels, this->Options.MeshVoid, this->Parts);
  this->Report.NumberOfFragments = fragments.NumberOfFragments();
  FillFragments(this->Labelled, numbering, fragments, this->Run, mesh);
  this->Clock.Update(0.135);
  const std::vector<Facet> facets =
    FindHexFacets(this->Labelled, numbering, fragments, this->Parts, mesh);
  this->Clock.Start("Finding interfaces", 0.15);
  FragmentVolumes volumes = this->FindVolumes(fragments, mesh);
  if (!this->Options.StairStep && this->Options.Method != Smoothing::Off)
  {
    const std::vector<unsigned char> moved = this->Smooth(facets, volumes, mesh);
    if (!mesh.Levels->IsUniform())
    {
      this->Clock.Start("Smoothing transitions", 0.9);
      ReleaseFreeMemory();
      SmoothCoarse(coarse, moved, mesh, this->Run);
    }
  }
  this->Clock.Start("Finding geometry", 0.93);
  ClassifyGeometry(facets, this->Kinds, this->Parts, mesh, this->Report);
  KeepOwned(mesh, this->Grid);
  ReportLevels(mesh, this->Labelled.Levels.Asked, this->Run.Group(), this->Report);
  ReportVolumes(this->Grid, volumes, this->Report);
  this->MeasureQuality(mesh);
  return mesh;
}

/// More ghost layers do no harm.
bool HasLayers(const CartesianGrid& grid, const GridLayers& layers)
{
  const IndexBox needed = Grow(grid.Owned(), layers.Ghosts, grid.Global());
  return Intersect(needed, grid.Local()) == needed &&
    grid.HexBox() == Grow(grid.Owned(), layers.Hexes, grid.Global());
}

} // namespace

Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  CheckOptions(options);
  report = MeshReport();
  if (!HasLayers(grid, LayersFor(options.Levels)))
  {
    throw std::logic_error("The grid has fewer ghost layers than LayersFor asks for.");
  }
  return HexStages(grid, fractions, options, runtime, report).MakeMesh();
}

} // namespace vfm
