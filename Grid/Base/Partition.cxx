#include "Base/Partition.h"

namespace vfm
{

Partition::Partition(const CartesianGrid& grid, Ranks& ranks) : Grid(grid), TheRanks(ranks)
{
  struct Boxes
  {
    IndexBox Owned, Local;
  };
  const std::vector<Boxes> all =
    GatherItems(ranks, std::vector<Boxes>{ { grid.Owned(), grid.Local() } });
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    const IndexBox outgoing = Intersect(grid.Owned(), all[rank].Local);
    const IndexBox incoming = Intersect(grid.Local(), all[rank].Owned);
    if (rank != ranks.Rank() && outgoing.NumberOfCells() + incoming.NumberOfCells() > 0)
    {
      this->ThePeers.push_back(rank);
      this->Owned.push_back(all[rank].Owned);
      this->Outgoing.push_back(outgoing);
      this->Incoming.push_back(incoming);
    }
  }
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

} // namespace vfm
