#include "Phases/TetMethods.h"

#include "Base/Sorted.h"
#include "Elements/MeasureFragments.h"
#include "Elements/ResolveCells.h"
#include "Elements/Tet/CellTets.h"
#include "Elements/Tet/CoarseTets.h"
#include "Elements/Tet/LatticeTopology.h"
#include "Fractions/CoarsenFields.h"
#include "Ranks/Agreement.h"
#include "Smoothing/Attach.h"
#include "Smoothing/Tet/TetAttach.h"
#include "Smoothing/Tet/TetImprove.h"
#include "Volumes/CellLocator.h"
#include "Volumes/TetFragments.h"
#include "Volumes/ThinFragments.h"
#ifdef VFM_HAS_TETGEN
#include "TetGen/RefillTets.h"
#endif

namespace vfm
{
namespace
{

constexpr double ShareBeforeTetGen = 0.15; // share of the run time, and of the progress
constexpr int LateFlips = 5;               // sweeps between two rounds of flips in the last stage
// Factor of the weight of distances for curved elements: their surface is as close as their
// corners.
constexpr double CurvedWeight = 30.0;

/// Returns the cells of families (LevelPlan::Families).
std::vector<std::vector<Index>> CellsOf(
  const std::vector<std::vector<Index>>& families, const CartesianGrid& base)
{
  const int refinements = static_cast<int>(families.size());
  const OctreeKeys lattice(base, refinements);
  std::vector<std::vector<Index>> cells(refinements);
  for (int level = 0; level < refinements; ++level)
  {
    for (Index key : families[level])
    {
      ForCells(ChangeLevel(BoxOfCell(lattice.FamilyOfKey(level, key)), 1),
        [&](const Index3& cell)
        {
          if (lattice.HasCell(level, cell))
          {
            cells[level].push_back(lattice.FamilyKey(level + 1, cell));
          }
        });
    }
  }
  return cells;
}

/// Adds the corners of narrow void cells to nodes, so that all tets of the barrier are finest ones.
void AddCorners(const NarrowVoid& narrow, const CartesianGrid& grid, std::vector<Index>& nodes)
{
  const IndexBox box = NodesOf(grid.Owned());
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      narrow.ForNodes(first, first + box.Size(0),
        [&](Index begin, Index end, bool touches)
        {
          for (Index node = begin; touches && node < end; ++node)
          {
            nodes.push_back(node);
          }
        });
    });
  SortUnique(nodes);
}

/// Makes levels of single cells. FineLayers counts from the interface, so the cells at crossed
/// nodes are one layer. Another one has the tets of all points that move; the interfaces of Lattice
/// hardly depend on them.
/// @param crossed  nodes around which all cells must be finest ones, ascending
std::shared_ptr<const RefinedGrid> MakeLevelsOfCells(
  const MeshCells& cells, const std::vector<Index>& crossed, Ranks& ranks)
{
  LevelPlan plan = cells.Options.Levels;
  if (plan.Refinements > 0)
  {
    plan.Unit = RefinedUnit::Cell;
    plan.FineLayers -= cells.Options.Method == TetMethod::Lattice ? 2 : 1;
    plan.Families = CellsOf(plan.Families, CoarsenGrid(cells.Grid, plan.Refinements, 0));
  }
  return std::make_shared<const RefinedGrid>(cells.Grid, plan, crossed, ranks);
}

/// Returns the number of refined cells of each refinement that were requested.
std::vector<Index> CountRequested(const OctantFamilies& sets)
{
  std::vector<Index> counts;
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    counts.push_back(sets.Report(level).Requested);
  }
  return counts;
}

} // namespace

TetMethodBase::TetMethodBase(const MeshCells& cells) :
  Kind(cells.Options.Method), TheEnergy(FloorsOf(cells.Options))
{
}

Draft TetMethodBase::Make(const MeshCells& cells, MeshRun& run)
{
  run.Clock.SetShare(this->Kind == TetMethod::TetGen ? ShareBeforeTetGen : 1.0);
  NarrowVoid narrow;
  const std::shared_ptr<const RefinedGrid> levels = InterfacesCrossLevels(cells.Options)
    ? this->LabelLeaves(cells, run, narrow)
    : this->LabelCells(cells, run, narrow);
  const CoarseTets coarse(*levels, this->Labels, cells.Options.MeshVoid, narrow, run.Group());
  run.Report.NarrowVoidCells = SumOverRanks(narrow.CountOwned(), run.Group());
  TetTopology topology = this->BuildTets(cells, narrow, coarse, run);
  run.Clock.Start("Finding fragments", 0.15);
  FragmentVolumes volumes = this->FindFragments(cells, run, topology);
  this->Positions = std::move(topology.Positions);
  Mesh& mesh = topology.Tets;
  FillInside(mesh);
  std::vector<Facet> facets = ListFacets(this->Faces, cells.Grid, run.Parts, mesh);
  std::vector<unsigned char> isThin =
    FindThinFragments(cells.Grid, mesh, this->Thin, volumes.Share());
  return { .Elements = std::move(mesh),
    .Facets = std::move(facets),
    .Volumes = std::move(volumes),
    .RequestedFamilies = CountRequested(levels->Families()),
    .Barrier = topology.Barrier,
    .Thin = this->Thin,
    .IsThin = std::move(isThin) };
}

