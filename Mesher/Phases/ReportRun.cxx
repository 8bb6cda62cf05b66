#include "Phases/ReportRun.h"

#include "Geometry/EdgeFacets.h"
#include "Geometry/GatherTables.h"
#include "Materials/UseLabels.h"
#include "Phases/BodyFields.h"
#include "Ranks/Agreement.h"
#include "Report/FragmentTargets.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Warns of corrected input, an empty mesh, and materials without elements, with wrong
/// volumes, or in another place.
void WarnOfMesh(const MesherJob& job, const MeshReport& report, const Cells& cells)
{
  const InputField& field = cells.Fields.Field;
  const CorrectedCells& corrected = field.Corrected;
  if (corrected.Clipped > 0)
  {
    Warn(job,
      "Volume fractions of " + std::to_string(corrected.Clipped) +
        " cells lay outside [0, 1] and were clipped.");
  }
  if (corrected.Normalised > 0)
  {
    Warn(job,
      "The volume fractions of " + std::to_string(corrected.Normalised) +
        " cells sum to slightly more than 1 and were scaled back.");
  }
  const bool isEmpty = std::all_of(report.Materials.begin(), report.Materials.end(),
    [](const MeshReport::Material& material) { return material.Elements == 0; });
  const bool areExact = MovesPoints(job.Options) && ConservesVolume(job.Options);
  const bool isWide = cells.Wide.IsUsed();
  Warn(job,
    isEmpty    ? "The mesh is empty: no cell is filled by its materials to the iso value."
      : isWide ? DescribeWideLosses(report, field.Table, cells.Wide, areExact)
               : DescribeLostMaterials(report, field.Table));
  if (areExact)
  {
    Warn(job, isWide ? "" : DescribeInexactMaterials(report, field.Table, AreLabels(job)));
    Warn(job,
      DescribeDisplacedMaterials(
        report, field.Table, cells.Wide, job.Options.UnmeshedMaterial == Unmeshed::Particles));
  }
}

/// Returns the frame of the mesh that is returned.
ImageFrame FrameOf(const MesherJob& job)
{
  return job.Options.ImageAxes ? ImageFrame() : job.Input.Levels.Reading.Frame;
}

} // namespace

void GatherTables(const MesherJob& job, MesherResult& result)
{
  Ranks& ranks = job.Run.Group();
  if (ranks.Count() == 1 || job.Options.Flat)
  {
    return;
  }
  const TableMode mode = job.Options.WholeTables;
  const MeshReport& report = result.Report;
  GeometryTables& tables = result.TheMesh.Tables;
  const Index edgeFacets = SumOverRanks(static_cast<Index>(tables.EdgeFacets.size()), ranks);
  if (HasWholeTable(mode, std::max(report.NumberOfSurfaces, edgeFacets)))
  {
    GatherSurfaceTables(ranks, tables);
  }
  else
  {
    tables.EdgeFacets = ListEdgeFacetsOfElements(result.TheMesh);
    if (ranks.Any(!tables.PatchNames.empty()))
    {
      Warn(job,
        "The mesh has " + std::to_string(report.NumberOfSurfaces) +
          " surfaces. Their names in the surfaces of bodies are not in files of the mesh. They are "
          "with WholeTables On, which needs memory for all surfaces on every rank.");
    }
  }
  if (HasWholeTable(mode, std::max(report.NumberOfCurves, report.NumberOfVertices)))
  {
    GatherCurveTables(ranks, tables);
  }
}

void ListResult(
  const MesherJob& job, const Cells& cells, const MeshOptions& options, MesherResult& result)
{
  const LevelFields& fields = cells.Fields;
  const Materials& table = fields.Field.Table;
  const ImageFrame frame = FrameOf(job);
  TurnMesh(frame, result.TheMesh);
  UseLabels(table, result.TheMesh);
  if (result.State.TheParticles)
  {
    TurnPoints(frame, result.State.TheParticles->Positions); // state is turned already
    UseLabels(table, result.State.TheParticles->Material);
  }
  AppendFields(ListSides(result.TheMesh.Tables), result.Fields);
  const FieldArrays targets = ListFragmentTargets(result.Report.Fragments, job.Options.WholeTables,
    result.Report.NumberOfFragments, job.Run.Group());
  AppendFields(
    ListReport(result.TheMesh, result.Report, table, options, fields.Field.Corrected, targets),
    result.Fields);
  AppendFields(ListDomain(fields.Grid, frame, RepeatingAxes(job.Options)), result.Fields);
  AppendFields(ListMaterials(result.Report, table, options), result.MaterialFields);
  for (FieldArrays* to : { &result.Fields, &result.MaterialFields })
  {
    AppendFields(ListBodies(result.Report, table, fields.Grid.MeanWidth(), options.MeshVoid), *to);
  }
  AppendFields(ListReplaced(cells.Wide, options.MeshVoid), result.MaterialFields);
  if (cells.Wide.IsUsed())
  {
    const Vector3& widths = cells.Wide.Widths;
    result.Fields.push_back({ "CellWidths", std::vector<double>(widths.begin(), widths.end()) });
  }
  if (result.State.IsConserved)
  {
    AppendFields(ListBalance(result.State.Balance, options.MeshVoid), result.Fields);
    AppendFields(ListBalance(result.State.Balance, options.MeshVoid), result.MaterialFields);
  }
}

void WarnOfResult(const MesherJob& job, const Cells& cells, const MesherResult& result)
{
  WarnOfMesh(job, result.Report, cells);
  Warn(job,
    DescribeLostBodies(
      result.Report, cells.Fields.Field.Table, cells.Fields.Grid.MeanWidth(), FrameOf(job)));
  Warn(job, DescribeUnmeshed(result.State.Balance, cells.Fields.Field.Table));
}

} // namespace vfm
