/**
 * Random blocks of a grid with levels, dealt to ranks, without data.
 */
#pragma once

#include "Input/InputLevels.h"
#include "RandomDraw.h"

namespace vfm
{
namespace testing
{

/// The blocks of each rank, each with its level.
struct DealtBlocks
{
  struct Block
  {
    IndexBox Box; ///< in cells of the level
    int Level;
  };

  IndexBox Global; ///< level 0
  int Levels = 1;
  std::vector<std::vector<Block>> OfRank;
};

/// Cuts a box into about as many boxes as asked for, at random places.
inline void CutRandomly(
  const IndexBox& box, int count, RandomDraw& draw, std::vector<IndexBox>& boxes)
{
  const int axis = draw.Whole(0, 2);
  if (count <= 1 || box.Size(axis) < 2)
  {
    boxes.push_back(box);
    return;
  }
  IndexBox lower = box, upper = box;
  lower.Upper[axis] = upper.Lower[axis] =
    box.Lower[axis] + draw.Whole(1, static_cast<int>(box.Size(axis)) - 1);
  CutRandomly(lower, count / 2, draw, boxes);
  CutRandomly(upper, count - count / 2, draw, boxes);
}

/// Deals blocks that fill a grid, and finer blocks below some of them. Some ranks have no block.
inline DealtBlocks DealBlocks(int ranks, int levels, unsigned seed)
{
  RandomDraw draw(seed);
  DealtBlocks dealt;
  dealt.Levels = levels;
  dealt.OfRank.resize(ranks);
  for (Index& size : dealt.Global.Upper)
  {
    size = draw.Whole(4, 40);
  }
  for (int level = 0; level < levels; ++level)
  {
    std::vector<IndexBox> boxes;
    CutRandomly(ChangeLevel(dealt.Global, level), 3 * ranks, draw, boxes);
    for (const IndexBox& box : boxes)
    {
      if (level == 0 || draw.Chance(0.3))
      {
        const int rank = draw.Chance(0.3) ? 0 : draw.Whole(0, ranks - 1);
        dealt.OfRank[rank].push_back({ box, level });
      }
    }
  }
  return dealt;
}

/// Returns the levels with the blocks of one rank, or of all ranks (-1), which have no data.
inline InputLevels MakeLevels(const DealtBlocks& dealt, int rank)
{
  InputLevels input;
  input.Levels.resize(dealt.Levels);
  for (int level = 0; level < dealt.Levels; ++level)
  {
    for (int a = 0; a < 3; ++a)
    {
      for (Index i = 0; i <= dealt.Global.Upper[a] << level; ++i)
      {
        input.Levels[level].Coordinates[a].push_back(0.5 * static_cast<double>(i));
      }
    }
  }
  for (int r = 0; r < static_cast<int>(dealt.OfRank.size()); ++r)
  {
    int number = 0;
    for (const DealtBlocks::Block& dealtBlock : dealt.OfRank[r])
    {
      InputBlock block;
      block.Box = dealtBlock.Box;
      block.Number = number++;
      if (rank < 0 || rank == r)
      {
        input.Levels[dealtBlock.Level].Blocks.push_back(block);
        input.Levels[dealtBlock.Level].Places.push_back({ block.Box, r, block.Number });
      }
    }
  }
  return input;
}

/// Returns the ranks and numbers of blocks.
inline std::vector<std::array<int, 2>> NamesOf(const std::vector<BlockPlace>& places)
{
  std::vector<std::array<int, 2>> names;
  for (const BlockPlace& place : places)
  {
    names.push_back({ { place.Rank, place.Number } });
  }
  return names;
}

} // namespace testing
} // namespace vfm