/// Makes labels of cells, then levels whose finest cells are at all interfaces.
std::shared_ptr<const RefinedGrid> TetMethodBase::LabelCells(
  const MeshCells& cells, MeshRun& run, NarrowVoid& narrow)
{
  ResolvedCells resolved = ResolveCells(cells, false, run);
  this->Labels = std::move(resolved.Labels);
  this->Thin = std::move(resolved.Thin);
  run.Clock.Start("Making tetrahedra", 0.1);
  this->Mixed = FindMixedNodes(cells.Grid, this->Labels);
  this->StartTets(cells, run);
  narrow = FindBarrier(
    cells.Options, RefinedGrid(cells.Grid, run.Group()), this->Labels, this->Mixed, run.TheRuntime);
  std::vector<Index> crossed;
  if (cells.Options.Levels.Refinements > 0)
  {
    crossed = this->FindCrossedNodes(cells);
    if (!narrow.IsEmpty())
    {
      AddCorners(narrow, cells.Grid, crossed);
    }
  }
  return MakeLevelsOfCells(cells, crossed, run.Group());
}

/// Makes levels, then labels of leaves.
std::shared_ptr<const RefinedGrid> TetMethodBase::LabelLeaves(
  const MeshCells& cells, MeshRun& run, NarrowVoid& narrow)
{
  run.Clock.Start("Assigning materials", 0.0);
  std::shared_ptr<const RefinedGrid> levels = MakeLevelsOfCells(cells, {}, run.Group());
  ResolvedLeaves resolved =
    ResolveLeaves(cells, *levels, LabelCellsOfLeaves(cells, run), false, run);
  this->Labels = std::move(resolved.Labels);
  this->Thin = std::move(resolved.Thin);
  run.Clock.Start("Making tetrahedra", 0.1);
  this->Mixed = FindMixedNodes(cells.Grid, this->Labels);
  narrow = FindBarrier(cells.Options, *levels, this->Labels, this->Mixed, run.TheRuntime);
  return levels;
}

ActiveMesh& TetMethodBase::MakeActive(const MeshCells& cells, MeshRun& run, Draft& draft)
{
  this->Active = MakeActiveTets(draft.Elements, this->Positions, draft.Barrier, draft.IsThin,
    cells.Grid, run.Parts, run.TheRuntime);
  return this->Active;
}

std::unique_ptr<LevelInterfaces> TetMethodBase::FindInterfaces(
  const MeshCells& cells, const Draft& draft, MeshRun& run)
{
  return std::make_unique<LevelInterfaces>(*draft.Elements.Levels, cells.Fractions, this->Labels,
    std::move(this->Mixed), cells.Options.IsoValue, run.TheRuntime, this->Thin);
}

void TetMethodBase::Attach(const LevelInterfaces& interfaces, const Draft& draft, MeshRun& run)
{
  AttachTets(interfaces, draft.Elements, draft.Facets, this->Kind, run.TheRuntime, this->Active);
}

SmoothingRamp TetMethodBase::Ramp(const MeshCells& cells) const
{
  SmoothingRamp ramp = TetRamp(this->Kind);
  ramp.back().Lambda *= HasCurvedEdges(cells.Options) ? CurvedWeight : 1.0;
  return ramp;
}

/// Frees the facets, unless bulges are measured by them.
void TetMethodBase::StartMoves(
  const MeshCells& cells, const std::vector<FeatureKind>&, MeshRun&, Draft& draft)
{
  if (!HasCurvedEdges(cells.Options))
  {
    std::vector<Facet>().swap(draft.Facets);
  }
}

void TetMethodBase::RestoreDraft(const MeshCells& cells, MeshRun& run, Draft& draft)
{
  if (draft.Facets.empty())
  {
    draft.Facets = ListFacets(this->Faces, cells.Grid, run.Parts, draft.Elements);
  }
}

void TetMethodBase::EndMoves(MeshRun&, Draft&)
{
  this->Active = ActiveMesh();
}

void LatticeMethod::StartTets(const MeshCells& cells, MeshRun& run)
{
  this->Nodes.emplace(
    cells.Grid, cells.Fractions, this->Labels, cells.Options.IsoValue, run.Parts, run.TheRuntime);
}

std::vector<Index> LatticeMethod::FindCrossedNodes(const MeshCells& cells) const
{
  return FindLatticeInterfaces(cells.Grid, *this->Nodes);
}

