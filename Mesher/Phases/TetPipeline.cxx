#include "Phases/TetPipeline.h"

#include "Elements/MeasureFragments.h"
#include "Elements/Tet/CellTets.h"
#include "Elements/Tet/LatticeTopology.h"
#include "Geometry/CloseSeam.h"
#include "Geometry/Geometry.h"
#include "Geometry/KeepOwned.h"
#include "Phases/MakeLevels.h"
#include "Phases/Pipeline.h"
#include "Smoothing/Attach.h"
#include "Smoothing/Tet/ActiveTets.h"
#include "Smoothing/Tet/DiagonalFlips.h"
#include "Smoothing/Tet/MakeCoarseTets.h"
#include "Smoothing/Tet/TetAttach.h"
#include "Smoothing/Tet/TetImprove.h"
#include "Volumes/CellLocator.h"
#include "Volumes/Improve.h"
#include "Volumes/TetFragments.h"
#ifdef VFM_HAS_TETGEN
#include "TetGen/RefillTets.h"
#endif

#include <memory>
#include <optional>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double ShareBeforeTetGen = 0.15; // share of the run time, and of the progress
constexpr int LateFlips = 5;               // sweeps between two rounds of flips in the last stage
// Factor of the weight of distances for curved elements: their surface is as close as their
// corners.
constexpr double CurvedWeight = 30.0;

/// Tets of the methods Cells or Lattice.
struct MadeTets
{
  TetTopology Topology;
  TetFaces Faces;
  std::vector<Index> RequestedFamilies; ///< LevelHexes::RequestedFamilies
  std::vector<Index> Mixed;             ///< FindMixedNodes of the labels
};

bool HasLevels(const MeshJob& job)
{
  return job.Options.Levels.Refinements > 0;
}

bool IsLattice(const MeshJob& job)
{
  return job.Options.Tets == TetMethod::Lattice;
}

LabelArray AssignLabels(MeshJob& job)
{
  job.Clock.Start("Assigning materials", 0.0);
  LabelArray labels = AssignMaterials(job.Grid, job.Fractions, job.Options.IsoValue);
  Resolve(job, labels, false);
  return labels;
}

/// Makes the tets of coarse cells. Refines more families until all tets start
/// with positive volumes.
/// @param nodes  nodes of the lattice; only for the method Lattice
/// @param mixed  FindMixedNodes of the labels
std::unique_ptr<const CoarseTets> MakeCoarse(MeshJob& job, const LabelArray& labels,
  const std::optional<LatticeNodes>& nodes, const std::vector<Index>& mixed,
  const TetEnergy& energy, LevelHexes& levels)
{
  std::vector<Index> interfaces;
  if (HasLevels(job))
  {
    interfaces = nodes ? FindLatticeInterfaces(job.Grid, *nodes) : mixed;
  }
  LevelPlan plan = job.Options.Levels;
  for (;; ++job.Report.LevelRounds)
  {
    MakeLevels(job.Grid, labels, interfaces, { job.Options.MeshVoid, true, true }, plan, job.Run,
      job.Report, levels);
    SmoothedTets made = MakeCoarseTets(*levels.Coarse, energy, job.Run);
    if (!AddFamilies(made.BadFamilies, plan, job.Run.Group()))
    {
      return std::move(made.Tets);
    }
  }
}

MadeTets MakeTets(MeshJob& job, const LabelArray& labels)
{
  job.Clock.Start("Making tetrahedra", 0.1);
  const TetEnergy energy(FloorsOf(job.Options));
  std::optional<LatticeNodes> nodes;
  if (IsLattice(job))
  {
    nodes.emplace(job.Grid, job.Fractions, labels, job.Options.IsoValue, job.Parts, job.Run);
  }
  MadeTets made;
  made.Mixed = FindMixedNodes(job.Grid, labels);
  LevelHexes levels;
  const std::unique_ptr<const CoarseTets> coarse =
    MakeCoarse(job, labels, nodes, made.Mixed, energy, levels);
  const NarrowVoid narrow = FindBarrier(job.Options, *levels.Grid, labels, made.Mixed, job.Run);
  ReportNarrowVoid(narrow, job.Run.Group(), job.Report);
  made.RequestedFamilies = std::move(levels.RequestedFamilies);
  if (nodes)
  {
    LatticeTets tets =
      BuildLatticeTets(job.Grid, *nodes, job.Options.MeshVoid, narrow, job.Parts, job.Run, *coarse);
    made.Topology = std::move(tets.Topology);
    made.Faces = std::move(tets.Faces);
  }
  else
  {
    made.Topology = BuildCellTets(job.Grid, labels, job.Options.MeshVoid, narrow, job.Run, *coarse);
    job.Clock.Start("Finding faces", 0.12);
    made.Faces = FindTetFaces(made.Topology, job.Grid);
  }
  return made;
}

