#include "Volumes/MatchFragments.h"

#include <tuple>

namespace vfm
{
namespace
{

constexpr int LargestRounds = 8;

/// A neighbour of a fragment.
struct Neighbour
{
  double Ratio = 0.0;     // of the area to the smaller diagonal
  std::uint64_t Draw = 0; // decides between equal ratios
  Index Id = 0;           // over all ranks; 0: none
};

void TakeBetter(Neighbour& a, const Neighbour& b)
{
  if (std::tie(a.Ratio, a.Draw, a.Id) < std::tie(b.Ratio, b.Draw, b.Id))
  {
    a = b;
  }
}

std::uint64_t DrawOf(Index a, Index b)
{
  std::uint64_t hash = static_cast<std::uint64_t>(a) << 32 ^ static_cast<std::uint64_t>(b);
  for (int round = 0; round < 3; ++round)
  {
    hash = (hash ^ hash >> 29) * 0x9e3779b97f4a7c15u;
  }
  return hash;
}

/// Each fragment chooses its best free neighbour; two that choose each other are mates.
class Matching
{
public:
  Matching(const IslandLevel& level, const IslandValues& values) :
    Share(level.Share), Pairs(level.Pairs.Pairs()), Mates(level.Share.Size(), 0)
  {
    for (std::size_t p = 0; p < this->Pairs.size(); ++p)
    {
      const auto& [a, b] = this->Pairs[p];
      const double smaller = std::min(values.Diagonal[a], values.Diagonal[b]);
      this->Couplings.push_back({ a > 0 ? values.Areas[p] / smaller : 0.0,
        DrawOf(this->Share.Ids[a], this->Share.Ids[b]) });
    }
  }

  void FindMates()
  {
    bool isNew = true;
    for (int round = 0; round < LargestRounds && isNew; ++round)
    {
      isNew = this->Share.Group->Any(this->Match(this->Choose()));
      this->Share.Merge(this->Mates, 1, [](Index& a, Index b) { a = std::max(a, b); });
    }
  }

  std::vector<Index> Groups() const
  {
    std::vector<Neighbour> best(this->Share.Size());
    for (std::size_t p = 0; p < this->Pairs.size(); ++p)
    {
      const auto& [a, b] = this->Pairs[p];
      if (this->IsFree(a) != this->IsFree(b) && this->Couplings[p].Ratio > 0.0)
      {
        const int free = this->IsFree(a) ? a : b, other = this->IsFree(a) ? b : a;
        Neighbour neighbour = this->Couplings[p];
        neighbour.Id = this->PairOf(other);
        TakeBetter(best[free], neighbour);
      }
    }
    this->Share.Merge(best, 1, TakeBetter);
    std::vector<Index> groups(this->Share.Size(), 0);
    for (std::size_t f = 1; f < groups.size(); ++f)
    {
      const bool joins = this->IsFree(f) && best[f].Id > 0;
      groups[f] = joins ? best[f].Id : this->PairOf(f);
    }
    return groups;
  }

private:
  bool IsFree(std::size_t f) const { return this->Mates[f] == 0; }
  Index PairOf(std::size_t f) const
  {
    const Index own = this->Share.Ids[f];
    return this->IsFree(f) ? own : std::min(own, this->Mates[f]);
  }

  std::vector<Neighbour> Choose() const
  {
    std::vector<Neighbour> best(this->Share.Size());
    for (std::size_t p = 0; p < this->Pairs.size(); ++p)
    {
      const auto& [a, b] = this->Pairs[p];
      if (this->Couplings[p].Ratio > 0.0 && this->IsFree(a) && this->IsFree(b))
      {
        Neighbour neighbour = this->Couplings[p];
        neighbour.Id = this->Share.Ids[b];
        TakeBetter(best[a], neighbour);
        neighbour.Id = this->Share.Ids[a];
        TakeBetter(best[b], neighbour);
      }
    }
    this->Share.Merge(best, 1, TakeBetter);
    return best;
  }

  bool Match(const std::vector<Neighbour>& best)
  {
    bool isNew = false;
    for (const auto& [a, b] : this->Pairs)
    {
      const Index first = this->Share.Ids[a], second = this->Share.Ids[b];
      if (a > 0 && best[a].Id == second && best[b].Id == first)
      {
        isNew = true;
        this->Mates[a] = second;
        this->Mates[b] = first;
      }
    }
    return isNew;
  }

  const FragmentShare& Share;
  const std::vector<FragmentPair>& Pairs;
  std::vector<Neighbour> Couplings; // by pair, without a number
  std::vector<Index> Mates;         // by number over all ranks; 0: none yet
};

} // namespace

std::vector<Index> MatchFragments(const IslandLevel& level, const IslandValues& values)
{
  Matching matching(level, values);
  matching.FindMates();
  return matching.Groups();
}

} // namespace vfm
