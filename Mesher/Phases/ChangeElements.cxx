#include "Phases/ChangeElements.h"

#include "Elements/SelectPoints.h"
#include "Geometry/JoinCopies.h"
#include "Modify/AddLayers.h"
#include "Modify/AddMidNodes.h"
#include "Modify/CurvedVolumes.h"
#include "Modify/SplitInterfaces.h"

namespace vfm
{
namespace
{

/// Joins the copies of points. Their velocities are equal.
void JoinSides(const MesherJob& job, MesherResult& result)
{
  const std::vector<Index> kept = JoinCopies(job.Run, result.TheMesh);
  if (std::optional<TransferredArray>& velocity = result.State.NodalVelocity)
  {
    const Index size = 3 * sizeof(double);
    velocity->Values = Select(velocity->Values, kept, job.Run, size);
  }
}

/// Returns the lengths after which the domain repeats; 0 along other axes.
Vector3 FindPeriods(const MesherOptions& options, const CartesianGrid& grid)
{
  Vector3 periods{};
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    periods[a] = RepeatingAxes(options)[a] ? x.back() - x.front() : 0.0;
  }
  return periods;
}

/// Adds mid nodes, and reports the volumes of the curved elements.
void AddOrder(
  const MesherJob& job, const LevelFields& fields, const MeshOptions& options, MesherResult& result)
{
  const Materials& table = fields.Field.Table;
  Mesh& mesh = result.TheMesh;
  AppendFields(AddMidNodes(job.Options.ElementOrder, result.Fields, job.Run, mesh, result.State),
    result.Fields);
  result.Report.MeshVolume = MeasureCurvedVolumes(mesh, table.Labels, result.Fields, job.Run);
  ReplaceFields(
    ListReport(mesh, result.Report, table, options, fields.Field.Corrected, {}), result.Fields);
  ReplaceFields(ListMaterials(result.Report, table, options), result.MaterialFields);
}

} // namespace

void AddLayersAndJoin(const MesherJob& job, const Cells& cells, MesherResult& result)
{
  const CartesianGrid& grid = cells.Fields.Grid;
  AddLayers(job.Options,
    { grid.MeanWidth(), FindPeriods(job.Options, grid), cells.Fields.Field.Table.Labels,
      cells.LayerPairs ? &*cells.LayerPairs : nullptr },
    job.Run, result.TheMesh, result.State, result.Report);
  if (job.Options.Periodic != 0 && job.Options.PeriodicSides == Sides::Joined)
  {
    JoinSides(job, result);
  }
}

void SplitAndCurve(
  const MesherJob& job, const Cells& cells, const MeshOptions& options, MesherResult& result)
{
  if (cells.SplitPairs)
  {
    result.Cohesive = SplitMesh(*cells.SplitPairs, job.Options, job.Input.Warn, job.Run,
      result.Fields, result.TheMesh, result.State);
  }
  if (job.Options.ElementOrder != InterpolationOrder::Linear)
  {
    job.Run.Progress(0.99, "Adding mid nodes");
    AddOrder(job, cells.Fields, options, result);
  }
}

} // namespace vfm
