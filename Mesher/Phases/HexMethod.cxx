#include "Phases/HexMethod.h"

#include "Elements/Hex/HexFacets.h"
#include "Elements/Hex/NearCells.h"
#include "Elements/MeasureFragments.h"
#include "Geometry/Quality.h"
#include "Ranks/Agreement.h"
#include "Smoothing/Hex/ActiveHexes.h"
#include "Smoothing/Hex/CoarseSmoothing.h"
#include "Smoothing/Hex/FlatColumns.h"
#include "Smoothing/Hex/FlatEnergy.h"
#include "Smoothing/Hex/MakeLevels.h"
#include "Volumes/CellLocator.h"
#include "Volumes/ThinFragments.h"

namespace vfm
{
namespace
{

constexpr double QuadTarget = 0.55, TriangleTarget = 0.53; // s*
// Triangles have no elements between the interface and the cells that would give way. A steep
// barrier lets their angles come near 30 degrees before it holds points back from the interface.
constexpr int TriangleHalfPower = 32;
constexpr double TriangleLambdas = 10.0; // factor

/// Returns whether hexes that never move can be left out of the mesh.
bool LeavesRuns(const MeshCells& cells, const LabelledGrid& labelled, const MeshRun& run)
{
  return cells.Runs && run.Parts.Group().Count() == 1 && labelled.Levels.Grid->IsUniform() &&
    !cells.Options.StairStep && !cells.Grid.IsPeriodic() && cells.FlatAxis < 0 &&
    labelled.Thin.empty() && AreCellsPerfect(cells.Grid);
}

} // namespace

HexMethod::HexMethod(const MeshCells& cells) : FlatAxis(cells.FlatAxis)
{
  const MeshOptions& options = cells.Options;
  if (this->FlatAxis < 0)
  {
    this->TheEnergy =
      std::make_unique<HexEnergy>(TargetJacobian(options, cells.Fractions.NumberOfMaterials()));
    return;
  }
  if (cells.AreTriangles)
  {
    this->Diagonals.emplace(this->FlatAxis);
  }
  this->TheEnergy =
    std::make_unique<FlatEnergy>(options.TargetScaledJacobian > 0.0 ? options.TargetScaledJacobian
        : this->Diagonals                                           ? TriangleTarget
                                                                    : QuadTarget,
      this->FlatAxis, this->Diagonals ? &*this->Diagonals : nullptr);
}

/// The numbers of points and the fragments of cells are freed at the end.
Draft HexMethod::Make(const MeshCells& cells, MeshRun& run)
{
  LabelledGrid& labelled = this->Labelled;
  LabelCells(cells, run, labelled);
  CoarseHexes& coarse = *labelled.Levels.Coarse;
  run.Report.NarrowVoidCells = SumOverRanks(labelled.Narrow.CountOwned(), run.Group());
  std::optional<NearCells> near;
  if (LeavesRuns(cells, labelled, run))
  {
    near.emplace(cells.Grid, labelled.Mixed, MovingRings);
  }
  PointNumbering numbering(cells.Grid, labelled.Labels, cells.Options.MeshVoid,
    near || !coarse.Levels().IsUniform(), labelled.Narrow);
  // Triangles need no layer of thin elements along interfaces.
  HexTopology topology = BuildHexes(cells.Grid, labelled.Labels, labelled.Mixed,
    cells.Options.StairStep || this->Diagonals, numbering, run.TheRuntime, coarse,
    near ? &*near : nullptr);
  topology.WholeCells = MovesPoints(cells.Options) ? 0 : topology.WholeCells;
  Mesh& mesh = topology.Hexes;
  mesh.Levels = labelled.Levels.Grid;
  run.Clock.Start("Finding fragments", 0.12);
  const Fragments fragments(cells.Grid, labelled.Labels, cells.Options.MeshVoid, run.Parts);
  run.Report.NumberOfFragments = fragments.NumberOfFragments();
  FillFragments(labelled, numbering, fragments, run.TheRuntime, topology);
  if (near)
  {
    *cells.Runs = ListFarCells(cells.Grid, *near, fragments);
    near.reset();
  }
  run.Clock.Update(0.135);
  std::vector<Facet> facets =
    FindHexFacets(labelled, numbering, fragments, run.Parts, run.TheRuntime, topology);
  run.Clock.Start("Finding volumes", 0.15);
  FragmentVolumes volumes = VolumesOfCells(cells.Grid, cells.Fractions, *mesh.Levels,
    labelled.Labels, fragments, cells.Options.LeavesFar, run.TheRuntime);
  if (!mesh.Levels->HasFineInterfaces())
  {
    volumes.SetStart(MeasureFragments(mesh, cells.Grid, fragments.Share(), run.TheRuntime));
  }
  std::vector<unsigned char> isThin =
    FindThinFragments(cells.Grid, mesh, labelled.Thin, fragments.Share());
  if (this->FlatAxis >= 0)
  {
    StraightenColumns(cells.Grid, this->FlatAxis, run.TheRuntime, mesh);
  }
  return { .Elements = std::move(mesh),
    .Facets = std::move(facets),
    .Volumes = std::move(volumes),
    .RequestedFamilies = std::move(labelled.Levels.RequestedFamilies),
    .Barrier = labelled.Barrier(),
    .Thin = labelled.Thin,
    .IsThin = std::move(isThin),
    .WholeCells = topology.WholeCells };
}

ActiveMesh& HexMethod::MakeActive(const MeshCells& cells, MeshRun& run, Draft& draft)
{
  this->Active =
    MakeActiveHexes(this->Labelled, run.Parts, draft.Elements, draft.IsThin, run.TheRuntime);
  if (this->FlatAxis >= 0)
  {
    ListColumns(cells.Grid, draft.Elements, this->FlatAxis, this->Active);
  }
  this->Corners.emplace(this->Active, draft.Elements);
  // Before the interfaces, which add to the peak of memory; cells of thin parts are compared with
  // the elements first. Bulges are measured by what is packed.
  if (draft.IsThin.empty() && !HasCurvedEdges(cells.Options))
  {
    this->Packed.emplace(draft.Elements, this->Active);
    ReleaseFreeMemory();
  }
  run.Clock.Update(0.16);
  return this->Active;
}

/// Frees the labels, unless coarse hexes refer to them.
std::unique_ptr<LevelInterfaces> HexMethod::FindInterfaces(
  const MeshCells& cells, const Draft&, MeshRun& run)
{
  LabelledGrid& labelled = this->Labelled;
  auto interfaces =
    std::make_unique<LevelInterfaces>(*labelled.Levels.Grid, cells.Fractions, labelled.Labels,
      std::move(labelled.Mixed), cells.Options.IsoValue, run.TheRuntime, labelled.Thin);
  if (labelled.Levels.Grid->IsUniform())
  {
    labelled.Labels = LabelArray();
    labelled.Narrow = NarrowVoid();
  }
  return interfaces;
}

void HexMethod::Attach(const LevelInterfaces& interfaces, const Draft& draft, MeshRun& run)
{
  AttachHexes(interfaces, *this->Labelled.Levels.Coarse, draft.Elements, draft.Facets,
    run.TheRuntime, this->Active);
}

SmoothingRamp HexMethod::Ramp(const MeshCells&) const
{
  SmoothingRamp ramp = HexRamp();
  if (this->Diagonals)
  {
    for (SmoothingStage& stage : ramp)
    {
      stage.Lambda *= TriangleLambdas;
    }
    ramp.back().HalfPower = TriangleHalfPower;
  }
  return ramp;
}

void HexMethod::StartMoves(
  const MeshCells& cells, const std::vector<FeatureKind>&, MeshRun&, Draft& draft)
{
  std::vector<int>().swap(this->Active.PointOf);
  if (HasCurvedEdges(cells.Options)) // bulges are measured by facets and ids
  {
    return;
  }
  if (!this->Packed)
  {
    this->Packed.emplace(draft.Elements, this->Active);
  }
  this->PointIds.emplace(draft.Elements.PointIds);
  this->Facets.emplace(draft.Facets);
  ReleaseFreeMemory();
}

/// Turns diagonals while the barrier grows; the last sweeps keep them.
void HexMethod::AfterSweep(const SmoothingStage&, int, Smoother& smoother)
{
  if (this->Diagonals)
  {
    for (int point : this->Diagonals->Turn(this->Active))
    {
      smoother.MarkPoint(point);
    }
  }
}

void HexMethod::RestoreDraft(const MeshCells&, MeshRun&, Draft& draft)
{
  if (this->Packed)
  {
    // Before the lists, which would add to the peak of memory.
    this->Active.Rings = HexRings();
    std::vector<CornerPosition>().swap(this->Active.CornerList);
    std::vector<CornerPosition>().swap(this->Active.CornerOffset);
    std::vector<ActiveFacet>().swap(this->Active.Facets);
    ReleaseFreeMemory();
    draft.Elements.PointIds = this->PointIds->Unpack();
    this->PointIds.reset();
    this->Packed->Unpack(draft.Elements, this->Active);
    this->Packed.reset();
  }
}

/// Smooths the transitions between levels, where no interface has moved points.
void HexMethod::EndMoves(MeshRun& run, Draft& draft)
{
  const bool hasLevels = !draft.Elements.Levels->IsUniform();
  const std::vector<unsigned char> moved =
    hasLevels ? this->Active.ListMoved(draft.Elements) : std::vector<unsigned char>();
  const std::vector<int> elements = std::move(this->Active.Elements);
  const std::vector<int> meshPoints = std::move(this->Active.MeshPoint);
  this->Active = ActiveMesh();
  if (this->Facets)
  {
    draft.Facets = this->Facets->Unpack();
    this->Facets.reset();
  }
  this->Corners->Restore(elements, meshPoints, run.TheRuntime, draft.Elements);
  this->Corners.reset();
  if (this->FlatAxis >= 0)
  {
    StraightenColumns(
      draft.Elements.Levels->Finest(), this->FlatAxis, run.TheRuntime, draft.Elements);
  }
  if (hasLevels)
  {
    run.Clock.Start("Smoothing transitions", 0.9);
    ReleaseFreeMemory();
    SmoothCoarse(*this->Labelled.Levels.Coarse, moved, draft.Elements, run.TheRuntime);
  }
}

} // namespace vfm
