/// Ranks that exchange contents of blocks, against lists of all blocks and all ranks.
#include "Input/InputRoute.h"
#include "BlockPieces.h"
#include "Input/InputLevels.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns one box of cells per rank, which fill the grid; some have no cells.
std::vector<BlockPlace> DealCells(const IndexBox& global, int count, unsigned seed)
{
  RandomDraw draw(seed);
  std::vector<IndexBox> boxes;
  CutRandomly(global, count - count / 5, draw, boxes);
  boxes.resize(count);
  std::vector<BlockPlace> owners;
  for (const IndexBox& box : boxes)
  {
    owners.push_back({ box, static_cast<int>(owners.size()), -1 });
  }
  return owners;
}

} // namespace

TEST(InputRoute, PeersAsFromListsOfAll)
{
  for (int count : { 1, 2, 3, 5, 8, 27 })
  {
    for (unsigned seed = 0; seed < 4; ++seed)
    {
      const DealtBlocks dealt = DealBlocks(count, 1 + seed % 3, seed + count);
      const std::vector<BlockPlace> owners = DealCells(dealt.Global, count, seed);
      const InputLevels all = MakeLevels(dealt, -1);
      RunOnRanks(count,
        [&](ThreadRanks& ranks)
        {
          const int rank = ranks.Rank();
          InputLevels near = MakeLevels(dealt, rank), whole = near;
          const std::vector<BlockPlace> nearOwners =
            FindOwners(owners[rank].Box, { { seed > 1, false, seed > 2 } }, ranks, near);
          EXPECT_EQ(ranks.Sent().GatheredBytes, 0);
          EXPECT_TRUE(BoxOfRank(nearOwners, rank) == owners[rank].Box);
          for (int level = 0; level < dealt.Levels; ++level)
          {
            whole.Levels[level].Places = all.Levels[level].Places;
            for (Index layers : { 0, GhostLayers })
            {
              const InputRoute expected =
                FindInputRoute(ChangeLevel(owners, level), whole.Levels[level], rank, layers);
              const InputRoute found =
                FindInputRoute(ChangeLevel(nearOwners, level), near.Levels[level], rank, layers);
              EXPECT_EQ(found.Peers, expected.Peers);
              EXPECT_TRUE(found.Requested == expected.Requested);
            }
          }
        });
    }
  }
}

TEST(InputRoute, CoverOfGhostCellsAcrossSides)
{
  // Finer blocks at the upper side of a domain that repeats along x: a rank at the lower side must
  // see them in its ghost cells.
  const int count = 8;
  DealtBlocks dealt;
  dealt.Global.Upper = { { 40, 6, 6 } };
  dealt.Levels = 2;
  dealt.OfRank.resize(count);
  std::vector<BlockPlace> owners;
  for (int rank = 0; rank < count; ++rank)
  {
    const IndexBox box{ { { 5 * rank, 0, 0 } }, { { 5 * rank + 5, 6, 6 } } };
    owners.push_back({ box, rank, -1 });
    dealt.OfRank[rank].push_back({ box, 0 });
  }
  dealt.OfRank[3].push_back({ { { { 76, 2, 2 } }, { { 80, 4, 4 } } }, 1 });
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      InputLevels input = MakeLevels(dealt, ranks.Rank());
      const IndexBox owned = owners[ranks.Rank()].Box;
      FindOwners(owned, { { true, false, false } }, ranks, input);
      const CartesianGrid grid = CartesianGrid::Covering(input.Levels[1].Coordinates,
        ChangeLevel(owned, 1), { { true, false, false } }, Seam::Free, GhostLayers);
      const LevelCover cover(input, 1, grid);
      ForCells(grid.Local(),
        [&](const Index3& cell)
        {
          const Index3 at = grid.Canonical(cell);
          const Index x = at[0] - grid.Domain().Lower[0];
          EXPECT_EQ(cover.Has(cell), x >= 76 && at[1] >= 2 && at[1] < 4 && at[2] >= 2 && at[2] < 4)
            << x;
        });
    });
}
