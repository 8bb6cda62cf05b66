/**
 * Counts what ranks send to cut the grid (MakePartition), to find the blocks and cells of other
 * ranks near their own (FindPlaces, FindOwners), and to find their peers (Partition): the largest
 * figures of any rank. Ranks are threads.
 *
 * The grid has 20^3 cells per rank. Each rank holds the blocks of a slab across z, as readers of
 * images give them; cells near a sphere weigh more.
 *
 * usage: RankSetup [numbers of ranks, default 8 27 64 216]
 */
#include "Input/BlockChecks.h"
#include "Input/InputRoute.h"
#include "Input/MakePartition.h"

#include "Base/Partition.h"
#include "ThreadRanks.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index CellsPerRank = 20; // along each axis
const char* const Steps[] = { "partition", "blocks", "owners", "peers" };

/// What a rank did in a step.
struct Cost
{
  double Seconds = 0.0; ///< of the processor
  ThreadRanks::Traffic Sent;
};

double SecondsOfThread()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns the cost of a piece of work.
template <class Work>
Cost CostOf(const ThreadRanks& ranks, const Work& work)
{
  const ThreadRanks::Traffic before = ranks.Sent();
  const double start = SecondsOfThread();
  work();
  Cost cost{ SecondsOfThread() - start, ranks.Sent() };
  cost.Sent.Messages -= before.Messages;
  cost.Sent.MessageBytes -= before.MessageBytes;
  cost.Sent.Reductions -= before.Reductions;
  cost.Sent.ReducedBytes -= before.ReducedBytes;
  cost.Sent.GatheredBytes -= before.GatheredBytes;
  return cost;
}

/// Returns the block of a rank: a slab of the grid.
InputLevels MakeInput(const IndexBox& global, int rank, int count)
{
  InputLevels input;
  input.Levels.resize(1);
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= global.Upper[a]; ++i)
    {
      input.Levels[0].Coordinates[a].push_back(static_cast<double>(i));
    }
  }
  InputBlock block;
  block.Box = global;
  block.Box.Lower[2] = global.Upper[2] * rank / count;
  block.Box.Upper[2] = global.Upper[2] * (rank + 1) / count;
  block.Number = 0;
  if (block.Box.NumberOfCells() > 0)
  {
    input.Levels[0].Blocks.push_back(block);
  }
  return input;
}

/// Returns the cells of blocks that are near a sphere.
std::vector<Index3> ListCells(const InputBlocks& input)
{
  const IndexBox global = input.Global();
  const double radius = 0.4 * static_cast<double>(global.Upper[0]);
  std::vector<Index3> cells;
  for (const InputBlock& block : input.Blocks)
  {
    ForCells(block.Box,
      [&](const Index3& cell)
      {
        double square = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          const double x =
            static_cast<double>(cell[a]) - 0.45 * static_cast<double>(global.Upper[a]);
          square += x * x;
        }
        if (std::fabs(std::sqrt(square) - radius) < 1.0)
        {
          cells.push_back(cell);
        }
      });
  }
  return cells;
}

std::array<Cost, 4> SetUp(const IndexBox& global, ThreadRanks& ranks)
{
  InputLevels input = MakeInput(global, ranks.Rank(), ranks.Count());
  const std::vector<Index3> cells = ListCells(input.Levels[0]);
  std::array<Cost, 4> costs;
  IndexBox owned;
  costs[0] = CostOf(ranks,
    [&]
    {
      owned = MakePartition(
        global, input.Levels[0].Boxes(), [&] { return cells; }, ranks, false);
    });
  costs[1] = CostOf(ranks, [&] { FindPlaces(input.Levels, ranks); });
  costs[2] = CostOf(ranks, [&] { FindOwners(owned, {}, ranks, input); });
  const CartesianGrid grid(input.Levels[0].Coordinates, owned, GhostLayers);
  costs[3] = CostOf(ranks, [&] { Partition(grid, ranks); });
  return costs;
}

void Print(int count)
{
  const Index along = std::lround(std::cbrt(count) * CellsPerRank);
  const IndexBox global{ {}, { { along, along, along } } };
  std::vector<std::array<Cost, 4>> costs(count);
  RunOnRanks(count, [&](ThreadRanks& ranks) { costs[ranks.Rank()] = SetUp(global, ranks); });
  for (int step = 0; step < 4; ++step)
  {
    Cost most;
    for (const std::array<Cost, 4>& cost : costs)
    {
      const ThreadRanks::Traffic& sent = cost[step].Sent;
      most.Seconds = std::max(most.Seconds, cost[step].Seconds);
      most.Sent.Messages = std::max(most.Sent.Messages, sent.Messages);
      most.Sent.MessageBytes = std::max(most.Sent.MessageBytes, sent.MessageBytes);
      most.Sent.ReducedBytes = std::max(most.Sent.ReducedBytes, sent.ReducedBytes);
      most.Sent.GatheredBytes = std::max(most.Sent.GatheredBytes, sent.GatheredBytes);
    }
    const auto kilo = [](std::int64_t bytes) { return 1e-3 * static_cast<double>(bytes); };
    std::printf("| %d | %s | %lld | %.1f | %.1f | %.1f | %.2f |\n", count, Steps[step],
      static_cast<long long>(most.Sent.Messages), kilo(most.Sent.MessageBytes),
      kilo(most.Sent.ReducedBytes), kilo(most.Sent.GatheredBytes), 1e3 * most.Seconds);
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::printf("| ranks | step | messages | kB sent | kB reduced | kB gathered | ms |\n"
              "|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i)
  {
    Print(std::atoi(argv[i]));
  }
  if (argc == 1)
  {
    for (int count : { 8, 27, 64, 216 })
    {
      Print(count);
    }
  }
  return 0;
}
