#include "TetPipeline.h"

#include "Mesh/Geometry.h"
#include "Mesh/KeepOwned.h"
#include "Mesh/MeasureFragments.h"
#include "Pipeline.h"
#include "Smoothing/Attach.h"
#include "Smoothing/CellLocator.h"
#include "Tet/CellTets.h"
#include "Tet/CoarseTets.h"
#include "Tet/DiagonalFlips.h"
#include "Tet/LatticeTopology.h"
#include "Tet/TetAttach.h"
#include "Tet/TetFragments.h"
#include "Tet/TetImprove.h"
#ifdef VFM_HAS_TETGEN
#include "Tet/RefillTets.h"
#endif

#include <memory>
#include <optional>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double ShareBeforeTetGen = 0.15; // of the progress, as of the time
constexpr int LateFlips = 5;               // sweeps between two rounds of flips in the last stage

/// Makes the mesh of Cells or Lattice.
class TetMesher : private MeshStages
{
public:
  using MeshStages::MeshStages;

  Mesh Make()
  {
    this->Clock.SetShare(this->Options.Tets == TetMethod::TetGen ? ShareBeforeTetGen : 1.0);
    this->Assign();
    this->Build();
    this->FindFragments();
    if (!this->Options.StairStep && this->Options.Method != Smoothing::Off)
    {
      this->Smooth();
    }
    ReportVolumes(this->Grid, *this->Volumes, this->Report);
    this->Clock.Start("Finding geometry", 0.9);
    Mesh& mesh = this->Topology.Tets;
    FillInside(mesh);
    ClassifyGeometry(this->ListFacets(), this->Kinds, this->Parts, mesh, this->Report);
    KeepOwned(mesh, this->Grid);
    ReportLevels(mesh, this->Levels.Asked, this->Run.Group(), this->Report);
    this->Refill();
    this->MeasureQuality(mesh);
    return std::move(mesh);
  }

private:
  /// The fragment of the points inside it.
  static void FillInside(Mesh& mesh)
  {
    mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
    for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
    {
      mesh.GeometryId[mesh.Elements[at]] = mesh.Fragment[at / 4];
    }
  }

  std::vector<Facet> ListFacets() const
  {
    return vfm::ListFacets(this->Faces, this->Grid, this->Parts, this->Topology.Tets);
  }

  void Refill()
  {
#ifdef VFM_HAS_TETGEN
    if (this->Options.Tets == TetMethod::TetGen)
    {
      this->Clock.SetShare(1.0);
      this->Clock.Start("Filling with TetGen", ShareBeforeTetGen);
      RefillTets(
        this->Topology.Tets, this->Grid, this->Labels, this->Options,
        [this](double done)
        { this->Clock.Update(ShareBeforeTetGen + (0.95 - ShareBeforeTetGen) * done); },
        this->Run.Group(), this->Report);
    }
#endif
  }

  void Assign()
  {
    this->Clock.Start("Assigning materials", 0.0);
    this->Labels = AssignMaterials(this->Grid, this->Fractions, this->Options.IsoValue);
    if (this->HasLevels() && this->Method == TetMethod::Lattice)
    {
      this->LabelsOfLevels =
        this->Labels; // before any is flipped: the lattice does not know of flips
    }
    this->Resolve(this->Labels);
  }

  void Build()
  {
    this->Clock.Start("Making tetrahedra", 0.1);
    const TetEnergy energy(FloorsOf(this->Options));
    std::optional<LatticeNodes> nodes;
    if (this->Method == TetMethod::Lattice)
    {
      nodes.emplace(this->Grid, this->Fractions, this->Options.IsoValue, this->Run);
    }
    const std::unique_ptr<const CoarseTets> made = this->MakeCoarse(nodes, energy);
    const CoarseTets& coarse = *made;
    if (nodes)
    {
      LatticeTets tets = BuildLatticeTets(
        this->Grid, *nodes, this->Options.MeshVoid, this->Parts, this->Run, coarse);
      this->Topology = std::move(tets.Topology);
      this->Faces = std::move(tets.Faces);
    }
    else
    {
      this->Topology =
        BuildCellTets(this->Grid, this->Labels, this->Options.MeshVoid, this->Run, coarse);
      this->Clock.Start("Finding faces", 0.12);
      this->Faces = FindTetFaces(this->Topology, this->Grid);
    }
  }

  bool HasLevels() const
  {
    return this->Options.Levels.Refinements > 0;
  }

  /// nodes: of Lattice. Refines more until all tets start positive.
  std::unique_ptr<const CoarseTets> MakeCoarse(
    const std::optional<LatticeNodes>& nodes, const TetEnergy& energy)
  {
    std::vector<Index> interfaces;
    if (this->HasLevels())
    {
      interfaces = nodes ? FindLatticeInterfaces(this->Grid, *nodes)
                         : FindMixedNodes(this->Grid, this->Labels);
    }
    const LabelArray& labels = this->HasLevels() && nodes ? this->LabelsOfLevels : this->Labels;
    LevelPlan plan = this->Options.Levels;
    for (;; ++this->Report.LevelRounds)
    {
      MakeLevels(this->Grid, labels, interfaces, { this->Options.MeshVoid, true, true }, plan,
        this->Run, this->Report, this->Levels);
      auto tets = std::make_unique<const CoarseTets>(*this->Levels.Coarse, energy, this->Run);
      if (!AddFamilies(tets->BadFamilies(), plan, this->Run.Group()))
      {
        return tets;
      }
    }
  }

