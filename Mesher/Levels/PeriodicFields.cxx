#include "Levels/PeriodicFields.h"

#include "Fractions/GhostFractions.h"
#include "Input/NodeCoordinates.h"

namespace vfm
{
namespace
{

constexpr Index FewestCells = 3; // with two, different hexahedra would have the same points

void CheckSizes(const MesherOptions& options, const IndexBox& cells)
{
  for (int a = 0; a < 3; ++a)
  {
    if (RepeatingAxes(options)[a] && cells.Size(a) < FewestCells)
    {
      throw InputError("A periodic mesh needs at least " + std::to_string(FewestCells) +
        " cells along " + AxisNames[a] + ", not " + std::to_string(cells.Size(a)) + ".");
    }
  }
}

} // namespace

void CheckPeriods(
  const MesherOptions& options, const InputLevels& input, const LevelSetup& setup)
{
  if (options.Periodic == 0)
  {
    return;
  }
  CheckSizes(options, input.Levels[0].Global());
  if (options.Elements == ElementKind::Tets && options.PeriodicSides == Sides::Free)
  {
    throw InputError("PeriodicSides is Free: the sides of tetrahedra can only be Flat or Joined.");
  }
  if (options.NodalVelocity)
  {
    throw InputError("NodalVelocity is not available for periodic meshes.");
  }
  if (setup.Refinements() > 0 || setup.Finest != 0 || input.Finest() > 0)
  {
    throw InputError("A periodic mesh cannot be refined yet: set Refinement to Off, and Periodic "
                     "only for input of one level.");
  }
}

void AddCopies(const MesherOptions& options, Ranks& ranks, LevelFields& fields)
{
  if (options.Periodic == 0)
  {
    return;
  }
  const CartesianGrid& grid = fields.Grid;
  ReplaceGrid(CartesianGrid::Covering(grid.Coordinates(), grid.Owned(), RepeatingAxes(options),
                options.PeriodicSides == Sides::Flat ? Seam::Flat : Seam::Free, GhostLayers),
    ranks, fields.Grid, fields.Field.Fractions);
  fields.Base = fields.Grid;
}

void RemoveCopies(Ranks& ranks, LevelFields& fields)
{
  if (fields.Grid.IsPeriodic())
  {
    ReplaceGrid(fields.Grid.OfDomain(GhostLayers), ranks, fields.Grid, fields.Field.Fractions);
    fields.Base = fields.Grid;
  }
}

} // namespace vfm
