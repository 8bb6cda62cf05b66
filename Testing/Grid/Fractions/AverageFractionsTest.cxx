/// Averages of fractions over adjacent cells.
#include "Fractions/AverageFractions.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(AverageFractions, WeightsOfOnePass)
{
  const std::vector<double> x{ 0, 1, 2, 3, 4, 5, 6, 7 };
  const CartesianGrid grid(std::array<std::vector<double>, 3>{ { x, x, x } });
  FractionField field(grid, 1);
  field.SetLabel(grid.Linear({ { 3, 3, 3 } }), 1);
  Runtime runtime;
  const Partition partition(grid, runtime.Group());
  const FractionField mean = AverageFractions(grid, field, 1, partition, runtime);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      double weight = 1.0;
      for (Index i : p)
      {
        weight *= i == 3 ? 0.5 : i == 2 || i == 4 ? 0.25 : 0.0;
      }
      ASSERT_NEAR(mean.Fraction(grid.Linear(p), 1), weight, 1e-15);
    });
}

// Cells on the sides of the domain keep their fractions, so the cells near the sides are full here.
TEST(AverageFractions, VolumesStay)
{
  const CartesianGrid grid = MakeUnevenGrid(12);
  FractionField field = MakePatchyFractions(grid, 3, 8);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      if (std::any_of(p.begin(), p.end(), [](Index i) { return i < 4 || i >= 8; }))
      {
        field.SetLabel(grid.Linear(p), 1);
      }
    });
  Runtime runtime;
  const Partition partition(grid, runtime.Group());
  const FractionField mean = AverageFractions(grid, field, 3, partition, runtime);
  for (int material = 0; material <= 3; ++material)
  {
    double change = 0.0, moved = 0.0;
    ForCells(grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = grid.Linear(p);
        const double gain =
          grid.CellVolume(p) * (mean.Fraction(cell, material) - field.Fraction(cell, material));
        change += gain;
        moved += std::fabs(gain);
      });
    EXPECT_NEAR(change, 0.0, 1e-9) << material;
    EXPECT_GT(moved, 1.0) << material;
  }
}
