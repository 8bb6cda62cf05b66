/// Blocks that cannot be meshed give one message on all ranks, and the next mesh succeeds.
#include "BlockHost.h"

#include <gtest/gtest.h>

#include <functional>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// An error is on the last rank only, or on all ranks where ranks must agree.
class SculptorBlockErrors : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Good.Distribute(NestedPlaces(), Binary, Distribute::ToTheLast);
    ASSERT_EQ(sculptor_set_option(this->Bad.Sculptor, "StairStep", "1"), SCULPTOR_OK);
  }

  /// Expects an error for blocks changed by `change`.
  void Expect(int code, const std::string& words, const std::function<void(Host&)>& change)
  {
    this->Bad.Distribute(NestedPlaces(), Binary, Distribute::ToTheLast);
    change(this->Bad);
    this->Bad.HandOver();
    this->Bad.ExpectError(code, words);
    this->Bad.Blocks = this->Good.Blocks;
    this->Bad.HandOver();
    EXPECT_NE(this->Bad.Mesh(), 0u);
  }
  void ExpectOfBlock(
    int block, int code, const std::string& words, const std::function<void(LevelBlock&)>& change)
  {
    this->Expect(code, words,
      [&](Host& host)
      {
        if (!host.Blocks.empty())
        {
          change(host.Blocks[block]);
        }
      });
  }

  const bool IsLast = MyRank() == NumberOfRanks() - 1;
  Host Good, Bad;
};

} // namespace

TEST_F(SculptorBlockErrors, LevelsOutOfRange)
{
  for (int level : { -1, 31 })
  {
    this->ExpectOfBlock(3, SCULPTOR_ERROR_ARGUMENT,
      "Block 3: The level of a block is " + std::to_string(level),
      [level](LevelBlock& block) { block.Level = level; });
  }
}

TEST_F(SculptorBlockErrors, WidthsOfAnotherLevel)
{
  this->ExpectOfBlock(3, SCULPTOR_ERROR_INPUT,
    "Cells of level 1 must be 1/2 as wide as cells of level 0",
    [](LevelBlock& block) { block.Level = 1; });
}

TEST_F(SculptorBlockErrors, OffTheGrid)
{
  this->ExpectOfBlock(3, SCULPTOR_ERROR_INPUT, "does not start and end on the grid",
    [](LevelBlock& block)
    {
      block.Bounds[1] += 0.01;
      block.Bounds[4] += 0.01;
    });
}

TEST_F(SculptorBlockErrors, Overlap)
{
  this->Expect(SCULPTOR_ERROR_INPUT, "overlap at cell",
    [](Host& host)
    {
      if (!host.Blocks.empty())
      {
        host.Blocks.push_back(host.Blocks.back());
      }
    });
}

TEST_F(SculptorBlockErrors, Gap)
{
  this->Expect(SCULPTOR_ERROR_INPUT, "leave a gap",
    [](Host& host)
    {
      if (!host.Blocks.empty())
      {
        host.Distribute(LeafPlaces(), Binary, Distribute::ToTheLast);
        host.Blocks.erase(host.Blocks.begin());
        host.Blocks.emplace_back(0, IndexBox{ { { 0, 0, 0 } }, { { 2, 4, 4 } } }, Binary);
      }
    });
}

TEST_F(SculptorBlockErrors, NoBlocks)
{
  this->Expect(SCULPTOR_ERROR_ARGUMENT, "No box of cells is set on any rank",
    [](Host& host) { host.Blocks.clear(); });
}

TEST_F(SculptorBlockErrors, FieldsBeforeTheFirstBlock)
{
  const LevelBlock block(0, { { { 0, 0, 0 } }, BaseCells }, Binary);
  sculptor_add_material(this->Bad.Sculptor, "ball", block.Ball.data());
  sculptor_add_block(this->Bad.Sculptor, 0, block.Bounds.data(), block.Intervals.data());
  this->Bad.ExpectError(SCULPTOR_ERROR_ARGUMENT, "Block 0: No box of cells is set");
}

TEST_F(SculptorBlockErrors, NamesThatDiffer)
{
  const int s = this->Bad.Sculptor;
  this->Bad.Distribute(NestedPlaces(), Binary, Distribute::InTurn);
  this->Bad.HandOver();
  if (!this->Bad.Blocks.empty() && this->IsLast)
  {
    const LevelBlock& block = this->Bad.Blocks[0];
    sculptor_add_block(s, 1, block.Bounds.data(), block.Intervals.data());
    sculptor_add_material(s, "plate", block.Plate.data());
    sculptor_add_material(s, "ball", block.Ball.data());
  }
  this->Bad.ExpectError(SCULPTOR_ERROR_ARGUMENT,
    "It has materials 'plate', 'ball', no states; others have materials 'ball', 'plate', states "
    "'velocity' (3).");
}

TEST_F(SculptorBlockErrors, NamesThatDifferBetweenRanks)
{
  if (NumberOfRanks() == 1)
  {
    GTEST_SKIP() << "needs two ranks";
  }
  this->Bad.Distribute(NestedPlaces(), Binary, Distribute::InTurn);
  this->Bad.HandOver(MyRank() == 1);
  this->Bad.ExpectError(SCULPTOR_ERROR_ARGUMENT,
    "do not agree: rank 1 has material ids, states 'velocity' (3); others have materials");
}

TEST_F(SculptorBlockErrors, Neighbours)
{
  const int none[6] = { -1, -1, -1, -1, -1, -1 };
  this->Bad.Distribute(NestedPlaces(), Binary, Distribute::ToTheLast);
  this->Bad.HandOver();
  sculptor_set_neighbours(this->Bad.Sculptor, this->IsLast ? none : nullptr);
  this->Bad.ExpectError(
    SCULPTOR_ERROR_ARGUMENT, "one block of level 0 on every rank; this rank has 4 blocks");
}

TEST_F(SculptorBlockErrors, NullPointers)
{
  const int s = this->Bad.Sculptor, intervals[3] = { 1, 1, 1 };
  const double bounds[6] = { 0, 0, 0, 1, 1, 1 };
  EXPECT_EQ(sculptor_add_block(s, 0, nullptr, intervals), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_add_block(s, 0, bounds, nullptr), SCULPTOR_ERROR_ARGUMENT);
  EXPECT_EQ(sculptor_add_block(0, 0, bounds, intervals), SCULPTOR_ERROR_HANDLE);
  EXPECT_EQ(sculptor_clear_blocks(0), SCULPTOR_ERROR_HANDLE);
}
