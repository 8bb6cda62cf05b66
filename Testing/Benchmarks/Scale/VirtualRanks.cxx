/**
 * Messages of each rank on up to thousands of ranks, of what numbers things and sums over them.
 * Ranks are threads that have no cells: of a spray or of filaments only what is at their borders.
 *
 * usage: VirtualRanks [drops|filaments, default drops] [ranks .., default 8 64 512]
 *
 * drops: each rank has 24^3 cells, with a drop of radius 1 to 1.9 cells per 6^3 cells. filaments:
 * ten of them pass through all ranks, in a random order of lowest cells. Ranks are powers of two.
 *
 * Figures are of the rank that has most: messages to others and their bytes; bytes that sums and
 * maxima reduce. `fragments` are joined and numbered once per mesh, a sum by fragment is one of
 * about fifty, `surfaces` are numbered once. For drops, the last row is a + b log2 P at 2^20 ranks,
 * by least squares of the rows of 64 ranks and more. Filaments take about log2 P rounds.
 */
#include "Labels/JoinPieces.h"
#include "Ranks/NumberKeys.h"
#include "SiteDraw.h"
#include "ThreadRanks.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index CellsOfRank = 24, Spacing = 6, SitesOfRank = CellsOfRank / Spacing;
constexpr Index HexLayers = 2; // ghost layers in which a rank has components
constexpr Index Filaments = 10;
constexpr double FitFrom = 64.0, FitAt = 0x1p20; // ranks

/// Ranks in a box; a power of two, halved along the longest axis in turn.
Index3 ArrangeRanks(int count)
{
  Index3 ranks{ { 1, 1, 1 } };
  for (int a = 2; ranks[0] * ranks[1] * ranks[2] < count; a = (a + 2) % 3)
  {
    ranks[a] *= 2;
  }
  return ranks;
}

/// Component of a rank: the fragment that it is of, and whether a lower rank has one of it too.
struct Component
{
  Index Fragment;
  bool IsLowest;
  bool operator<(const Component& other) const { return this->Fragment < other.Fragment; }
};

/// What the ranks have.
class World
{
public:
  World(const Index3& ranks, bool areDrops) : Size(ranks), AreDrops(areDrops) {}
  virtual ~World() = default;

  int Count() const { return static_cast<int>(this->Size[0] * this->Size[1] * this->Size[2]); }
  /// Returns the ranks around a rank, ascending, with itself.
  std::vector<int> ListNear(int rank) const
  {
    std::vector<int> near;
    const Index3 at = this->PlaceOf(rank);
    const IndexBox around{ { { at[0] - 1, at[1] - 1, at[2] - 1 } },
      { { at[0] + 2, at[1] + 2, at[2] + 2 } } };
    ForCells(around,
      [&](const Index3& place)
      {
        if (IndexBox{ {}, this->Size }.Contains(place))
        {
          near.push_back(this->RankAt(place));
        }
      });
    return near;
  }
  /// Returns the components of a rank, ascending.
  std::vector<Component> ListComponents(int rank) const
  {
    return this->AreDrops ? this->ListDrops(rank) : this->ListFilaments(rank);
  }
  /// Returns whether a component of one rank and one of a rank near it, of the same fragment, are
  /// in contact.
  bool AreInContact(int a, int b) const
  {
    return this->AreDrops || std::abs(this->StepOf(a) - this->StepOf(b)) == 1;
  }
  /// Returns the lowest cell of a component.
  Index LowestOf(int rank, const Component& component) const
  {
    return this->AreDrops
      ? 2 * component.Fragment + (component.IsLowest ? 0 : 1)
      : static_cast<Index>(DrawBits(component.Fragment * this->Count() + rank, 7) >> 2);
  }

private:
  Index3 PlaceOf(int rank) const
  {
    return { { rank % this->Size[0], rank / this->Size[0] % this->Size[1],
      rank / (this->Size[0] * this->Size[1]) } };
  }
  int RankAt(const Index3& place) const
  {
    return static_cast<int>((place[2] * this->Size[1] + place[1]) * this->Size[0] + place[0]);
  }
  /// Returns the place of a rank on the way of the filaments, which turn at the ends of rows.
  Index StepOf(int rank) const
  {
    const Index3 at = this->PlaceOf(rank), &n = this->Size;
    const Index y = at[2] % 2 ? n[1] - 1 - at[1] : at[1];
    const Index row = at[2] * n[1] + y;
    return row * n[0] + (row % 2 ? n[0] - 1 - at[0] : at[0]);
  }
  std::vector<Component> ListFilaments(int rank) const
  {
    std::vector<Component> components;
    for (Index f = 0; f < Filaments; ++f)
    {
      components.push_back({ f, rank == 0 });
    }
    return components;
  }
  std::vector<Component> ListDrops(int rank) const
  {
    std::vector<Component> components;
    const Index3 at = this->PlaceOf(rank), &n = this->Size;
    IndexBox sites;
    for (int a = 0; a < 3; ++a)
    {
      sites.Lower[a] = std::max<Index>(0, SitesOfRank * at[a] - 1);
      sites.Upper[a] = std::min(SitesOfRank * n[a], SitesOfRank * (at[a] + 1) + 1);
    }
    ForCells(sites,
      [&](const Index3& site)
      {
        const Index number =
          (site[2] * SitesOfRank * n[1] + site[1]) * SitesOfRank * n[0] + site[0];
        bool isHere = true, isLowest = true;
        for (int a = 0; a < 3; ++a)
        {
          const double x = static_cast<double>(Spacing) * (static_cast<double>(site[a]) + 0.5) +
            DrawNumber(number, a) - 0.5;
          const double reach = 1.0 + 0.9 * DrawNumber(number, 3) + HexLayers;
          const double lower = static_cast<double>(CellsOfRank * at[a]);
          isHere = isHere && x + reach > lower && x - reach < lower + CellsOfRank;
          isLowest = isLowest && (at[a] == 0 || x - reach >= lower);
        }
        if (isHere)
        {
          components.push_back({ number, isLowest });
        }
      });
    std::sort(components.begin(), components.end());
    return components;
  }

