/// Periodic cases.
#include "Properties.h"

#include "Fractions/GhostFractions.h"
#include "Fractions/RefineCells.h"
#include "GluedChecks.h"
#include "Octree/OctreeKeys.h"

#include <cmath>
#include <random>

namespace vfm
{
namespace testing
{
namespace
{

struct Torus
{
  const char* Name;
  Kind Elements;
  Sides SideKind;
  Seam SeamOf() const { return this->SideKind == Sides::Flat ? Seam::Flat : Seam::Free; }
};

FuzzCase CaseOf(const Torus& torus, const CartesianGrid& grid, FractionField field, int halvings)
{
  FuzzCase c = CaseOf(torus.Elements, grid, std::move(field), halvings);
  c.PeriodicSides = torus.SideKind;
  return c;
}

std::array<bool, 3> AxesOf(unsigned seed)
{
  const int axes = 1 + static_cast<int>(seed % 7);
  return { { (axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0 } };
}

Input MakeTorusLabels(const Torus& torus, unsigned seed)
{
  const Index sizes[] = { 3, 4, 7, 8 };
  const Index3 n{ { sizes[seed % 4], sizes[(seed / 2 + 1) % 4], sizes[(seed / 3) % 4] } };
  const CartesianGrid grid = MakePeriodicGrid(n, AxesOf(seed), torus.SeamOf());
  FuzzCase c = CaseOf(torus, grid, MakeRandomPeriodic(grid, 2, seed % 3 == 0 ? 1 : 0, seed), 0);
  c.Options.MeshVoid = seed % 2 == 0;
  return { c };
}

Input MakeTorusRanks(const Torus& torus, unsigned seed)
{
  const CartesianGrid grid =
    MakePeriodicGrid({ { 6, 5, 4 } }, { { seed % 3 != 1, true, seed % 3 != 2 } }, torus.SeamOf());
  Input input{ CaseOf(torus, grid, MakeRandomPeriodic(grid, 3, 0, seed), 0) };
  for (int ranks : { 2, 3, 8 })
  {
    input.Ranks.push_back(CutBox(grid.Domain(), ranks));
    input.Ranks.back().push_back(IndexBox());
  }
  return input;
}

/// Returns void with two balls, some across sides.
FractionField MakeBalls(const CartesianGrid& grid, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<std::array<double, 4>> balls(2);
  for (auto& ball : balls)
  {
    ball = { { uniform(random), uniform(random), uniform(random), 0.1 + 0.1 * uniform(random) } };
  }
  return MakePeriodicLabels(grid, 2,
    [&](const Index3& cell)
    {
      for (std::size_t b = 0; b < balls.size(); ++b)
      {
        double squares = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          const double size = static_cast<double>(grid.Domain().Size(a));
          const double away = std::abs((static_cast<double>(cell[a]) + 0.5) / size - balls[b][a]);
          squares += std::pow(std::min(away, 1.0 - away), 2);
        }
        if (squares < balls[b][3] * balls[b][3])
        {
          return static_cast<int>(b) + 1;
        }
      }
      return 0;
    });
}

/// Returns a grid of cubes whose base cells have 2^halvings cells along each axis.
CartesianGrid MakeTorusGrid(unsigned seed, int halvings, Seam seam)
{
  const Index n = std::min<Index>(6 + 2 * (seed % 3), 8) << halvings;
  return MakePeriodicGrid({ { n, n, n } }, AxesOf(seed), seam, GhostLayers << halvings);
}

/// Two of six seeds are compared on ranks.
Input MakeTorusLevels(const Torus& torus, unsigned seed)
{
  const int halvings = 1 + static_cast<int>(seed % 2);
  const CartesianGrid grid = MakeTorusGrid(seed, halvings, torus.SeamOf());
  Input input{ CaseOf(torus, grid, MakeBalls(grid, seed), halvings) };
  input.Case.Options.MeshVoid = seed % 4 < 2;
  for (int ranks : { 2, 3, 8 })
  {
    if (seed == 1 || seed == 2)
    {
      input.Ranks.push_back(CutBaseBox(grid, halvings, ranks));
    }
  }
  return input;
}

/// Few families are refined at random places of the domain, so that interfaces cross cells of both
/// levels and transition cells.
Input MakeTorusCrossing(const Torus& torus, unsigned seed)
{
  CartesianGrid grid = MakeTorusGrid(seed, 1, torus.SeamOf());
  const CartesianGrid base = ChangeLevel(grid, -1, 0);
  const OctreeKeys lattice(base, 1);
  std::mt19937 random(seed);
  std::vector<Index> families;
  ForCells(ChangeLevel(base.Domain(), -1),
    [&](const Index3& family)
    {
      if (random() % 12 == 0)
      {
        families.push_back(lattice.FamilyKey(0, family));
      }
    });
  LevelPlan plan;
  plan.Refinements = 1;
  plan.FineInterfaces = false;
  FractionField field = MakePeriodicPolycrystal(grid, seed, 5);
  Runtime alone;
  WidenGrid(LayersFor(plan), alone.Group(), grid, field);
  FuzzCase c = CaseOf(torus, grid, std::move(field), 1);
  c.Options.MeshVoid = seed % 2 == 0;
  c.Options.Levels.Families = { families };
  return { c };
}

} // namespace

void AddPeriods(std::vector<Group>& groups)
{
  Bounds levels, transitions;
  levels.HasLevels = transitions.HasTransitions = true;
  for (const Torus& torus :
    { Torus{ "FlatHexes", Hexes, Sides::Flat }, { "FlatLattice", Lattice, Sides::Flat },
      { "FlatCells", Cells, Sides::Flat }, { "FreeHexes", Hexes, Sides::Free },
      { "JoinedLattice", Lattice, Sides::Joined }, { "JoinedCells", Cells, Sides::Joined } })
  {
    const std::string name = torus.Name;
    groups.push_back(
      { "Torus_" + name, 16, [=](unsigned seed) { return MakeTorusLabels(torus, seed); } });
    groups.push_back(
      { "TorusRanks_" + name, 3, [=](unsigned seed) { return MakeTorusRanks(torus, seed); } });
    groups.push_back({ "TorusLevels_" + name, 6,
      [=](unsigned seed) { return MakeTorusLevels(torus, seed); }, levels });
  }
  for (const Torus& torus :
    { Torus{ "Flat", Crossing, Sides::Flat }, { "Free", Crossing, Sides::Free },
      { "FlatTets", CrossingTets, Sides::Flat }, { "JoinedTets", CrossingTets, Sides::Joined } })
  {
    groups.push_back({ std::string("TorusCrossing_") + torus.Name, 6,
      [=](unsigned seed) { return MakeTorusCrossing(torus, seed); }, transitions });
  }
}

} // namespace testing
} // namespace vfm
