/// Fractions of an input of two levels that repeats: coarse cells at sides are halved with their
/// neighbours across.
#include "Input/InputFractions.h"
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "Levels/LevelFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Size = 12; // cells of level 0 along each axis
constexpr int Samples = 8; // along each axis of a cell

/// Returns the fraction of a ball of radius 3.3 in a cell, in cells of level 0.
/// @param centre  centre of the ball; its copies count too
double FractionOfBall(const Vector3& lower, double width, double centre)
{
  int inside = 0;
  ForCells({ {}, { { Samples, Samples, Samples } } },
    [&](const Index3& sample)
    {
      double squares = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double x = lower[a] + width * (static_cast<double>(sample[a]) + 0.5) / Samples;
        const double away = std::fabs(x - centre);
        squares += std::pow(std::min(away, Size - away), 2);
      }
      inside += squares < 3.3 * 3.3;
    });
  return static_cast<double>(inside) / (Samples * Samples * Samples);
}

/// Returns the fractions of the finest level for a ball and a fine box beside it, both moved by
/// some cells along each axis.
LevelFields MakeFields(Index shift, bool repeats, Runtime& runtime)
{
  const Index first = 6 + shift;
  MesherInput input = MakeLevelInput({ { { Size, Size, Size } }, 0.0, 1.0 },
    { { { { first, first, first } }, { { first + 1, first + 1, first + 1 } } } }, runtime.Group());
  for (InputBlocks& level : input.Levels.Levels)
  {
    for (InputBlock& block : level.Blocks)
    {
      std::vector<double> fractions;
      ForCells(block.Box,
        [&](const Index3& cell)
        {
          const auto& x = level.Coordinates;
          fractions.push_back(FractionOfBall({ { x[0][cell[0]], x[1][cell[1]], x[2][cell[2]] } },
            x[0][1] - x[0][0], static_cast<double>(shift)));
        });
      auto arrays = std::make_shared<PlainArrays>(block.Arrays);
      arrays->Store("ball", ValueType::Double, std::move(fractions));
      block.Arrays = arrays;
    }
  }
  LevelSetup setup;
  setup.Finest = 1;
  setup.TakesInputLevels = true;
  const LevelCells cells =
    OpenFractions(input.Levels.Levels, { "ball" }, 1e-6, "--labels", runtime.Group());
  return MakeLevelFields(input.Levels, cells, setup, ChildRule::Planes,
    { { repeats, repeats, repeats } }, input.Levels.Levels[0].Places, runtime);
}

/// Returns the largest difference between a field with a ball across all sides and the moved one
/// with the ball inside.
double FindDifference(bool repeats)
{
  constexpr Index Shift = 5;
  Runtime serial;
  const LevelFields across = MakeFields(0, repeats, serial);
  const LevelFields inside = MakeFields(Shift, repeats, serial);
  double largest = 0.0;
  ForCells(across.Grid.Owned(),
    [&](const Index3& cell)
    {
      Index3 moved = cell;
      for (Index& i : moved)
      {
        i = (i + 2 * Shift) % (2 * Size);
      }
      largest = std::max(largest,
        std::fabs(across.Field.Fractions.Fraction(across.Grid.Linear(cell), 1) -
          inside.Field.Fractions.Fraction(inside.Grid.Linear(moved), 1)));
    });
  return largest;
}

} // namespace

TEST(PeriodicLevels, CellsAreHalvedAcrossSides)
{
  EXPECT_LT(FindDifference(true), 1e-9);
  EXPECT_GT(FindDifference(false), 0.01);
}
