/**
 * Counts the messages of ranks that mesh a gyroid, per rank (largest of any rank): the figures of
 * Documentation/theory/parallel.md. Ranks are threads, so times are meaningless here.
 *
 * usage: RankTraffic [cells per rank and axis, default 24]: weak scaling on 1 to 64 ranks
 */
#include "MeshCases.h"
#include "RankFields.h"

#include <cstdlib>

using namespace vfm;
using namespace vfm::testing;

namespace
{

void PrintTraffic(Index cells, const Index3& ranks)
{
  const int count = static_cast<int>(ranks[0] * ranks[1] * ranks[2]);
  const CartesianGrid whole = MakeUnitGrid(cells * ranks[0], cells * ranks[1], cells * ranks[2]);
  const FractionField field =
    FractionsOfShapes(whole, { MakeGyroid(1, { { 0.1, 0.2, 0.3 } }, 16.0) });
  std::vector<ThreadRanks::Traffic> traffic(count);
  std::vector<MeshReport> reports(count);
  RunOnRanks(count,
    [&](ThreadRanks& group)
    {
      IndexBox box;
      const Index rank = group.Rank();
      const Index3 at{ { rank % ranks[0], rank / ranks[0] % ranks[1],
        rank / (ranks[0] * ranks[1]) } };
      for (int a = 0; a < 3; ++a)
      {
        box.Lower[a] = cells * at[a];
        box.Upper[a] = box.Lower[a] + cells;
      }
      const CartesianGrid grid = MakeRankGrid(whole, box);
      RankRuntime runtime(group);
      MakeHexMesh(grid, CopyToLocal(whole, field, grid), MeshOptions(), runtime, reports[rank]);
      traffic[rank] = group.Sent();
    });
  ThreadRanks::Traffic most;
  for (const ThreadRanks::Traffic& t : traffic)
  {
    most.Messages = std::max(most.Messages, t.Messages);
    most.MessageBytes = std::max(most.MessageBytes, t.MessageBytes);
    most.Reductions = std::max(most.Reductions, t.Reductions);
    most.ReducedBytes = std::max(most.ReducedBytes, t.ReducedBytes);
    most.Gathers = std::max(most.Gathers, t.Gathers);
    most.GatheredBytes = std::max(most.GatheredBytes, t.GatheredBytes);
  }
  std::printf("| %d | %lld | %.2f | %lld | %.1f | %lld | %.1f |\n", count,
    static_cast<long long>(most.Messages), 1e-6 * static_cast<double>(most.MessageBytes),
    static_cast<long long>(most.Reductions), 1e-3 * static_cast<double>(most.ReducedBytes),
    static_cast<long long>(most.Gathers), 1e-3 * static_cast<double>(most.GatheredBytes));
}

} // namespace

int main(int argc, char** argv)
{
  const Index cells = argc > 1 ? std::atoi(argv[1]) : 24;
  std::printf("| ranks | messages | MB sent | reductions | kB reduced | gathers | kB gathered |\n"
              "|---|---|---|---|---|---|---|\n");
  for (const Index3& ranks : { Index3{ { 1, 1, 1 } }, Index3{ { 2, 1, 1 } }, Index3{ { 2, 2, 1 } },
         Index3{ { 2, 2, 2 } }, Index3{ { 3, 3, 3 } }, Index3{ { 4, 4, 4 } } })
  {
    PrintTraffic(cells, ranks);
  }
  return 0;
}