  Index3 Size;
  bool AreDrops;
};

/// Components of a rank as JoinPieces takes them.
struct RankPieces
{
  std::vector<Piece> Mine;
  PiecePairs Same;
  std::vector<int> Peers;
};

RankPieces ListPieces(const World& world, int rank)
{
  RankPieces pieces;
  const std::vector<Component> mine = world.ListComponents(rank);
  for (const Component& component : mine)
  {
    pieces.Mine.push_back({ world.LowestOf(rank, component), 1 });
  }
  for (int other : world.ListNear(rank))
  {
    if (other == rank)
    {
      continue;
    }
    pieces.Peers.push_back(other);
    const std::vector<Component> theirs = world.ListComponents(other);
    for (std::size_t i = 0; i < mine.size() && world.AreInContact(rank, other); ++i)
    {
      const auto found = std::lower_bound(theirs.begin(), theirs.end(), mine[i]);
      if (found != theirs.end() && found->Fragment == mine[i].Fragment)
      {
        pieces.Same.push_back({ { (static_cast<Index>(rank) << 32) + static_cast<Index>(i),
          (static_cast<Index>(other) << 32) + (found - theirs.begin()) } });
      }
    }
  }
  return pieces;
}

/// Traffic of the steps of a rank.
constexpr int Steps = 3;
using StepTraffic = std::array<ThreadRanks::Traffic, Steps>;

struct RankOutcome
{
  StepTraffic Traffic;
  Index Fragments = 0, Local = 0, Shared = 0;
  int Rounds = 0;
};

ThreadRanks::Traffic Since(const ThreadRanks::Traffic& before, const ThreadRanks& ranks)
{
  ThreadRanks::Traffic since = ranks.Sent();
  since.Messages -= before.Messages;
  since.MessageBytes -= before.MessageBytes;
  since.ReducedBytes -= before.ReducedBytes;
  since.GatheredBytes -= before.GatheredBytes;
  return since;
}

