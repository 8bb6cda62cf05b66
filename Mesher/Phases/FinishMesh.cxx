#include "Phases/FinishMesh.h"

#include "Base/PortableMath.h"
#include "Geometry/CloseSeam.h"
#include "Geometry/DisplacedVolume.h"
#include "Geometry/Geometry.h"
#include "Geometry/KeepOwned.h"
#include "Geometry/MeasureMaterials.h"
#include "Geometry/Quality.h"
#include "Phases/ReportLevels.h"

namespace vfm
{
namespace
{

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// Writes the volumes of materials and fragments into the report, in length units cubed, and the
/// number of fragments per material.
void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report)
{
  const double cellVolume = Cube(grid.MeanWidth());
  report.TargetVolume = Multiplied(volumes.MaterialTargets(), cellVolume);
  report.MeshVolume = Multiplied(volumes.MaterialVolumes(), cellVolume);
  report.FragmentTargetVolume = Multiplied(volumes.FragmentTargets(), cellVolume);
  for (Index fragments : volumes.MaterialFragments())
  {
    report.Materials.push_back({ 0, fragments });
  }
}

} // namespace

Mesh FinishMesh(const MeshCells& cells, ElementMethod& method, MeshRun& run, Draft draft)
{
  Mesh& mesh = draft.Elements;
  ReportVolumes(cells.Grid, draft.Volumes, run.Report);
  run.Clock.Start("Finding geometry", 0.93);
  ClassifyGeometry(draft.Facets, draft.Kinds, run.Parts, run.TheRuntime, mesh, run.Report);
  CloseSeam(run.Parts, mesh);
  KeepOwned(cells.Grid, draft.Barrier, run.TheRuntime, draft.WholeCells, mesh);
  ReportLevels(mesh, draft.RequestedFamilies, run.Group(), run.Report);
  method.Refill(cells, run, mesh);
  if (cells.Options.ComputeQuality)
  {
    run.Clock.Start("Measuring quality", 0.95);
    ComputeQuality(mesh, run.TheRuntime, run.Report, draft.WholeCells);
  }
  MeasureMaterials(mesh, run.Group(), run.Report);
  run.Report.DisplacedVolume = FindDisplacedVolumes(cells.Grid, cells.Fractions, mesh, run.Group());
  return std::move(mesh);
}

} // namespace vfm
