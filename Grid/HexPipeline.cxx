#include "HexPipeline.h"

#include "ActiveHexes.h"
#include "HexEnergy.h"
#include "HexGeometry.h"
#include "OuterSmoothing.h"
#include "Pipeline.h"
#include "Quality.h"

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

} // namespace

Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  CheckOptions(options);
  report = MeshReport();
  StageClock clock(runtime, report);
  clock.Start("Assigning materials", 0.0);
  LabelArray labels = AssignMaterials(grid, fractions, options.IsoValue);
  clock.Start("Resolving labels", 0.05);
  const Partition partition(grid, runtime.Group());
  const ResolveReport resolved = ResolveLabels(grid, fractions, labels, partition);
  report.FlippedCells = resolved.FlippedCells;
  report.ResolveRounds = resolved.Rounds;
  clock.Start("Making hexahedra", 0.1);
  const std::vector<Index> mixed = FindMixedNodes(grid, labels);
  PointNumbering numbering(grid, labels, options.MeshVoid, options.Levels.Refinements > 0);
  const LevelHexes levels = MakeLevels(grid, labels, mixed, options, runtime);
  Mesh mesh =
    BuildHexes(grid, labels, mixed, options.StairStep, numbering, runtime, levels.Outer.get());
  mesh.Levels = levels.Grid;
  clock.Start("Finding geometry", 0.12);
  const Fragments fragments(grid, labels, options.MeshVoid, partition);
  report.NumberOfFragments = fragments.NumberOfFragments();
  FindHexGeometry(grid, labels, mixed, fragments, numbering, partition, mesh, report);
  clock.Start("Finding interfaces", 0.15);
  const bool smooth = !options.StairStep && options.Method != Smoothing::Off;
  const CellHomes homes(grid, labels, fragments);
  FragmentVolumes volumes(grid, fractions, fragments.MaterialsOfFragments(), homes, partition);
  std::vector<unsigned char> moved;
  if (smooth)
  {
    const Interface interface(grid, fractions, labels, mixed, options.IsoValue, runtime);
    clock.Start("Fitting surfaces", 0.2);
    const SurfaceTargets targets(interface, KindOfTargets(options), runtime);
    ActiveMesh active = MakeActiveHexes(interface, numbering, labels, fragments, partition, mesh);
    const PointExchange exchange(active, mesh, grid, partition);
    const HexEnergy energy(TargetJacobian(fractions, options));
    Improve({ active, targets, exchange, energy, Ramp, volumes,
              options.ConserveVolume && options.IsoValue == 0.5, {}, {} },
      clock, runtime);
    active.CopyTo(mesh, grid);
    moved = levels.Outer ? active.ListMoved(mesh) : moved;
  }
  if (smooth && levels.Outer)
  {
    clock.Start("Smoothing transitions", 0.9);
    ReleaseFreeMemory();
    SmoothOuter(*levels.Outer, moved, mesh, runtime);
  }
  KeepOwned(mesh, grid);
  ReportLevels(mesh, runtime.Group(), report);
  ReportVolumes(grid, volumes, report);
  if (options.ComputeQuality)
  {
    clock.Start("Measuring quality", 0.95);
    ComputeQuality(mesh, runtime, report);
  }
  return mesh;
}

} // namespace vfm