std::vector<Facet> ListFacets(const MeshJob& job, const MadeTets& made)
{
  return ListFacets(made.Faces, job.Grid, job.Parts, made.Topology.Tets);
}

/// Sets the fragment of each tet of the method Cells to the fragment of its cell. A tet between two
/// cells of one label gets the fragment of the lower cell.
void FillFragments(const CartesianGrid& grid, const Fragments& fragments, Mesh& mesh)
{
  mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    Index centre = mesh.Elements[4 * t + 3];
    if (IsCentre(mesh, mesh.PointIds[mesh.Elements[4 * t]]))
    {
      centre = mesh.Elements[4 * t];
    }
    mesh.Fragment[t] = fragments.FragmentOfCell(CellOfCentre(grid, mesh, mesh.PointIds[centre]));
  }
}

/// Finds the fragments and their volumes, and fills the fragments of the tets.
FragmentVolumes FindFragments(MeshJob& job, const LabelArray& labels, MadeTets& made)
{
  job.Clock.Start("Finding fragments", 0.15);
  Mesh& mesh = made.Topology.Tets;
  if (IsLattice(job))
  {
    const TetFragments fragments(made.Topology, made.Faces, job.Grid, job.Parts);
    job.Report.NumberOfFragments = static_cast<Index>(fragments.Materials().size()) - 1;
    FragmentVolumes volumes(job.Grid, job.Fractions, fragments.Materials(), fragments, job.Run);
    volumes.SetStart(
      MeasureFragments(mesh, job.Grid, static_cast<int>(job.Report.NumberOfFragments), job.Run));
    return volumes;
  }
  const Fragments fragments(job.Grid, labels, job.Options.MeshVoid, job.Parts);
  job.Report.NumberOfFragments = fragments.NumberOfFragments();
  const CellLocator locator(*mesh.Levels, labels, fragments);
  FragmentVolumes volumes(
    job.Grid, job.Fractions, fragments.MaterialsOfFragments(), locator, job.Run);
  FillFragments(job.Grid, fragments, mesh);
  return volumes;
}

/// Attaches the active points to the interface. Returns their kinds.
std::vector<FeatureKind> Attach(MeshJob& job, const Interface& interface, const MadeTets& made,
  SurfaceTargets& targets, ActiveMesh& active)
{
  const Mesh& mesh = made.Topology.Tets;
  const std::vector<Facet> facets = ListFacets(job, made);
  AttachTets(interface, mesh, facets, IsLattice(job) ? TetMethod::Lattice : TetMethod::Cells,
    job.Run, active);
  const bool hasQuads = !IsLattice(job) && job.Options.Edges != SharpEdges::Off;
  const std::vector<Facet> quads =
    hasQuads ? JoinTriangles(facets, made.Faces, mesh) : std::vector<Facet>();
  std::vector<FeatureKind> kinds =
    AttachToFeatures(job, interface, hasQuads ? quads : facets, mesh, targets, active);
  SetFacets(facets, job.Run, active);
  return kinds;
}

SmoothingRamp MakeRamp(const MeshOptions& options)
{
  SmoothingRamp ramp = TetRamp(options.Tets);
  ramp.back().Lambda *= HasCurvedEdges(options) ? CurvedWeight : 1.0;
  return ramp;
}

/// Smooths the mesh. Returns the kinds of its points.
std::vector<FeatureKind> Smooth(
  MeshJob& job, const LabelArray& labels, MadeTets& made, FragmentVolumes& volumes)
{
  Mesh& mesh = made.Topology.Tets;
  job.Clock.Start("Finding interfaces", 0.2);
  const Interface interface(
    job.Grid, job.Fractions, labels, made.Mixed, job.Options.IsoValue, job.Run);
  SurfaceTargets targets(interface, KindOfTargets(job.Options), job.Run);
  ActiveTets active = MakeActiveTets(made.Topology, job.Grid, job.Parts, job.Run);
  const std::vector<FeatureKind> kinds = Attach(job, interface, made, targets, active);
  const TetEnergy energy(FloorsOf(job.Options));
  std::optional<DiagonalFlips> flips;
  const SmoothingRamp ramp = MakeRamp(job.Options);
  Improvement improvement{ active, targets, energy, ramp, volumes, job.Report,
    ConservesVolume(job.Options), {}, {}, {} };
  std::vector<Facet> facets;
  if (HasCurvedEdges(job.Options))
  {
    facets = ListFacets(job, made);
    improvement.MeasureBulges = BulgesOf(job, facets, mesh, targets, active);
  }
  if (!IsLattice(job))
  {
    flips.emplace(mesh, job.Parts, active, energy, kinds);
    improvement.AfterSweep = [&](Smoother& smoother, const SmoothingStage& stage, int sweep)
    {
      if (stage.HalfPower < TetRamp().back().HalfPower || sweep % LateFlips == LateFlips - 1)
      {
        flips->Run(stage, [&](int point) { smoother.MarkForUpdate(point); });
      }
    };
    improvement.AfterRamp = [&]
    {
      flips->CopyTo(mesh);
      made.Faces = FindTetFaces(made.Topology, job.Grid);
      std::vector<Facet> flipped = ListFacets(job, made);
      SetFacets(flipped, job.Run, active);
      if (HasCurvedEdges(job.Options))
      {
        facets.swap(flipped);
      }
    };
  }
  Improve(improvement, job.Clock, job.Run);
  SetPulls(job, facets, targets, active, mesh);
  active.CopyTo(mesh, job.Grid);
  return active.OfMesh(kinds, mesh);
}

