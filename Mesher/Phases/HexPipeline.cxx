#include "Phases/HexPipeline.h"

#include "Elements/Hex/HexFacets.h"
#include "Elements/MeasureFragments.h"
#include "Geometry/CloseSeam.h"
#include "Geometry/Geometry.h"
#include "Geometry/KeepOwned.h"
#include "Phases/MakeLevels.h"
#include "Phases/Pipeline.h"
#include "Smoothing/Attach.h"
#include "Smoothing/Hex/ActiveCorners.h"
#include "Smoothing/Hex/ActiveHexes.h"
#include "Smoothing/Hex/CoarseSmoothing.h"
#include "Smoothing/Hex/HexEnergy.h"
#include "Smoothing/Hex/PackedLists.h"
#include "Volumes/CellLocator.h"
#include "Volumes/Improve.h"

#include <optional>
#include <stdexcept>

namespace vfm
{
namespace
{

const SmoothingPace Early{ 1.8, 4.0, 0.0, 2e-4, 5e-3 }, Late{ 1.7, 4.0, 0.0, 2e-4, 4e-3 };
const SmoothingRamp Ramp{ { 2, 10.0, 0.05, 8, 0.0, Early, 2 }, { 8, 60.0, 0.01, 30, 2e-3, Late } };

double TargetJacobian(const FractionField& fractions, const MeshOptions& options)
{
  const bool several = fractions.NumberOfMaterials() > 1 || options.MeshVoid;
  return options.TargetScaledJacobian > 0.0 ? options.TargetScaledJacobian : (several ? 0.5 : 0.55);
}

void FindLabels(MeshJob& job, LabelledGrid& result)
{
  job.Clock.Start("Assigning materials", 0.0);
  if (InterfacesCrossLevels(job.Options))
  {
    LabelLeaves(job.Grid, job.Fractions, job.Options, job.Parts, job.Run, job.Report, result);
    return;
  }
  result.Labels = AssignMaterials(job.Grid, job.Fractions, job.Options.IsoValue);
  Resolve(job, result.Labels, true);
  job.Clock.Start("Making hexahedra", 0.1);
  result.Mixed = FindMixedNodes(job.Grid, result.Labels);
  LevelPlan plan = job.Options.Levels;
  MakeLevels(job.Grid, result.Labels, result.Mixed, { job.Options.MeshVoid, false, true }, plan,
    job.Run, job.Report, result.Levels);
  result.Narrow =
    FindBarrier(job.Options, *result.Levels.Grid, result.Labels, result.Mixed, job.Run);
}

FragmentVolumes FindVolumes(
  const MeshJob& job, const LabelArray& labels, const Fragments& fragments, const Mesh& mesh)
{
  const CellLocator locator(*mesh.Levels, labels, fragments);
  FragmentVolumes volumes(
    job.Grid, job.Fractions, fragments.MaterialsOfFragments(), locator, job.Run);
  if (!mesh.Levels->HasFineInterfaces())
  {
    volumes.SetStart(MeasureFragments(mesh, job.Grid, fragments.NumberOfFragments(), job.Run));
  }
  return volumes;
}

/// Hexes in their initial position.
struct HexStart
{
  Mesh Result;
  std::vector<Facet> Facets;
  FragmentVolumes Volumes;
};

/// Makes the hexes. The numbers of points and the fragments of cells are freed before points move.
HexStart MakeStart(MeshJob& job, const LabelledGrid& labelled)
{
  CoarseHexes& coarse = *labelled.Levels.Coarse;
  const NarrowVoid& narrow = labelled.Narrow;
  ReportNarrowVoid(narrow, job.Run.Group(), job.Report);
  PointNumbering numbering(
    job.Grid, labelled.Labels, job.Options.MeshVoid, !coarse.Levels().IsUniform(), narrow);
  Mesh mesh = BuildHexes(
    job.Grid, labelled.Labels, labelled.Mixed, job.Options.StairStep, numbering, job.Run, coarse);
  mesh.Levels = labelled.Levels.Grid;
  mesh.HasBarrier = !narrow.IsEmpty();
  job.Clock.Start("Finding fragments", 0.12);
  const Fragments fragments(job.Grid, labelled.Labels, job.Options.MeshVoid, job.Parts);
  job.Report.NumberOfFragments = fragments.NumberOfFragments();
  FillFragments(labelled, numbering, fragments, job.Run, mesh);
  job.Clock.Update(0.135);
  std::vector<Facet> facets =
    FindHexFacets(labelled, numbering, fragments, job.Parts, job.Run, mesh);
  job.Clock.Start("Finding interfaces", 0.15);
  FragmentVolumes volumes = FindVolumes(job, labelled.Labels, fragments, mesh);
  return { std::move(mesh), std::move(facets), std::move(volumes) };
}

/// Data of each point of the mesh.
struct SmoothedPoints
{
  std::vector<FeatureKind> Kinds;   ///< empty: there are no carriers
  std::vector<unsigned char> Moved; ///< whether it may have been moved
};

/// Data of the hexes that nothing reads while points move.
class PackedStart
{
public:
  /// Takes the ids and facets.
  explicit PackedStart(HexStart& start) :
    PointIds(start.Result.PointIds), ElementIds(start.Result.ElementIds), Facets(start.Facets)
  {
  }
  /// Gives them back.
  void UnpackTo(HexStart& start) const
  {
    start.Result.PointIds = this->PointIds.Unpack();
    start.Result.ElementIds = this->ElementIds.Unpack();
    start.Facets = this->Facets.Unpack();
  }

private:
  PackedIds PointIds, ElementIds;
  PackedFacets Facets;
};

/// Finds the interfaces. Frees the labels, unless coarse hexes refer to them.
void FindInterfaces(
  const MeshJob& job, LabelledGrid& labelled, std::optional<LevelInterfaces>& interfaces)
{
  const RefinedGrid& levels = *labelled.Levels.Grid;
  interfaces.emplace(levels, job.Fractions, labelled.Labels, std::move(labelled.Mixed),
    job.Options.IsoValue, job.Run);
  if (levels.IsUniform())
  {
    labelled.Labels = LabelArray();
    labelled.Narrow = NarrowVoid();
  }
}

/// Moves the points of the active mesh to the interfaces and improves the hexes.
SmoothedPoints MovePoints(MeshJob& job, LabelledGrid& labelled, HexStart& start, ActiveMesh& active)
{
  const std::vector<Facet>& facets = start.Facets;
  Mesh& mesh = start.Result;
  std::optional<LevelInterfaces> interfaces;
  FindInterfaces(job, labelled, interfaces);
  job.Clock.Start("Fitting surfaces", 0.2);
  // Before the targets, which would add to the peak of memory.
  AttachHexes(*interfaces, *labelled.Levels.Coarse, mesh, facets, job.Run, active);
  job.Clock.Update(0.205);
  SurfaceTargets targets(interfaces->All(), KindOfTargets(job.Options), job.Run);
  std::vector<FeatureKind> kinds = active.OfMesh(
    AttachToFeatures(job, *interfaces->All().back(), facets, mesh, targets, active), mesh);
  if (KindOfTargets(job.Options) == SurfaceTargets::Kind::Quadrics)
  {
    interfaces.reset(); // only facets need them
  }
  SetFacets(facets, job.Run, active);
  std::vector<int>().swap(active.PointOf);
  std::optional<PackedStart> packed;
  if (!HasCurvedEdges(job.Options)) // bulges are measured by facets and ids
  {
    packed.emplace(start);
  }
  const HexEnergy energy(TargetJacobian(job.Fractions, job.Options));
  Improve({ active, targets, energy, Ramp, start.Volumes, job.Report, ConservesVolume(job.Options),
            {}, {}, BulgesOf(job, facets, mesh, targets, active) },
    job.Clock, job.Run);
  if (packed)
  {
    active.Rings = HexRings(); // before the lists, which would add to the peak of memory
    packed->UnpackTo(start);
  }
  SetPulls(job, facets, targets, active, mesh);
  active.CopyTo(mesh, job.Grid);
  return { std::move(kinds), active.ListMoved(mesh) };
}

SmoothedPoints Smooth(MeshJob& job, LabelledGrid& labelled, HexStart& start)
{
  // Before the interfaces, which would add to the peak of memory.
  ActiveMesh active = MakeActiveHexes(labelled, job.Parts, start.Result, job.Run);
  const ActiveCorners corners(active, start.Result);
  job.Clock.Update(0.16);
  SmoothedPoints points = MovePoints(job, labelled, start, active);
  const std::vector<int> elements = std::move(active.Elements);
  const std::vector<Index> meshPoints = std::move(active.MeshPoint);
  active = ActiveMesh();
  corners.Restore(elements, meshPoints, job.Run, start.Result);
  return points;
}

Mesh MakeMesh(MeshJob& job)
{
  LabelledGrid labelled;
  FindLabels(job, labelled);
  HexStart start = MakeStart(job, labelled);
  Mesh& mesh = start.Result;
  SmoothedPoints points;
  if (MovesPoints(job.Options))
  {
    points = Smooth(job, labelled, start);
    if (!mesh.Levels->IsUniform())
    {
      job.Clock.Start("Smoothing transitions", 0.9);
      ReleaseFreeMemory();
      SmoothCoarse(*labelled.Levels.Coarse, points.Moved, mesh, job.Run);
    }
  }
  std::vector<unsigned char>().swap(points.Moved);
  job.Clock.Start("Finding geometry", 0.93);
  ClassifyGeometry(start.Facets, points.Kinds, job.Parts, job.Run, mesh, job.Report);
  CloseSeam(job.Parts, mesh);
  KeepOwned(mesh, job.Grid, job.Run);
  ReportLevels(mesh, labelled.Levels.RequestedFamilies, job.Run.Group(), job.Report);
  ReportVolumes(job.Grid, start.Volumes, job.Report);
  MeasureQuality(job, mesh);
  return std::move(mesh);
}

/// Returns whether the grid has at least the required ghost layers and exactly
/// the required hex layers.
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
    throw std::logic_error("The grid has fewer ghost layers than LayersFor returns.");
  }
  MeshJob job{ grid, fractions, options, runtime, report };
  return MakeMesh(job);
}

} // namespace vfm
