#include "Input/FindNeighbours.h"

#include "Base/Runtime.h"
#include "Base/Sorted.h"
#include "Ranks/Agreement.h"

#include <map>
#include <string>

namespace vfm
{
namespace
{

constexpr int Hops = 2;                 // face neighbours, then edges, then corners
constexpr double TouchTolerance = 1e-6; // relative to the size of the box

bool IsNear(const RankBox& a, const RankBox& b, double reach)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double slack = reach + TouchTolerance * (a.Upper[axis] - a.Lower[axis]);
    if (a.Lower[axis] > b.Upper[axis] + slack || b.Lower[axis] > a.Upper[axis] + slack)
    {
      return false;
    }
  }
  return true;
}

/// Returns the distinct ranks across the faces.
std::vector<int> ListPeers(const RankBox& mine, const std::array<int, 6>& faces, int count)
{
  std::vector<int> peers;
  for (int rank : faces)
  {
    if (rank >= count || rank < -1 || rank == mine.Rank)
    {
      throw InputError("Rank " + std::to_string(mine.Rank) + " names " + std::to_string(rank) +
        " as a face neighbour; there are ranks 0 to " + std::to_string(count - 1) +
        ", and -1 for no neighbour.");
    }
    if (rank >= 0)
    {
      peers.push_back(rank);
    }
  }
  SortUnique(peers);
  return peers;
}

/// Returns a hash of 31 bits for a pair of ranks (finaliser of MurmurHash3, Appleby).
std::int64_t HashPair(std::uint64_t low, std::uint64_t high)
{
  std::uint64_t h = (low << 32) + high;
  h = (h ^ h >> 33) * 0xff51afd7ed558ccdULL;
  h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53ULL;
  return static_cast<std::int64_t>((h ^ h >> 33) & 0x7fffffff);
}

/// Checks that face neighbours name each other, by a sum in which the two sides of a pair cancel.
/// Must precede all exchanges: otherwise a rank could wait for a message that is never sent.
void CheckMutual(const RankBox& mine, const std::vector<int>& peers, Ranks& ranks)
{
  std::int64_t sum = 0;
  for (int peer : peers)
  {
    sum += mine.Rank < peer ? HashPair(mine.Rank, peer) : -HashPair(peer, mine.Rank);
  }
  if (SumOverRanks(sum, ranks) != 0)
  {
    throw InputError("Some rank names a face neighbour that does not name it: where rank i gives "
                     "j, j must give i.");
  }
}

/// Makes one hop: sends the known boxes to the peers and adds received boxes that are near.
/// Returns whether a new box was added.
bool ReceiveBoxes(const RankBox& mine, const std::vector<int>& peers, double reach, Ranks& ranks,
  std::map<int, RankBox>& known)
{
  std::vector<RankBox> told;
  for (const auto& box : known)
  {
    told.push_back(box.second);
  }
  const std::size_t before = known.size();
  for (const RankBox& box :
    ExchangeItems(ranks, peers, std::vector<std::vector<RankBox>>(peers.size(), told)))
  {
    if (IsNear(mine, box, reach))
    {
      known.emplace(box.Rank, box);
    }
  }
  return known.size() > before;
}

void CheckTouch(
  const RankBox& mine, const std::vector<int>& peers, const std::map<int, RankBox>& known)
{
  for (int peer : peers)
  {
    const auto found = known.find(peer);
    if (found == known.end() || !IsNear(mine, found->second, 0.0))
    {
      throw InputError("Rank " + std::to_string(mine.Rank) + " names " + std::to_string(peer) +
        " as a face neighbour, but their boxes do not touch.");
    }
  }
}

} // namespace

std::vector<RankBox> FindNeighbours(
  const RankBox& mine, const std::array<int, 6>& faces, Ranks& ranks, double reach)
{
  std::vector<int> peers;
  WorkTogether(ranks, [&] { peers = ListPeers(mine, faces, ranks.Count()); });
  CheckMutual(mine, peers, ranks);
  std::map<int, RankBox> known{ { mine.Rank, mine } };
  bool isNew = true;
  for (int hop = 0; hop <= Hops || ranks.Any(isNew); ++hop)
  {
    isNew = ReceiveBoxes(mine, peers, reach, ranks, known);
  }
  WorkTogether(ranks, [&] { CheckTouch(mine, peers, known); });
  known.erase(mine.Rank);
  std::vector<RankBox> neighbours;
  for (const auto& box : known)
  {
    neighbours.push_back(box.second);
  }
  return neighbours;
}

} // namespace vfm
