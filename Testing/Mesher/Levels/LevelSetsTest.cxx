/// Fractions of level sets in blocks of any ranks, and meshes of them.
#include "Levels/LevelSets.h"

#include "../Input/BlockPieces.h"
#include "Input/InputArrays.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "Mesher.h"
#include "RankFields.h"
#include "Report/MeshFields.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Cells = 20;
constexpr double Width = 2.0 / Cells;

double Distance(const Index3& cell, double radius)
{
  double sum = 0.0;
  for (Index i : cell)
  {
    const double x = -1.0 + Width * (static_cast<double>(i) + 0.5);
    sum += x * x;
  }
  return std::sqrt(sum) - radius;
}

/// Returns a block of cells of [-1, 1]^3 with level sets of balls that wrap each other.
/// @param scale  factor of all values
InputBlock MakeBlock(const IndexBox& box, int number, double scale)
{
  InputBlock block;
  block.Number = number;
  block.Name = NameBlock(number, 0, true);
  for (int a = 0; a < 3; ++a)
  {
    block.Coordinates[a] =
      EvenNodes(-1.0, Width, static_cast<int>(box.Lower[a]), static_cast<int>(box.Upper[a]));
  }
  KeepAllCells(block);
  const auto arrays = std::make_shared<PlainArrays>(box.NumberOfCells());
  for (const auto& [name, radius] : { std::pair("ball", 0.6), { "film", 0.63 } })
  {
    Buffer<double> values(box.NumberOfCells());
    ForCells(box,
      [&](const Index3& cell) { values[IndexInBox(box, cell)] = scale * Distance(cell, radius); });
    arrays->Store(name, ValueType::Double, std::move(values));
  }
  block.Arrays = arrays;
  return block;
}

InputLevels MakeInput(const std::vector<IndexBox>& boxes, Ranks& ranks, double scale = 1.0)
{
  CollectedBlocks collected;
  for (const IndexBox& box : boxes)
  {
    collected.Blocks.push_back(MakeBlock(box, static_cast<int>(collected.Blocks.size()), scale));
  }
  return FindInputLevels(std::move(collected), ranks);
}

const IndexBox All{ {}, { { Cells, Cells, Cells } } };

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

std::string ErrorOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
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
  const double unit = 4.0 / 3.0 * 3.14159265358979323846 / (Width * Width * Width);
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
      band[IndexInBox(All, cell)] = std::abs(value) < 3.0 * Width
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

/// The whole run: option, materials, volumes of the mesh; and the message without the option.
TEST(LevelSets, Meshes)
{
  Ranks alone;
  RankRuntime runtime(alone);
  MesherInput input;
  input.Levels = MakeInput({ All }, alone);
  input.Arrays.Fractions = { "ball", "film" };
  MesherOptions options;
  const std::string told = ErrorOf([&] { RunMesher(input, options, runtime); });
  EXPECT_NE(told.find("volume fractions lie in [0, 1]"), std::string::npos) << told;
  EXPECT_NE(told.find("LevelSets Priority (--level-set "), std::string::npos) << told;
  options.LevelSets = LevelSetRule::Priority;
  const MesherResult result = RunMesher(input, options, runtime);
  double volumes[3] = {};
  const Mesh& mesh = result.TheMesh;
  for (Index e = 0; e < static_cast<Index>(mesh.Material.size()); ++e)
  {
    ++volumes[mesh.Material[e]];
  }
  EXPECT_GT(volumes[1], 500);
  EXPECT_GT(volumes[2], 100);
  input.Arrays.Labels = "ball";
  input.Arrays.Fractions.clear();
  EXPECT_NE(ErrorOf([&] { RunMesher(input, options, runtime); }).find("LevelSets applies to"),
    std::string::npos);
}