TetTopology LatticeMethod::BuildTets(
  const MeshCells& cells, const NarrowVoid& narrow, const CoarseTets& coarse, MeshRun& run)
{
  LatticeTets tets = BuildLatticeTets(
    cells.Grid, *this->Nodes, cells.Options.MeshVoid, narrow, run.Parts, run.TheRuntime, coarse);
  this->Nodes.reset();
  this->Faces = std::move(tets.Faces);
  return std::move(tets.Topology);
}

FragmentVolumes LatticeMethod::FindFragments(
  const MeshCells& cells, MeshRun& run, TetTopology& topology)
{
  const TetFragments fragments(topology, this->Faces, cells.Grid, run.Parts);
  run.Report.NumberOfFragments = fragments.Share().Total;
  FragmentVolumes volumes(cells.Grid, cells.Fractions, fragments.Share(), fragments,
    cells.Options.LeavesFar, run.TheRuntime);
  volumes.SetStart(MeasureFragments(topology.Tets, cells.Grid, fragments.Share(), run.TheRuntime));
  return volumes;
}

std::vector<Index> CellsMethod::FindCrossedNodes(const MeshCells&) const
{
  return this->Mixed;
}

TetTopology CellsMethod::BuildTets(
  const MeshCells& cells, const NarrowVoid& narrow, const CoarseTets& coarse, MeshRun& run)
{
  TetTopology topology =
    BuildCellTets(this->Labels, cells.Options.MeshVoid, narrow, run.TheRuntime, coarse);
  run.Clock.Start("Finding faces", 0.12);
  this->Faces = FindTetFaces(topology.Tets, topology.Positions, topology.Barrier, cells.Grid);
  return topology;
}

FragmentVolumes CellsMethod::FindFragments(
  const MeshCells& cells, MeshRun& run, TetTopology& topology)
{
  const Fragments fragments(cells.Grid, this->Labels, cells.Options.MeshVoid, run.Parts);
  run.Report.NumberOfFragments = fragments.NumberOfFragments();
  FragmentVolumes volumes = VolumesOfCells(cells.Grid, cells.Fractions, *topology.Tets.Levels,
    this->Labels, fragments, cells.Options.LeavesFar, run.TheRuntime);
  FillFragments(cells.Grid, fragments, topology.Tets);
  if (!topology.Tets.Levels->HasFineInterfaces())
  {
    volumes.SetStart(
      MeasureFragments(topology.Tets, cells.Grid, fragments.Share(), run.TheRuntime));
  }
  return volumes;
}

/// Returns the quads of the grid: no edge runs along their diagonals.
std::vector<Facet> CellsMethod::FeatureFacets(const MeshCells& cells, const Draft& draft) const
{
  return cells.Options.SharpEdges == SharpEdgeMode::Off
    ? std::vector<Facet>()
    : JoinTriangles(draft.Facets, this->Faces, draft.Elements);
}

void CellsMethod::StartMoves(
  const MeshCells& cells, const std::vector<FeatureKind>& kinds, MeshRun& run, Draft& draft)
{
  TetMethodBase::StartMoves(cells, kinds, run, draft);
  this->Flips.emplace(
    draft.Elements, draft.Barrier, run.Parts, this->Active, this->TheEnergy, kinds);
}

void CellsMethod::AfterSweep(const SmoothingStage& stage, int sweep, Smoother& smoother)
{
  if (stage.HalfPower < TetRamp().back().HalfPower || sweep % LateFlips == LateFlips - 1)
  {
    this->Flips->Run(stage,
      [&](int point)
      {
        if (this->Flips->CrossLevels())
        {
          smoother.MarkPoint(point);
        }
        else
        {
          smoother.MarkForUpdate(point);
        }
      });
  }
}

void CellsMethod::AfterRamp(const MeshCells& cells, MeshRun& run, Draft& draft)
{
  this->Flips->CopyTo(draft.Elements);
  this->Faces = FindTetFaces(draft.Elements, this->Positions, draft.Barrier, cells.Grid);
  std::vector<Facet> flipped = ListFacets(this->Faces, cells.Grid, run.Parts, draft.Elements);
  SetFacets(flipped, run.TheRuntime, this->Active);
  if (HasCurvedEdges(cells.Options))
  {
    draft.Facets.swap(flipped);
  }
}

void CellsMethod::EndMoves(MeshRun& run, Draft& draft)
{
  this->Flips.reset();
  TetMethodBase::EndMoves(run, draft);
}

void CellsMethod::Refill(const MeshCells& cells, MeshRun& run, Mesh& mesh)
{
#ifdef VFM_HAS_TETGEN
  if (this->Kind == TetMethod::TetGen)
  {
    run.Clock.SetShare(1.0);
    run.Clock.Start("Filling with TetGen", ShareBeforeTetGen);
    RefillTets(
      mesh, cells.Grid, this->Labels, cells.Options,
      [&run](double done)
      { run.Clock.Update(ShareBeforeTetGen + (0.95 - ShareBeforeTetGen) * done); },
      run.TheRuntime, run.Report);
  }
#else
  (void)cells, (void)run, (void)mesh;
#endif
}

} // namespace vfm