/// Sets the GeometryId of points inside fragments.
void FillInside(Mesh& mesh)
{
  mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
  for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
  {
    mesh.GeometryId[mesh.Elements[at]] = mesh.Fragment[at / 4];
  }
}

void Refill(MeshJob& job, const LabelArray& labels, Mesh& mesh)
{
#ifdef VFM_HAS_TETGEN
  if (job.Options.Tets == TetMethod::TetGen)
  {
    job.Clock.SetShare(1.0);
    job.Clock.Start("Filling with TetGen", ShareBeforeTetGen);
    RefillTets(
      mesh, job.Grid, labels, job.Options,
      [&job](double done)
      { job.Clock.Update(ShareBeforeTetGen + (0.95 - ShareBeforeTetGen) * done); },
      job.Run, job.Report);
  }
#else
  (void)job, (void)labels, (void)mesh;
#endif
}

Mesh MakeMesh(MeshJob& job)
{
  job.Clock.SetShare(job.Options.Tets == TetMethod::TetGen ? ShareBeforeTetGen : 1.0);
  const LabelArray labels = AssignLabels(job);
  MadeTets made = MakeTets(job, labels);
  FragmentVolumes volumes = FindFragments(job, labels, made);
  std::vector<FeatureKind> kinds; // empty: there are no carriers
  if (MovesPoints(job.Options))
  {
    kinds = Smooth(job, labels, made, volumes);
  }
  ReportVolumes(job.Grid, volumes, job.Report);
  job.Clock.Start("Finding geometry", 0.9);
  Mesh& mesh = made.Topology.Tets;
  FillInside(mesh);
  ClassifyGeometry(ListFacets(job, made), kinds, job.Parts, job.Run, mesh, job.Report);
  CloseSeam(job.Parts, mesh);
  KeepOwned(mesh, job.Grid, job.Run);
  ReportLevels(mesh, made.RequestedFamilies, job.Run.Group(), job.Report);
  Refill(job, labels, mesh);
  MeasureQuality(job, mesh);
  return std::move(mesh);
}

void CheckRange(const char* name, double value, const NumberRange& range)
{
  if (!(value >= range.Least && value <= range.Most))
  {
    std::ostringstream text;
    text << name << " is " << value << ": it must lie in [" << range.Least << ", " << range.Most
         << "].";
    throw InputError(text.str());
  }
}

void CheckTetGenOptions(const MeshOptions& options)
{
  if (options.Tets == TetMethod::TetGen && !HasTetGen())
  {
    throw InputError(
      "This build has no TetGen (VFM_ENABLE_TETGEN): choose the method Cells or Lattice.");
  }
  CheckRange("RelativeSize", options.RelativeSize, RelativeSizes);
  CheckRange("Growth", options.Growth, Growths);
  CheckRange("RadiusEdgeRatio", options.RadiusEdgeRatio, RadiusEdgeRatios);
  CheckRange("MinimumDihedralAngle", options.MinimumDihedralAngle, MinimumDihedralAngles);
  CheckRange("OptimizationLevel", options.OptimizationLevel, OptimizationLevels);
}

} // namespace

bool HasTetGen()
{
#ifdef VFM_HAS_TETGEN
  return true;
#else
  return false;
#endif
}

Mesh MakeTetMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  CheckOptions(options);
  CheckTetGenOptions(options);
  report = MeshReport();
  MeshOptions own = options;
  own.Levels.FineInterfaces = true; // tets support no other setting
  MeshJob job{ grid, fractions, own, runtime, report };
  return MakeMesh(job);
}

} // namespace vfm