RankOutcome RunRank(const World& world, ThreadRanks& ranks)
{
  const RankPieces pieces = ListPieces(world, ranks.Rank());
  RankOutcome outcome;
  ThreadRanks::Traffic before = ranks.Sent();
  const JoinedPieces joined = JoinPieces(pieces.Mine, pieces.Same, pieces.Peers, ranks);
  outcome.Traffic[0] = Since(before, ranks);
  const FragmentShare& share = joined.Share;
  before = ranks.Sent();
  share.Sum(std::vector<ExactSum>(share.Size()));
  outcome.Traffic[1] = Since(before, ranks);
  before = ranks.Sent();
  std::vector<std::array<Index, 2>> surfaces; // between the outside and each fragment
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    surfaces.push_back({ { 0, share.Ids[f] } });
  }
  NumberKeys(
    surfaces, [](const std::array<Index, 2>& key) { return (key[0] << 32) + key[1]; }, ranks);
  outcome.Traffic[2] = Since(before, ranks);
  outcome.Fragments = share.Total;
  outcome.Local = static_cast<Index>(share.Size()) - 1;
  outcome.Shared = static_cast<Index>(share.Shared.size());
  outcome.Rounds = joined.Rounds;
  return outcome;
}

/// Figures of a row: messages, kB sent and kB reduced of each step.
using Row = std::array<double, 3 * Steps>;

Row TakeLargest(const std::vector<RankOutcome>& outcomes)
{
  Row row{};
  for (const RankOutcome& outcome : outcomes)
  {
    for (int s = 0; s < Steps; ++s)
    {
      const ThreadRanks::Traffic& t = outcome.Traffic[s];
      row[3 * s] = std::max(row[3 * s], static_cast<double>(t.Messages));
      row[3 * s + 1] = std::max(row[3 * s + 1], 1e-3 * static_cast<double>(t.MessageBytes));
      row[3 * s + 2] = std::max(row[3 * s + 2], 1e-3 * static_cast<double>(t.ReducedBytes));
    }
  }
  return row;
}

void PrintRow(const Row& row)
{
  for (int s = 0; s < Steps; ++s)
  {
    std::printf(" %.0f | %.1f | %.1f |", row[3 * s], row[3 * s + 1], row[3 * s + 2]);
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Returns a + b log2 P at a number of ranks, by least squares.
Row Fit(const std::map<int, Row>& rows, double ranks)
{
  double n = 0.0, x = 0.0, xx = 0.0;
  Row y{}, xy{}, fitted{};
  for (const auto& [count, row] : rows)
  {
    const double log = std::log2(count);
    n += 1.0;
    x += log;
    xx += log * log;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      y[i] += row[i];
      xy[i] += log * row[i];
    }
  }
  for (std::size_t i = 0; i < fitted.size(); ++i)
  {
    const double slope = (n * xy[i] - x * y[i]) / (n * xx - x * x);
    fitted[i] = (y[i] - slope * x) / n + slope * std::log2(ranks);
  }
  return fitted;
}

} // namespace

int main(int argc, char** argv)
{
  const bool areDrops = argc < 2 || std::string(argv[1]) == "drops";
  std::vector<int> counts;
  for (int a = 2; a < argc; ++a)
  {
    counts.push_back(std::atoi(argv[a]));
  }
  if (counts.empty())
  {
    counts = { 8, 64, 512 };
  }
  std::printf("| ranks | fragments | of a rank | shared | rounds | fragments: messages | kB sent | "
              "kB reduced | sum: messages | kB sent | kB reduced | surfaces: messages | kB sent | "
              "kB reduced |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::map<int, Row> rows;
  for (int count : counts)
  {
    const World world(ArrangeRanks(count), areDrops);
    std::vector<RankOutcome> outcomes(world.Count());
    RunOnRanks(
      world.Count(), [&](ThreadRanks& ranks) { outcomes[ranks.Rank()] = RunRank(world, ranks); });
    const auto larger = [](const RankOutcome& a, const RankOutcome& b)
    { return a.Local < b.Local; };
    const RankOutcome& most = *std::max_element(outcomes.begin(), outcomes.end(), larger);
    std::printf("| %d | %lld | %lld | %lld | %d |", world.Count(),
      static_cast<long long>(most.Fragments), static_cast<long long>(most.Local),
      static_cast<long long>(most.Shared), most.Rounds);
    const Row row = TakeLargest(outcomes);
    PrintRow(row);
    if (world.Count() >= FitFrom)
    {
      rows[world.Count()] = row;
    }
  }
  if (areDrops && rows.size() > 1)
  {
    std::printf("| 2^20, fitted | | | | |");
    PrintRow(Fit(rows, FitAt));
  }
  return 0;
}
