#include "Phases/Pipeline.h"

#include "Elements/Tet/TetTopology.h"
#include "Geometry/MeasureMaterials.h"
#include "Geometry/Quality.h"
#include "Octree/LevelIds.h"
#include "Phases/MakeLevels.h"
#include "Ranks/Agreement.h"
#include "Smoothing/AttachFeatures.h"
#include "Smoothing/EdgePulls.h"
#include "Smoothing/RefineTargets.h"

namespace vfm
{

void CheckOptions(const MeshOptions& options)
{
  if (!(options.IsoValue > 0.0 && options.IsoValue < 1.0))
  {
    throw InputError("IsoValue is " + std::to_string(options.IsoValue) +
      ": it must lie between 0 and 1, both excluded.");
  }
  if (!(options.TargetScaledJacobian >= 0.0 && options.TargetScaledJacobian < 1.0))
  {
    throw InputError("TargetScaledJacobian is " + std::to_string(options.TargetScaledJacobian) +
      ": it must lie in [0, 1); 0 selects it automatically.");
  }
  if (options.Levels.Refinements < 0 || options.Levels.FineLayers < 2)
  {
    throw InputError("FineLayers is " + std::to_string(options.Levels.FineLayers) +
      " and there are " + std::to_string(options.Levels.Refinements) +
      " refinements: at least 2 layers and 0 refinements are needed.");
  }
}

void Resolve(MeshJob& job, LabelArray& labels, bool keepsSeam)
{
  job.Clock.Start("Resolving labels", 0.05);
  ReportFlips(
    ResolveLabels(job.Grid, job.Fractions, labels, job.Parts, job.Run, nullptr, keepsSeam),
    job.Report);
}

void ReportNarrowVoid(const NarrowVoid& narrow, Ranks& ranks, MeshReport& report)
{
  report.NarrowVoidCells = SumOverRanks(narrow.CountOwned(), ranks);
}

namespace
{

void CountCarriers(
  const std::vector<FeatureKind>& kinds, const ActiveMesh& active, Ranks& ranks, MeshReport& report)
{
  std::vector<std::int64_t> counts(2, 0);
  active.ForOwned(
    [&](int point)
    {
      counts[0] += kinds[point] == FeatureKind::Edge;
      counts[1] += kinds[point] == FeatureKind::Corner;
    });
  ranks.Sum(counts);
  report.EdgePoints = counts[0];
  report.CornerPoints = counts[1];
}

} // namespace

std::vector<FeatureKind> AttachToFeatures(MeshJob& job, const Interface& interface,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active)
{
  const MeshOptions& options = job.Options;
  const bool hasQuadrics = options.IsoValue == 0.5 && options.Method == Smoothing::QuadricSurface;
  const Index firstTarget = targets.Count() - static_cast<Index>(interface.Points().size());
  std::vector<FeatureKind> kinds(active.X.size(), FeatureKind::None);
  if (options.Edges != SharpEdges::Off && hasQuadrics)
  {
    job.Clock.Start("Finding sharp features", 0.22);
    const SharpFeatures features(
      interface, job.Fractions, targets, firstTarget, options.Edges, job.Parts, job.Run);
    kinds =
      AttachFeatures({ features, interface, firstTarget }, facets, mesh, targets, active, job.Run);
    CountCarriers(kinds, active, job.Run.Group(), job.Report);
  }
  if (HasCurvedEdges(options) && hasQuadrics)
  {
    RefineTargets(interface, job.Fractions, firstTarget, active, job.Run, targets);
  }
  return kinds;
}

std::function<std::vector<double>()> BulgesOf(MeshJob& job, const std::vector<Facet>& facets,
  const Mesh& mesh, const SurfaceTargets& targets, const ActiveMesh& active)
{
  if (!HasCurvedEdges(job.Options))
  {
    return {};
  }
  return [&]
  {
    return MeasureBulges(FindEdgePulls(facets, mesh, targets, active, job.Run), mesh, active,
      job.Report.NumberOfFragments + 1, job.Run);
  };
}

void SetPulls(MeshJob& job, const std::vector<Facet>& facets, const SurfaceTargets& targets,
  const ActiveMesh& active, Mesh& mesh)
{
  if (HasCurvedEdges(job.Options))
  {
    mesh.Pulls = FindEdgePulls(facets, mesh, targets, active, job.Run);
  }
}

namespace
{

/// Returns the number of whole cells of each level, then of transition hexes. In a mesh of tets,
/// cells and hexes are counted if their centres are points.
std::vector<std::int64_t> CountHexes(const Mesh& mesh)
{
  const RefinedGrid& levels = *mesh.Levels;
  const int refinements = levels.NumberOfRefinements();
  std::vector<std::int64_t> hexes(refinements + 2, 0);
  const auto countCoarse = [&](const OctreeKeys::LevelIndex& cell)
  {
    const bool isWhole = !levels.Families().IsTouched(cell.Level, cell.At);
    ++hexes[isWhole ? cell.Level : refinements + 1];
  };
  if (mesh.Corners == 8)
  {
    for (Index id : mesh.ElementIds)
    {
      if (IsCoarseElement(levels, id, mesh.Ids.ElementSlots))
      {
        countCoarse(CellOfCoarseElement(levels, id, mesh.Ids.ElementSlots));
      }
      else
      {
        ++hexes[refinements];
      }
    }
    return hexes;
  }
  for (Index id : mesh.PointIds)
  {
    if (!IsCentre(mesh, id))
    {
      continue;
    }
    const bool isOwned = levels.Finest().Owned().Contains(CellOfCentre(levels.Finest(), mesh, id));
    if (isOwned && IsCoarsePoint(levels, id, mesh.Ids.PointSlots))
    {
      countCoarse(CellOfCoarseCentre(levels, id, mesh.Ids.PointSlots));
    }
    else
    {
      hexes[refinements] += isOwned;
    }
  }
  return hexes;
}

} // namespace

void ReportLevels(
  const Mesh& mesh, const std::vector<Index>& requested, Ranks& ranks, MeshReport& report)
{
  if (mesh.Levels->IsUniform())
  {
    return;
  }
  const int refinements = mesh.Levels->NumberOfRefinements();
  std::vector<std::int64_t> hexes = CountHexes(mesh);
  ranks.Sum(hexes);
  for (int level = 0; level <= refinements; ++level)
  {
    report.Levels.push_back({ 0, 0, 0, hexes[level] });
    if (level < refinements)
    {
      const OctantFamilies::LevelReport& families = mesh.Levels->Families().Report(level);
      MeshReport::Level& last = report.Levels.back();
      last.Families = families.Requested + families.Balance + families.NonManifold;
      last.AddedForBalance = last.Families - families.Requested;
      last.AddedForValidity = families.Requested - requested[level];
    }
  }
  report.TransitionCells = hexes[refinements + 1];
}

void MeasureQuality(MeshJob& job, Mesh& mesh)
{
  if (job.Options.ComputeQuality)
  {
    job.Clock.Start("Measuring quality", 0.95);
    ComputeQuality(mesh, job.Run, job.Report);
  }
  MeasureMaterials(mesh, job.Run.Group(), job.Report);
}

} // namespace vfm
