#include "FuzzCase.h"

#include "Fractions/RefineCells.h"
#include "FuzzFields.h"
#include "FuzzGrids.h"
#include "FuzzPeriods.h"
#include "Labels/RefinementCriteria.h"
#include "Phases/MeshOfCells.h"

#include <cstdio>

namespace vfm
{
namespace testing
{
namespace
{

// approximate number of finest cells, times ranks
constexpr double LeastWork = 6.0, MaximumWork = 3000.0;
constexpr int MaximumCells = 12; // along an axis of the base

std::string ToText(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// Draws that determine the amount of work.
struct Extent
{
  int Refinements, Ranks;
  bool IsAutomatic; ///< refines where the fractions request it, otherwise at random
};

/// Returns the number of base cells along each axis; it is smaller if cells are
/// halved or several ranks mesh them.
Index3 DrawSize(const Extent& extent, RandomDraw& draw)
{
  const double work =
    draw.Scale(LeastWork, MaximumWork) / ((1 << 2 * extent.Refinements) * (1 + extent.Ranks));
  Index3 cells;
  double product = 1.0;
  for (Index& n : cells)
  {
    n = draw.Whole(1, MaximumCells);
    product *= static_cast<double>(n);
  }
  while (product > std::max(work, 1.0))
  {
    Index& longest = *std::max_element(cells.begin(), cells.end());
    product *= static_cast<double>(longest - 1) / static_cast<double>(longest);
    --longest;
  }
  return cells;
}

Extent DrawExtent(RandomDraw& draw)
{
  Extent extent;
  extent.Refinements = draw.Chance(0.5) ? 0 : (draw.Chance(0.75) ? 1 : 2);
  extent.IsAutomatic = draw.Chance(0.4);
  extent.Ranks = draw.Chance(0.6) ? 1 : draw.Whole(2, 4);
  return extent;
}

void DrawOptions(MeshOptions& options, RandomDraw& draw, std::string& words)
{
  if (draw.Chance(0.2))
  {
    options.IsoValue = draw.Pick({ 0.01, 0.3, 0.499, 0.7, 0.99 });
  }
  options.MeshVoid = draw.Chance(0.4);
  options.StairStep = draw.Chance(0.04);
  options.Smoothing = draw.Chance(0.75)
    ? SmoothingMethod::QuadricSurface
    : draw.Pick({ SmoothingMethod::GeometryBased, SmoothingMethod::Off });
  options.TargetScaledJacobian = draw.Chance(0.8) ? 0.0 : draw.Between(0.0, 0.99);
  options.ConserveVolume = draw.Chance(0.8);
  words += options.MeshVoid ? ", void meshed" : "";
  words += options.StairStep ? ", stair step" : "";
  words += options.Smoothing == SmoothingMethod::Off ? ", smoothing off" : "";
  words += options.Smoothing == SmoothingMethod::GeometryBased ? ", geometry based" : "";
  words += options.ConserveVolume ? "" : ", volumes free";
  words += options.IsoValue == 0.5 ? "" : ", iso value " + ToText(options.IsoValue);
  words +=
    options.TargetScaledJacobian == 0.0 ? "" : ", target " + ToText(options.TargetScaledJacobian);
}

TetGenOptions DrawTetGen(RandomDraw& draw)
{
  TetGenOptions options;
  if (draw.Chance(0.5))
  {
    options.RelativeSize = draw.Scale(0.5, 5.0);
    options.Growth = draw.Between(0.0, 1.0);
    options.RadiusEdgeRatio = draw.Between(1.1, 3.0);
    options.MinimumDihedralAngle = draw.Between(0.0, 20.0);
    options.OptimizationLevel = draw.Whole(0, 10);
  }
  return options;
}

/// Selects hexes half the time.
MeshMaker DrawMethod(MeshOptions& options, RandomDraw& draw, std::string& words)
{
  if (draw.Chance(0.55))
  {
    words += "hexes";
    return MakeHexMesh;
  }
  const bool isTetGen = HasTetGen() && draw.Chance(0.1);
  options.Method =
    isTetGen ? TetMethod::TetGen : draw.Pick({ TetMethod::Lattice, TetMethod::Cells });
  static_cast<TetGenOptions&>(options) = DrawTetGen(draw);
  words += NameOf(options.Method);
  return MakeTetMesh;
}

/// Returns a few boxes, or scattered single cells.
std::vector<ChosenBox> DrawChosen(const CartesianGrid& grid, int most, RandomDraw& draw)
{
  std::vector<ChosenBox> chosen(draw.Whole(1, 6));
  const bool areCells = draw.Chance(0.4);
  for (ChosenBox& box : chosen)
  {
    for (int a = 0; a < 3; ++a)
    {
      const int last = static_cast<int>(grid.Global().Upper[a]) - 1;
      const int lower = draw.Whole(0, last);
      box.Cells.Lower[a] = lower;
      box.Cells.Upper[a] = (areCells ? lower : draw.Whole(lower, last)) + 1;
    }
    box.Halvings = draw.Whole(1, most);
  }
  return chosen;
}

RefinementCriteria DrawCriteria(const CartesianGrid& grid, int most, RandomDraw& draw)
{
  RefinementCriteria criteria;
  criteria.MaximumLevel = most;
  criteria.CurvaturePerCell = draw.Pick({ 0.0, 0.3 });
  criteria.FlippedCells = draw.Chance(0.5);
  criteria.InterfaceLayers = draw.Pick({ 0, 0, 1, 3 });
  if (draw.Chance(0.4))
  {
    criteria.Chosen = DrawChosen(grid, most, draw);
    if (draw.Chance(0.5)) // only chosen cells
    {
      criteria.ThinCells = criteria.CurvaturePerCell = 0.0;
      criteria.FlippedCells = false;
      criteria.InterfaceLayers = 0;
    }
  }
  return criteria;
}

/// Halves cells where the criteria request it, and stores these places.
void RefineWhereRequested(const Extent& extent, RandomDraw& draw, FuzzCase& c)
{
  Runtime runtime;
  LevelPlan& plan = c.Options.Levels;
  const Partition partition(c.Grid, runtime.Group());
  const RefinementRequests requests = FindRefinement(c.Grid, c.Fractions,
    DrawCriteria(c.Grid, extent.Refinements, draw), c.Options.IsoValue, partition, runtime);
  plan.Refinements = requests.Refinements;
  plan.Families =
    FindRequestedFamilies(OctreeKeys(c.Grid, requests.Refinements), requests, draw.Whole(0, 1));
  const ChildRule rule = draw.Pick({ ChildRule::Planes, ChildRule::Parent });
  for (int step = 0; step < requests.Refinements; ++step)
  {
    RefinedCells refined = RefineCells(c.Grid, c.Fractions, runtime, rule);
    c.Grid = std::move(refined.Grid);
    c.Fractions = std::move(refined.Fractions);
  }
  c.Words += ", " + std::to_string(requests.Refinements) + " requested refinements, " +
    std::to_string(requests.ChosenCells) + " chosen";
}

void DrawFamilies(const Extent& extent, RandomDraw& draw, FuzzCase& c)
{
  const double chance = draw.Pick({ 0.0, 0.05, 0.2, 0.5, 1.0 });
  c.Options.Levels.Refinements = extent.Refinements;
  c.Options.Levels.Families = MakeRandomFamilies(c.Grid, extent.Refinements, chance, draw.Seed());
  c.Words += ", " + std::to_string(extent.Refinements) + " refinements of " + ToText(chance) +
    " of the families";
}

void DrawPlan(RandomDraw& draw, FuzzCase& c)
{
  LevelPlan& plan = c.Options.Levels;
  plan.FineInterfaces = draw.Chance(0.4);
  plan.FineLayers = draw.Pick({ 2, 2, 3, 5 });
  c.Words +=
    plan.FineInterfaces ? ", " + std::to_string(plan.FineLayers) + " fine layers" : ", crossing";
}

void DrawBoxes(const Extent& extent, RandomDraw& draw, FuzzCase& c)
{
  const int axis = draw.Whole(-1, 2);
  c.Boxes = CutBaseBox(c.Grid, c.Options.Levels.Refinements, extent.Ranks, axis);
  if (draw.Chance(0.2))
  {
    c.Boxes.insert(c.Boxes.begin() + draw.Whole(0, extent.Ranks), IndexBox());
  }
  c.Words += ", " + std::to_string(c.Boxes.size()) + " ranks" +
    (axis < 0 ? "" : std::string(" along ") + "xyz"[axis]);
}

/// Draws the option last, so that seeds give the same cases as before the option existed.
void DrawEdges(RandomDraw& draw, FuzzCase& c)
{
  c.Options.SharpEdges = draw.Pick(
    { SharpEdgeMode::Off, SharpEdgeMode::On, SharpEdgeMode::On, SharpEdgeMode::Automatic });
  c.Words += c.Options.SharpEdges == SharpEdgeMode::Off
    ? ""
    : (c.Options.SharpEdges == SharpEdgeMode::On ? ", sharp edges" : ", sharp edges automatically");
}

/// Draws the order of the elements, after all other options. TetGen fills the parts of ranks apart.
void DrawOrder(RandomDraw& draw, FuzzCase& c)
{
  if (draw.Chance(0.3) && (c.Make == MakeHexMesh || c.Options.Method != TetMethod::TetGen))
  {
    c.Options.ElementOrder =
      draw.Pick({ InterpolationOrder::Quadratic, InterpolationOrder::Quadratic27 });
    c.Words +=
      c.Options.ElementOrder == InterpolationOrder::Quadratic ? ", quadratic" : ", quadratic 27";
    if (c.Make == MakeHexMesh && !c.Options.StairStep && draw.Chance(0.5))
    {
      c.Layers = 3;
      c.FirstLayer = 0.1 * c.Grid.MeanWidth();
      c.Words += ", layers";
    }
  }
}

/// Draws layers and split interfaces of linear elements, after all other options.
void DrawModified(RandomDraw& draw, FuzzCase& c)
{
  const bool hasLayers = draw.Chance(0.3), isSplit = draw.Chance(0.3);
  const bool isHexes = c.Make == MakeHexMesh;
  if (c.Options.ElementOrder != InterpolationOrder::Linear)
  {
    return;
  }
  if (hasLayers && isHexes && !c.Options.StairStep)
  {
    c.Layers = draw.Whole(2, 4);
    c.FirstLayer = draw.Chance(0.5) ? 0.0 : draw.Between(0.02, 0.3) * c.Grid.MeanWidth();
    c.Words += ", " + std::to_string(c.Layers) + " layers";
  }
  if (isSplit && (isHexes || c.Options.Method != TetMethod::TetGen))
  {
    c.Split = draw.Chance(0.5) ? "all" : "1/*";
    c.Words += ", split " + c.Split;
  }
}

/// Draws the option last, so that seeds give the same cases as before the option existed.
void DrawThinParts(RandomDraw& draw, FuzzCase& c)
{
  c.Options.ThinParts = draw.Chance(0.4);
  c.Options.LeastThickness = draw.Pick({ 0.0, 0.25, 0.25, 0.5, 1.0 });
  if (KeepsThinParts(c.Options))
  {
    c.Words += ", thin parts above " + ToText(c.Options.LeastThickness);
  }
}

/// Draws the option after all others, as DrawThinParts.
void DrawFar(RandomDraw& draw, FuzzCase& c)
{
  c.Options.LeavesFar = draw.Chance(0.4);
  c.Words += c.Options.LeavesFar ? ", leaves far matter" : "";
}

void PrintList(const char* name, const std::vector<double>& values)
{
  std::printf("%s", name);
  for (double value : values)
  {
    std::printf(" %.17g", value);
  }
  std::printf("\n");
}

} // namespace

FuzzCase MakeFuzzCase(unsigned seed, bool isPeriodic)
{
  RandomDraw draw(seed);
  const Extent extent = DrawExtent(draw);
  MeshOptions options;
  std::string words;
  const MeshMaker make = DrawMethod(options, draw, words);
  DrawOptions(options, draw, words);
  const Index3 size = DrawSize(extent, draw);
  const FuzzGrid base =
    DrawGrid(isPeriodic ? FitPeriods(size, extent.Refinements > 0) : size, draw);
  const bool isAutomatic = extent.Refinements > 0 && extent.IsAutomatic;
  const CartesianGrid grid = isAutomatic
    ? base.Grid
    : CartesianGrid(HalveWidths(base.Grid.Coordinates(), extent.Refinements));
  const int materials = draw.Chance(0.3) ? 1 : draw.Whole(2, 6);
  std::string kind;
  FractionField field = DrawField(grid, materials, draw, kind);
  FuzzCase c{ kind, kind + " of " + std::to_string(materials) + " in " + base.Words + ", " + words,
    grid, std::move(field), options, make, {}, base.HasCubes };
  if (extent.Refinements > 0)
  {
    DrawPlan(draw, c);
    isAutomatic ? RefineWhereRequested(extent, draw, c) : DrawFamilies(extent, draw, c);
  }
  if (extent.Ranks > 1)
  {
    DrawBoxes(extent, draw, c);
  }
  DrawEdges(draw, c);
  if (isPeriodic)
  {
    DrawPeriods(draw, c);
  }
  else
  {
    DrawOrder(draw, c);
    DrawModified(draw, c);
  }
  DrawThinParts(draw, c);
  DrawFar(draw, c);
  return c;
}

void PrintCase(const FuzzCase& c)
{
  const char* const names[] = { "x", "y", "z" };
  for (int a = 0; a < 3; ++a)
  {
    PrintList(names[a], c.Grid.Coordinates(a));
  }
  for (std::size_t level = 0; level < c.Options.Levels.Families.size(); ++level)
  {
    std::printf("families of level %zu:", level);
    for (Index key : c.Options.Levels.Families[level])
    {
      std::printf(" %lld", static_cast<long long>(key));
    }
    std::printf("\n");
  }
  ForCells(c.Grid.Domain(),
    [&](const Index3& p)
    {
      const Index cell = c.Grid.Linear(p);
      std::printf("cell %lld %lld %lld:", static_cast<long long>(p[0]),
        static_cast<long long>(p[1]), static_cast<long long>(p[2]));
      for (int m = 0; m <= c.Fractions.NumberOfMaterials(); ++m)
      {
        std::printf(" %.17g", c.Fractions.Fraction(cell, m));
      }
      std::printf("\n");
    });
}

} // namespace testing
} // namespace vfm
