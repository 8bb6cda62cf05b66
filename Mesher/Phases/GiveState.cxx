#include "Phases/GiveState.h"

#include "Geometry/LeaveCovering.h"
#include "Levels/PeriodicFields.h"
#include "Report/SeamFacets.h"

namespace vfm
{
namespace
{

/// Turns a periodic mesh into a mesh of the domain.
void LeaveCopies(const MesherJob& job, LevelFields& fields, Mesh& mesh)
{
  if (fields.Grid.IsPeriodic())
  {
    const bool joins = job.Options.PeriodicSides == Sides::Joined;
    LeaveCovering(
      Partition(fields.Grid, job.Run.Group()), joins ? Partner::Upper : Partner::Lowest, mesh);
    RemoveCopies(job.Run.Group(), fields);
    if (!joins)
    {
      AddSeamFacets(
        ListDomain(fields.Grid, ImageFrame(), RepeatingAxes(job.Options)), job.Run.Group(), mesh);
    }
  }
}

MeshedGrid DescribeGrid(const LevelFields& fields, const LevelSetup& setup, const LevelPlan& plan)
{
  const int finest = setup.IsUniform ? setup.Finest : setup.Base + plan.Refinements;
  return { fields.Grid, fields.Field.Fractions, finest,
    fields.Division.OfHalves(finest - setup.Base) };
}

} // namespace

void GiveState(const MesherJob& job, const MeshOptions& options, Cells& cells, MesherResult& result)
{
  result.State = MakeOutputState(cells.State, cells.Input, result.TheMesh,
    DescribeGrid(cells.Fields, cells.Setup, options.Levels), job.Options, cells.Owners, job.Run);
  std::vector<FarMatter>().swap(result.TheMesh.Far);
  LeaveCopies(job, cells.Fields, result.TheMesh); // after the state, which takes cells across sides
}

} // namespace vfm
