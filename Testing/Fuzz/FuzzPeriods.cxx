#include "FuzzPeriods.h"

#include "Fractions/CoarsenFields.h"
#include "Fractions/GhostFractions.h"
#include "Levels/PeriodicFields.h"

namespace vfm
{
namespace testing
{
namespace
{

constexpr Index FewestCells = 3, MostCells = 8; // along an axis

/// Moves the cells of ranks to their place in a grid with copies.
void MoveBoxes(FuzzCase& c)
{
  for (IndexBox& box : c.Boxes)
  {
    box = box.NumberOfCells() > 0 ? Moved(box, c.Grid.Domain().Lower) : box;
  }
}

void AddCopies(const MesherOptions& options, FuzzCase& c)
{
  Runtime alone;
  LevelPlan& plan = c.Options.Levels;
  LevelSetup setup;
  setup.Finest = plan.Refinements;
  setup.IsUniform = plan.Refinements == 0;
  plan.Families.resize(plan.Refinements);
  LevelFields fields{ CoarsenGrid(c.Grid, plan.Refinements, GhostLayers), c.Grid,
    { std::move(c.Fractions), {}, {} }, std::move(plan.Families), {} };
  vfm::AddCopies(options, setup, alone.Group(), fields);
  c.Grid = std::move(fields.Grid);
  c.Fractions = std::move(fields.Field.Fractions);
  plan.Families = std::move(fields.Families);
  plan.FineInterfaces |=
    c.Make == MakeTetMesh && c.Options.Method == TetMethod::TetGen; // it supports nothing else
  if (InterfacesCrossLevels(c.Options))
  {
    WidenGrid(LayersFor(plan), alone.Group(), c.Grid, c.Fractions);
  }
}

} // namespace

Index3 FitPeriods(const Index3& cells, bool isRefined)
{
  Index3 fitting = cells;
  for (Index& n : fitting)
  {
    n = std::min(std::max(n, FewestCells), MostCells);
    n += isRefined ? n % 2 : 0;
  }
  return fitting;
}

void DrawPeriods(RandomDraw& draw, FuzzCase& c)
{
  MesherOptions options;
  options.Periodic = draw.Pick({ 1, 2, 3, 4, 5, 6, 7, 7, 7 });
  // Sides of tetrahedra can only be flat or joined.
  c.PeriodicSides = options.PeriodicSides = c.Make == MakeTetMesh
    ? draw.Pick({ Sides::Flat, Sides::Joined })
    : draw.Pick({ Sides::Flat, Sides::Free, Sides::Joined });
  AddCopies(options, c);
  MoveBoxes(c);
  c.Words += ", periodic along ";
  for (int a = 0; a < 3; ++a)
  {
    c.Words += options.Periodic >> a & 1 ? std::string(1, "xyz"[a]) : "";
  }
  c.Words += options.PeriodicSides == Sides::Flat ? ", flat sides"
    : options.PeriodicSides == Sides::Free        ? ", free sides"
                                                  : ", joined sides";
}

} // namespace testing
} // namespace vfm
