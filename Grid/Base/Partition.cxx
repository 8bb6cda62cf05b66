#include "Base/Partition.h"

#include "Ranks/FindMeetings.h"

#include <numeric>

namespace vfm
{
namespace
{

/// Returns the shifts, in periods, with which cells of the domain can be ghosts.
IndexBox PossibleShifts(const CartesianGrid& grid)
{
  IndexBox shifts{ { { 0, 0, 0 } }, { { 1, 1, 1 } } };
  for (int a = 0; a < 3; ++a)
  {
    if (grid.Period(a) > 0)
    {
      const Index copies = (grid.Domain().Lower[a] + grid.Period(a) - 1) / grid.Period(a);
      shifts.Lower[a] = -copies;
      shifts.Upper[a] = copies + 1;
    }
  }
  return shifts;
}

/// The boxes of a rank.
struct RankBoxes
{
  IndexBox Owned, Local;
};

std::array<bool, 3> RepeatingAxes(const CartesianGrid& grid)
{
  return { { grid.Period(0) > 0, grid.Period(1) > 0, grid.Period(2) > 0 } };
}

/// Returns whether a rank holds cells of the other one, or copies of these.
bool ArePeers(const CartesianGrid& grid, const RankBoxes& a, const RankBoxes& b)
{
  bool arePeers = false;
  ForCells(PossibleShifts(grid),
    [&](const Index3& shift)
    {
      const Index3 cells = grid.CellsInPeriods(shift);
      arePeers = arePeers || Intersect(a.Local, Moved(b.Owned, cells)).NumberOfCells() > 0 ||
        Intersect(b.Local, Moved(a.Owned, cells)).NumberOfCells() > 0;
    });
  return arePeers;
}

/// Returns the boxes of this rank and of the ranks that may be its peers, ordered by rank.
/// Collective.
std::vector<RankItem<RankBoxes>> FindRanksNear(const CartesianGrid& grid, Ranks& ranks)
{
  const RankBoxes own{ grid.Owned(), grid.Local() };
  std::vector<RankItem<RankBoxes>> near = FindMeetings(
    std::vector<RankBoxes>{ own },
    [&grid](const RankBoxes& boxes)
    { return FoldIntoDomain(boxes.Local, grid.Domain(), RepeatingAxes(grid)); },
    [&grid](const RankBoxes& a, const RankBoxes& b) { return ArePeers(grid, a, b); }, ranks);
  const auto place = std::find_if(near.begin(), near.end(),
    [&ranks](const RankItem<RankBoxes>& other) { return other.Rank > ranks.Rank(); });
  near.insert(place, { own, ranks.Rank(), 0 });
  return near;
}

/// Messages of one rank one after another, each after its length.
class MessageReader
{
public:
  explicit MessageReader(const Bytes& all) : All(all) {}
  Bytes Next()
  {
    Index length = 0;
    std::memcpy(&length, this->All.data() + this->At, sizeof(length));
    const auto begin = this->All.begin() + this->At + sizeof(length);
    this->At += sizeof(length) + length;
    return { begin, begin + length };
  }

private:
  const Bytes& All;
  Index At = 0;
};

void Append(const Bytes& message, Bytes& all)
{
  const Bytes length = ToBytes(std::vector<Index>{ static_cast<Index>(message.size()) });
  all.insert(all.end(), length.begin(), length.end());
  all.insert(all.end(), message.begin(), message.end());
}

} // namespace

Partition::Partition(const CartesianGrid& grid, Ranks& ranks) : Grid(grid), TheRanks(ranks)
{
  for (const RankItem<RankBoxes>& near : FindRanksNear(grid, ranks))
  {
    vfm::ForCells(PossibleShifts(grid),
      [&](const Index3& shift)
      {
        const Index3 cells = grid.CellsInPeriods(shift);
        const IndexBox owned = Moved(near.What.Owned, cells);
        const IndexBox incoming = Intersect(grid.Local(), owned);
        const Index3 back{ { -cells[0], -cells[1], -cells[2] } };
        const IndexBox outgoing = Intersect(grid.Owned(), Moved(near.What.Local, back));
        if ((near.Rank != ranks.Rank() || shift != Index3{}) &&
          outgoing.NumberOfCells() + incoming.NumberOfCells() > 0)
        {
          this->ThePeers.push_back(near.Rank);
          this->Shifts.push_back(shift);
          this->Owned.push_back(owned);
          this->Outgoing.push_back(outgoing);
          this->Incoming.push_back(incoming);
        }
      });
  }
}

Vector3 Partition::TranslationOf(std::size_t peer) const
{
  Vector3 translation;
  for (int a = 0; a < 3; ++a)
  {
    translation[a] = static_cast<double>(this->Shifts[peer][a]) * this->Grid.PeriodLength(a);
  }
  return translation;
}

int Partition::PeerOfCell(const Index3& cell) const
{
  int peer = 0;
  while (!this->Owned[peer].Contains(cell))
  {
    ++peer;
  }
  return peer;
}

std::vector<Bytes> Partition::SendAll(const std::vector<Bytes>& messages) const
{
  std::vector<std::size_t> peers(this->ThePeers.size());
  std::iota(peers.begin(), peers.end(), 0);
  return this->Send(peers, messages);
}

/// On a periodic grid, a rank gets one message with the messages for all its shifts. Messages of
/// this rank to itself are not sent.
std::vector<Bytes> Partition::Send(
  const std::vector<std::size_t>& peers, const std::vector<Bytes>& messages) const
{
  std::vector<int> ranks;
  if (!this->Grid.IsPeriodic())
  {
    std::transform(peers.begin(), peers.end(), std::back_inserter(ranks),
      [this](std::size_t peer) { return this->ThePeers[peer]; });
    return this->TheRanks.Exchange(ranks, messages);
  }
  std::vector<Bytes> packed;
  for (std::size_t i = 0; i < peers.size(); ++i)
  {
    const int rank = this->ThePeers[peers[i]];
    if (rank == this->TheRanks.Rank())
    {
      continue;
    }
    if (ranks.empty() || ranks.back() != rank)
    {
      ranks.push_back(rank);
      packed.emplace_back();
    }
    Append(messages[i], packed.back());
  }
  packed = ranks.empty() ? packed : this->TheRanks.Exchange(ranks, packed);
  std::vector<MessageReader> readers(packed.begin(), packed.end());
  std::vector<Bytes> received;
  for (std::size_t i = 0; i < peers.size(); ++i)
  {
    const int rank = this->ThePeers[peers[i]];
    const auto at = std::lower_bound(ranks.begin(), ranks.end(), rank);
    received.push_back(
      rank == this->TheRanks.Rank() ? messages[i] : readers[at - ranks.begin()].Next());
  }
  return received;
}

} // namespace vfm
