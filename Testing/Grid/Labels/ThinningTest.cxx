/// Thinning neither joins nor divides, and leaves nothing that could leave.
#include "Labels/Thinning.h"
#include "Labels/ThinCandidates.h"

#include "Cells/CellParts.h"
#include "MeshChecks.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "Sweep.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns fractions of one material in a share of the cells, some of them above one half.
FractionField MakeCrumbs(const CartesianGrid& grid, unsigned seed)
{
  RandomDraw draw(seed);
  FractionField fractions(grid, 1);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      if (draw.Chance(0.5))
      {
        fractions.SetParts(grid.Linear(p), { { 1, draw.Between(0.0, 0.6) } });
      }
    });
  return fractions;
}

TEST(Thinning, NeitherJoinsNorDivides)
{
  const CartesianGrid grid = MakeUnitGrid(13, 12, 11);
  for (unsigned seed : ListSeeds(20))
  {
    Runtime runtime;
    const FractionField fractions = MakeCrumbs(grid, seed);
    const LabelArray labels = AssignMaterials(grid, fractions, 0.5);
    ThinCandidates candidates(grid, fractions, labels, runtime);
    const auto isIn = [&](Index cell) { return candidates.IsInSet(cell, 1); };
    const auto isOut = [&](Index cell) { return !candidates.IsInSet(cell, 1); };
    const int parts = CountCellParts(grid, Joins::Faces, isIn),
              rest = CountCellParts(grid, Joins::FacesEdgesCorners, isOut);
    ThinSets(grid, Partition(grid, runtime.Group()), runtime, candidates);
    EXPECT_EQ(CountCellParts(grid, Joins::Faces, isIn), parts) << seed;
    EXPECT_EQ(CountCellParts(grid, Joins::FacesEdgesCorners, isOut), rest) << seed;
    int removed = 0;
    for (std::size_t n = 0; n < candidates.Size(); ++n)
    {
      removed += !candidates.IsIn(n);
    }
    EXPECT_GT(removed, 0) << seed;
  }
}

/// A cloud of small fractions has a skin; its inside leaves.
TEST(Thinning, CloudsAreHollow)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  FractionField fractions(grid, 1);
  ForCells({ { { 3, 3, 3 } }, { { 9, 9, 9 } } },
    [&](const Index3& p) {
      fractions.SetParts(grid.Linear(p), { { 1, 0.3 } });
    });
  Runtime runtime;
  const LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  ThinCandidates candidates(grid, fractions, labels, runtime);
  ASSERT_EQ(candidates.Size(), 216u);
  ThinSets(grid, Partition(grid, runtime.Group()), runtime, candidates);
  int inside = 0, skin = 0;
  for (std::size_t n = 0; n < candidates.Size(); ++n)
  {
    const Index3 p = grid.Position(candidates[n].Cell);
    const bool isInside = IndexBox{ { { 4, 4, 4 } }, { { 8, 8, 8 } } }.Contains(p);
    (isInside ? inside : skin) += candidates.IsIn(n);
  }
  EXPECT_EQ(inside, 0);
  EXPECT_GT(skin, 0);
}

} // namespace
