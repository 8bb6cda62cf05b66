/// Loads of cells and thickness of parts.
#include "Labels/ThinSizes.h"

#include "Cells/ThinShapes.h"
#include "Labels/Thinning.h"
#include "MeshCases.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Each cell near the set gives all its material to cells of the set.
TEST(ThinSizes, LoadsHoldAllMaterialNearby)
{
  const CartesianGrid grid = MakeUnitGrid(9, 8, 7);
  RandomDraw draw(3);
  FractionField fractions(grid, 1);
  std::vector<unsigned char> isInSet(grid.NumberOfEntries(), 0);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      fractions.SetParts(grid.Linear(p), { { 1, draw.Between(0.01, 0.99) } });
      isInSet[grid.Linear(p)] = draw.Chance(0.05);
    });
  double near = 0.0, loads = 0.0;
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      bool isNear = false;
      for (int n = 0; n < 27; ++n)
      {
        const Index3 q = CellAround(p, n);
        isNear = isNear || (grid.InDomain(q) && isInSet[grid.Linear(q)]);
      }
      near += isNear ? fractions.Fraction(grid.Linear(p), 1) : 0.0;
      if (isInSet[grid.Linear(p)])
      {
        const double load = FindLoad(
          grid, fractions, grid.Linear(p), 1, [&](Index cell) { return isInSet[cell] != 0; });
        EXPECT_GE(load, fractions.Fraction(grid.Linear(p), 1));
        loads += load;
      }
    });
  EXPECT_GT(loads, 1.0);
  EXPECT_NEAR(loads, near, 1e-9);
}

/// Returns the share of refused candidates of a thinned film, away from the sides of the domain.
double ShareRefused(const Vector3& normal, double thickness)
{
  constexpr double LeastThickness = 0.4;
  const CartesianGrid grid = MakeUnitGrid(16);
  const FractionField film =
    FractionsOfShapes(grid, { MakeFilm({ { 8.1, 7.7, 8.4 } }, normal, thickness) });
  Runtime runtime;
  const LabelArray labels = AssignMaterials(grid, film, 0.5);
  ThinCandidates candidates(grid, film, labels, runtime);
  ThinSets(grid, Partition(grid, runtime.Group()), runtime, candidates);
  const std::vector<double> loads = FindLoads(grid, film, candidates, runtime);
  double count = 0.0, refused = 0.0;
  for (std::size_t n = 0; n < candidates.Size(); ++n)
  {
    const IndexBox inside{ { { 3, 3, 3 } }, { { 13, 13, 13 } } };
    if (candidates.IsIn(n) && inside.Contains(grid.Position(candidates[n].Cell)))
    {
      count += 1.0;
      refused += IsRefused(grid, film, candidates, loads, LeastThickness, n);
    }
  }
  EXPECT_GT(count, 50.0);
  return refused / count;
}

/// The thickness of a film is measured within a fifth, for any direction.
TEST(ThinSizes, ThicknessOfFilms)
{
  for (const Vector3& normal : ListDirections(12))
  {
    EXPECT_LT(ShareRefused(normal, 0.48), 0.05) << normal[0] << " " << normal[1];
    EXPECT_GT(ShareRefused(normal, 0.32), 0.95) << normal[0] << " " << normal[1];
  }
}

} // namespace
