/**
 * Memory and messages of a table of fragments on several ranks: drops of two hexahedra, every third
 * of which is on two ranks, and every second of which touches another one.
 *
 * usage: FragmentTables [fragments, default 100000] [ranks, default 27]
 */
#include "FragmentDrops.h"
#include "MeasureAlone.h"
#include "Report/Fragments/FragmentTable.h"
#include "ThreadRanks.h"

#include <cstdlib>
#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Figures of a table, the largest of any rank, and of all ranks together.
struct Figures
{
  ThreadRanks::Traffic Most;
  std::size_t Before = 0, Rows = 0;
  double Seconds = 0.0;
};

Figures Measure(Index fragments, int count)
{
  Figures figures;
  std::mutex mutex;
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      const Drops drops = MakeDrops(fragments, ranks.Rank(), count);
      const MeshData mesh = ViewDrops(drops);
      ranks.Any(true); // all have their elements
      if (ranks.Rank() == 0)
      {
        figures.Before = CurrentBytes();
        figures.Seconds = -Now();
      }
      const ThreadRanks::Traffic before = ranks.Sent();
      const FieldArrays table = MakeFragmentTable(mesh, {}, ranks);
      const ThreadRanks::Traffic& sent = ranks.Sent();
      ranks.Any(true);
      const std::lock_guard<std::mutex> lock(mutex);
      figures.Rows += table.empty() ? 0 : std::get<std::vector<int>>(table[0].Values).size();
      ThreadRanks::Traffic& most = figures.Most;
      most.Messages = std::max(most.Messages, sent.Messages - before.Messages);
      most.MessageBytes = std::max(most.MessageBytes, sent.MessageBytes - before.MessageBytes);
      most.ReducedBytes = std::max(most.ReducedBytes, sent.ReducedBytes - before.ReducedBytes);
      most.GatheredBytes = std::max(most.GatheredBytes, sent.GatheredBytes - before.GatheredBytes);
      if (ranks.Rank() == 0)
      {
        figures.Seconds += Now();
      }
    });
  return figures;
}

} // namespace

int main(int argc, char** argv)
{
  const Index fragments = argc > 1 ? std::atoll(argv[1]) : 100000;
  const int ranks = argc > 2 ? std::atoi(argv[2]) : 27;
  const Figures figures = Measure(fragments, ranks);
  const double megabyte = 1e-6;
  std::printf("| fragments | ranks | rows | MB of the table at the peak, all ranks | seconds "
              "| messages | MB sent | MB reduced | kB gathered |\n|---|---|---|---|---|---|---|---|"
              "---|\n| %lld | %d | %zu | %.1f | %.2f | %lld | %.2f | %.2f | %.1f |\n",
    static_cast<long long>(fragments), ranks, figures.Rows,
    megabyte * static_cast<double>(PeakBytes() - figures.Before), figures.Seconds,
    static_cast<long long>(figures.Most.Messages),
    megabyte * static_cast<double>(figures.Most.MessageBytes),
    megabyte * static_cast<double>(figures.Most.ReducedBytes),
    1e-3 * static_cast<double>(figures.Most.GatheredBytes));
  return 0;
}