  void FindFragments()
  {
    this->Clock.Start("Finding fragments", 0.15);
    Mesh& mesh = this->Topology.Tets;
    if (this->Method == TetMethod::Lattice)
    {
      const TetFragments fragments(this->Topology, this->Faces, this->Grid, this->Parts);
      this->Materials = fragments.Materials();
      this->Volumes = std::make_unique<FragmentVolumes>(
        this->Grid, this->Fractions, this->Materials, fragments, this->Run);
      this->Volumes->SetStart(MeasureFragments(
        mesh, this->Grid, static_cast<int>(this->Materials.size()) - 1, this->Run));
    }
    else
    {
      const Fragments fragments(this->Grid, this->Labels, this->Options.MeshVoid, this->Parts);
      this->Materials = fragments.MaterialsOfFragments();
      const CellLocator locator(*this->Topology.Tets.Levels, this->Labels, fragments);
      this->Volumes = std::make_unique<FragmentVolumes>(
        this->Grid, this->Fractions, this->Materials, locator, this->Run);
      this->FillFragments(fragments);
    }
    this->Report.NumberOfFragments = static_cast<Index>(this->Materials.size()) - 1;
  }

  /// The fragment of a tet of Cells is that of its cell: the lower one of an inner face, where both have one label.
  void FillFragments(const Fragments& fragments)
  {
    Mesh& mesh = this->Topology.Tets;
    mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
    for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
    {
      Index centre = mesh.Elements[4 * t + 3];
      if (IsCentre(mesh, mesh.PointIds[mesh.Elements[4 * t]]))
      {
        centre = mesh.Elements[4 * t];
      }
      mesh.Fragment[t] =
        fragments.FragmentOfCell(CellOfCentre(this->Grid, mesh, mesh.PointIds[centre]));
    }
  }

  void Smooth()
  {
    Mesh& mesh = this->Topology.Tets;
    this->Clock.Start("Finding interfaces", 0.2);
    const Interface interface(this->Grid, this->Fractions, this->Labels,
      FindMixedNodes(this->Grid, this->Labels), this->Options.IsoValue, this->Run);
    SurfaceTargets targets(interface, KindOfTargets(this->Options), this->Run);
    ActiveTets active = MakeActiveTets(this->Topology, this->Grid, this->Parts);
    const std::vector<CreaseKind> kinds = this->Attach(interface, targets, active);
    this->Kinds = active.OfMesh(kinds, mesh);
    const TetEnergy energy(FloorsOf(this->Options));
    std::optional<DiagonalFlips> flips;
    Improvement improvement{ active, targets, energy, TetRamp(), *this->Volumes, this->Report,
      this->Options.ConserveVolume && this->Options.IsoValue == 0.5, {}, {} };
    if (this->Method == TetMethod::Cells)
    {
      flips.emplace(mesh, active, energy, kinds);
      improvement.AfterSweep = [&](Smoother& smoother, const SmoothingStage& stage, int sweep)
      {
        if (stage.HalfPower < TetRamp().back().HalfPower || sweep % LateFlips == LateFlips - 1)
        {
          flips->Run(stage, [&](int point) { smoother.Wake(point); });
        }
      };
      improvement.AfterRamp = [&]
      {
        flips->CopyTo(mesh);
        this->Faces = FindTetFaces(this->Topology, this->Grid);
        SetFacets(this->ListFacets(), active);
      };
    }
    Improve(improvement, this->Clock, this->Run);
    active.CopyTo(mesh, this->Grid);
  }

  /// Returns the kinds of the active points.
  std::vector<CreaseKind> Attach(
    const Interface& interface, SurfaceTargets& targets, ActiveMesh& active)
  {
    const std::vector<Facet> facets = this->ListFacets();
    AttachTets(interface, this->Topology.Tets, facets, this->Method, this->Run, active);
    const bool hasQuads =
      this->Method == TetMethod::Cells && this->Options.Edges != SharpEdges::Off;
    const std::vector<Facet> quads =
      hasQuads ? JoinTriangles(facets, this->Faces, this->Topology.Tets) : std::vector<Facet>();
    std::vector<CreaseKind> kinds = this->AttachToCreases(
      interface, hasQuads ? quads : facets, this->Topology.Tets, targets, active);
    SetFacets(facets, active);
    return kinds;
  }

  const TetMethod Method =
    this->Options.Tets == TetMethod::Lattice ? TetMethod::Lattice : TetMethod::Cells;
  LabelArray Labels, LabelsOfLevels;
  LevelHexes Levels;
  TetTopology Topology;
  TetFaces Faces;
  std::vector<int> Materials; // of the fragments
  std::unique_ptr<FragmentVolumes> Volumes;
  std::vector<CreaseKind> Kinds; // of the points of the mesh; empty: none carries an edge
};

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
  own.Levels.FineInterfaces = true; // tets know no others
  return TetMesher(grid, fractions, own, runtime, report).Make();
}

} // namespace vfm
