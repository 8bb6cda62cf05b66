#include "Mesher.h"

#include "Elements/CellRuns.h"
#include "Elements/MeshRun.h"
#include "Geometry/DisplacedVolume.h"
#include "Options/MaterialWidths.h"
#include "Options/SetOptions.h"
#include "Phases/ChangeElements.h"
#include "Phases/FlatLayer.h"
#include "Phases/GiveState.h"
#include "Phases/LeaveRuns.h"
#include "Phases/MeshOfCells.h"
#include "Phases/PlaceSurfaces.h"
#include "Phases/PrepareCells.h"
#include "Phases/ReportRun.h"
#include "Ranks/WorkTogether.h"

namespace vfm
{
namespace
{

Mesh MakeMesh(const MesherJob& job, const LevelFields& fields, const BodySurfaces* surfaces,
  const MeshOptions& options, CellRuns* leftOut, int flatAxis, bool areTriangles,
  MeshReport& report)
{
  const MeshCells cells{ fields.Grid, fields.Field.Fractions, options, surfaces, leftOut, flatAxis,
    areTriangles };
  Mesh mesh = MakeMeshOfCells(job.Options.Elements, cells, job.Run, report);
  if (report.RefusedParts > 0)
  {
    Warn(job,
      "TetGen rejected " + std::to_string(report.RefusedParts) +
        " parts of the mesh; they keep the tetrahedra of the method Cells.");
  }
  return mesh;
}

/// Interfaces cross levels also if materials have widths of their own.
bool HasFineInterfaces(const MesherOptions& options)
{
  return UsesTetGen(options) || (options.FineInterfaces && !HasMaterialWidths(options));
}

} // namespace

MesherResult RunMesher(
  const MesherInput& input, const MesherOptions& given, Runtime& runtime, CellRuns* leftOut)
{
  CheckOptions(given);
  MesherOptions options = given;
  options.FineInterfaces = HasFineInterfaces(given);
  if (given.Flat)
  {
    options.Elements = ElementKind::Hexes; // prisms, which become elements of the plane at the end
  }
  const MesherJob job{ input, options, runtime };

  const std::unique_ptr<Cells> cells = ReadCells(job);
  MatchSurfaces(job, *cells);
  const PreparedCells prepared = PrepareCells(job, *cells);
  MesherResult result;
  const std::unique_ptr<const BodySurfaces> surfaces = PlaceSurfaces(job, *cells);
  const bool areTriangles = given.Flat && given.Elements == ElementKind::Tets;
  const int flatAxis = given.Flat ? FindFlatAxis(*cells, prepared.Options) : -1;
  CellRuns* const runs = leftOut && !given.Flat && CanLeaveRuns(job, *cells) ? leftOut : nullptr;
  result.TheMesh = MakeMesh(job, cells->Fields, surfaces.get(), prepared.Options, runs, flatAxis,
    areTriangles, result.Report);
  if (cells->Wide.IsUsed() && result.Report.DisplacedVolume.empty())
  {
    result.Report.DisplacedVolume = FindDisplacedVolumes(
      cells->Fields.Grid, cells->Fields.Field.Fractions, result.TheMesh, runtime);
  }
  result.Report.RemovedRegions = prepared.Removed.Regions;
  result.Report.RemovedCells = prepared.Removed.Cells;
  result.Report.ChosenCells = cells->Requests.Cells;

  runtime.Progress(0.98, "Filling output");
  GiveState(job, prepared.Options, *cells, result);
  AddLayersAndJoin(job, *cells, result);
  if (given.Flat)
  {
    FlattenResult(job, flatAxis, areTriangles ? FlatElement::Triangle : FlatElement::Quad,
      cells->Fields.Grid, result);
  }
  GatherTables(job, result);
  WorkTogether(runtime.Group(), [&] { ListResult(job, *cells, prepared.Options, result); });
  if (given.Flat)
  {
    FlattenBounds(flatAxis, result.Fields);
  }
  SplitAndCurve(job, *cells, prepared.Options, result);
  if (runs)
  {
    UseLabels(cells->Fields.Field.Table, *runs);
  }
  WarnOfResult(job, *cells, result);
  return result;
}

} // namespace vfm
