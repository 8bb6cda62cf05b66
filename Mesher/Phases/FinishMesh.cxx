#include "Phases/FinishMesh.h"

#include "Elements/CellRuns.h"
#include "Geometry/CloseSeam.h"
#include "Geometry/DisplacedVolume.h"
#include "Geometry/DivideInterfaces.h"
#include "Geometry/Geometry.h"
#include "Geometry/KeepOwned.h"
#include "Geometry/MeasureMaterials.h"
#include "Geometry/Quality.h"
#include "Geometry/ReportLevels.h"
#include "GivenSurfaces/LostSurface.h"

namespace vfm
{
namespace
{

/// Replaces the numbers that fragments have on this rank by those over all ranks.
void UseNumbersOfAllRanks(
  const FragmentShare& share, Runtime& runtime, std::vector<Facet>& facets, Mesh& mesh)
{
  if (static_cast<Index>(share.Size()) == share.Total + 1) // both are equal
  {
    return;
  }
  const auto replace = [&](Buffer<int>& numbers)
  {
    ForEach(runtime, static_cast<Index>(numbers.size()),
      [&](Index i) { numbers[i] = share.Ids[numbers[i]]; });
  };
  replace(mesh.Fragment);
  replace(mesh.GeometryId); // of points inside fragments; others get theirs later
  for (Facet& facet : facets)
  {
    facet.Fragments = { { share.Ids[facet.Fragments[0]], share.Ids[facet.Fragments[1]] } };
  }
}

} // namespace

Mesh FinishMesh(const MeshCells& cells, ElementMethod& method, MeshRun& run, Draft draft)
{
  Mesh& mesh = draft.Elements;
  ReportVolumes(cells.Grid, draft.Volumes, run.Report);
  run.Clock.Start("Finding geometry", 0.93);
  UseNumbersOfAllRanks(draft.Volumes.Share(), run.TheRuntime, draft.Facets, mesh);
  ClassifyGeometry(draft.Facets,
    DivideInterfaces(draft.Facets, draft.Kinds, mesh, cells.Surfaces, run.Parts, run.TheRuntime),
    run.TheRuntime, mesh, run.Report);
  std::vector<Facet>().swap(draft.Facets); // before other lists of facets take memory
  CloseSeam(run.Parts, mesh);
  KeepOwned(cells.Grid, draft.Barrier, run.TheRuntime, draft.WholeCells, mesh);
  ReportLevels(mesh, draft.RequestedFamilies, run.Group(), run.Report);
  method.Refill(cells, run, mesh);
  if (cells.Options.ComputeQuality)
  {
    run.Clock.Start("Measuring quality", 0.95);
    ComputeQuality(
      mesh, run.TheRuntime, run.Report, draft.WholeCells, cells.Runs ? cells.Runs->Count() : 0);
  }
  MeasureMaterials(mesh, run.Group(), run.Report, cells.Runs);
  mesh.Far = draft.Volumes.TakeFar();
  if (run.Report.ThinPartCells > 0)
  {
    run.Report.DisplacedVolume =
      FindDisplacedVolumes(cells.Grid, cells.Fractions, mesh, run.TheRuntime);
  }
  if (cells.Surfaces)
  {
    run.Clock.Start("Comparing surfaces", 0.97);
    run.Report.Bodies =
      CompareBodies(*cells.Surfaces, cells.Grid, cells.Fractions, mesh, run.TheRuntime);
  }
  return std::move(mesh);
}

} // namespace vfm
