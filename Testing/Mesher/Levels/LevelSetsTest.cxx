/// Fractions of level sets in blocks of any ranks.
#include "Levels/LevelSets.h"

#include "Input/InputArrays.h"
#include "LevelSetBalls.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace vfm;
using namespace vfm::testing;

namespace
{

double ValueAt(const InputBlock& block, const std::string& name, const Index3& cell)
{
  return FindTuples(block, name)->Get(block.CellId(cell), 0);
}

/// Returns the fractions of one block of all cells.
InputBlocks OneBlock(double scale = 1.0, bool isPositive = false)
{
  Ranks alone;
  RankRuntime runtime(alone);
  return FractionsOfLevelSets(MakeInput({ All }, alone, scale).Levels,
    { { "ball", "film" }, LevelSetRule::Priority, isPositive }, runtime)[0];
}

} // namespace

TEST(LevelSets, VolumesOfWrappedBalls)
{
  const InputBlocks whole = OneBlock();
  double ball = 0.0, film = 0.0;
  ForCells(All,
    [&](const Index3& cell)
    {
      ball += ValueAt(whole.Blocks[0], "ball", cell);
      film += ValueAt(whole.Blocks[0], "film", cell);
    });
  const double unit =
    4.0 / 3.0 * 3.14159265358979323846 / (WidthOfBalls * WidthOfBalls * WidthOfBalls);
  EXPECT_NEAR(ball, unit * 0.216, 1e-4 * ball);
  EXPECT_NEAR(film, unit * (0.250047 - 0.216), 1e-3 * film); // 0.3 cells thick
}

TEST(LevelSets, OtherSign)
{
  const InputBlocks negative = OneBlock(), positive = OneBlock(-1.0, true);
  ForCells(All,
    [&](const Index3& cell)
    {
      EXPECT_EQ(
        ValueAt(negative.Blocks[0], "film", cell), ValueAt(positive.Blocks[0], "film", cell));
    });
}

TEST(LevelSets, SameBitsInBlocksOfAnyRanks)
{
  const InputBlocks whole = OneBlock();
  for (const int count : { 1, 2, 5 })
  {
    RandomDraw draw(17 + count);
    std::vector<IndexBox> pieces;
    CutRandomly(All, 4 * count, draw, pieces);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        std::vector<IndexBox> own;
        for (std::size_t p = 0; p < pieces.size(); ++p)
        {
          if (static_cast<int>(p) % count == ranks.Rank())
          {
            own.push_back(pieces[p]);
          }
        }
        RankRuntime runtime(ranks);
        const InputBlocks found = FractionsOfLevelSets(MakeInput(own, ranks).Levels,
          { { "ball", "film" }, LevelSetRule::Priority, false }, runtime)[0];
        ASSERT_EQ(found.Blocks.size(), own.size());
        for (const InputBlock& block : found.Blocks)
        {
          ForCells(block.Box,
            [&](const Index3& cell)
            {
              for (const char* name : { "ball", "film" })
              {
                EXPECT_EQ(ValueAt(block, name, cell), ValueAt(whole.Blocks[0], name, cell));
              }
            });
        }
      });
  }
}

TEST(LevelSets, NothingInsideIsAnError)
{
  Ranks alone;
  RankRuntime runtime(alone);
  InputLevels input = MakeInput({ All }, alone);
  const auto far = std::make_shared<PlainArrays>(All.NumberOfCells());
  far->Store("far", ValueType::Double, std::vector<double>(All.NumberOfCells(), 2.5));
  input.Levels[0].Blocks[0].Arrays = far;
  const LevelSetSource source{ { "far" }, LevelSetRule::Priority, false };
  const std::string told = ErrorOf([&] { FractionsOfLevelSets(input.Levels, source, runtime); });
  EXPECT_NE(told.find("'far' is negative"), std::string::npos) << told;
  EXPECT_NE(told.find("LevelSetInside Positive"), std::string::npos) << told;
  EXPECT_NE(
    ErrorOf(
      [&] {
        FractionsOfLevelSets(input.Levels, { { "ball" }, LevelSetRule::Lowest, false }, runtime);
      })
      .find("ball"),
    std::string::npos);
}

/// Infinite values belong to narrow bands; NaN stays, so that the mesher names the cell.
TEST(LevelSets, ValuesThatAreNotFinite)
{
  Ranks alone;
  RankRuntime runtime(alone);
  InputLevels input = MakeInput({ All }, alone);
  Buffer<double> band(All.NumberOfCells());
  const Index3 bad{ { 2, 1, 0 } };
  ForCells(All,
    [&](const Index3& cell)
    {
      const double value = Distance(cell, 0.6);
      band[IndexInBox(All, cell)] = std::abs(value) < 3.0 * WidthOfBalls
        ? value
        : std::copysign(std::numeric_limits<double>::infinity(), value);
    });
  band[IndexInBox(All, bad)] = std::numeric_limits<double>::quiet_NaN();
  const auto arrays = std::make_shared<PlainArrays>(All.NumberOfCells());
  arrays->Store("ball", ValueType::Double, std::move(band));
  input.Levels[0].Blocks[0].Arrays = arrays;
  const InputBlocks found =
    FractionsOfLevelSets(input.Levels, { { "ball" }, LevelSetRule::Priority, false }, runtime)[0];
  const InputBlocks whole = OneBlock();
  ForCells(All,
    [&](const Index3& cell)
    {
      const double value = ValueAt(found.Blocks[0], "ball", cell);
      EXPECT_EQ(std::isnan(value), cell == bad);
      const double expected = ValueAt(whole.Blocks[0], "ball", cell);
      EXPECT_NEAR(std::isnan(value) ? expected : value, expected, 5e-3);
    });
}
