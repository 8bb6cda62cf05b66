/**
 * Partition: which rank owns which box of the grid, and the exchange of cell values with the ranks around.
 *
 * The rank that owns the lowest-index cell at a node owns the node. A rank whose box is empty owns nothing.
 */
#pragma once

#include "CartesianGrid.h"
#include "Ranks.h"

namespace vfm
{

class Partition
{
public:
  /// Collective: gathers the owned boxes (48 bytes a rank, the only thing here that grows with the ranks).
  Partition(const CartesianGrid& grid, Ranks& ranks);

  Ranks& Group() const { return this->TheRanks; }
  /// Ranks whose owned cells this one holds as ghosts, or the other way round; ascending.
  const std::vector<int>& Peers() const { return this->ThePeers; }
  bool OwnsCell(const Index3& cell) const { return this->Grid.Owned().Contains(cell); }
  bool OwnsNode(const Index3& node) const { return this->OwnsCell(LowestCell(node)); }
  /// Position in Peers() of the owner of a cell or node of the local box that this rank does not own.
  int PeerOfCell(const Index3& cell) const;
  int PeerOfNode(const Index3& node) const { return this->PeerOfCell(LowestCell(node)); }

  /// Sends each peer what pack(box) makes of my cells that it holds as ghosts; unpack(box, bytes) gets what came for mine.
  template <class Pack, class Unpack>
  void ExchangeBoxes(const Pack& pack, const Unpack& unpack) const;

  /// Calls body(cell) for the cells of a box, x fastest.
  template <class Body>
  void ForCells(const IndexBox& box, const Body& body) const;

  /// Fills the ghost cells of an array of the grid's shape with the values of their owners.
  /// changed(cell) is called for every ghost cell whose value was another.
  template <class Array, class Changed>
  void ExchangeCells(Array& values, const Changed& changed) const;

  /// Tells each peer which ids this rank wants of it; returns those that each wants of this rank. Collective among peers.
  std::vector<std::vector<Index>> Request(const std::vector<std::vector<Index>>& wanted) const;

private:
  /// The cell that decides who owns a node: the lowest in the domain.
  static Index3 LowestCell(const Index3& node)
  {
    return { { std::max<Index>(node[0] - 1, 0), std::max<Index>(node[1] - 1, 0),
      std::max<Index>(node[2] - 1, 0) } };
  }

  const CartesianGrid& Grid;
  Ranks& TheRanks;
  std::vector<int> ThePeers;
  std::vector<IndexBox> Owned;    // of each peer
  std::vector<IndexBox> Outgoing; // my cells that each peer holds as ghosts
  std::vector<IndexBox> Incoming; // its cells that I hold
};

template <class Body>
void Partition::ForCells(const IndexBox& box, const Body& body) const
{
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
    {
      const Index first = this->Grid.Linear({ { box.Lower[0], j, k } });
      for (Index cell = first; cell < first + box.Size(0); ++cell)
      {
        body(cell);
      }
    }
  }
}

template <class Pack, class Unpack>
void Partition::ExchangeBoxes(const Pack& pack, const Unpack& unpack) const
{
  std::vector<Bytes> outgoing;
  for (const IndexBox& box : this->Outgoing)
  {
    outgoing.push_back(pack(box));
  }
  const std::vector<Bytes> incoming = this->TheRanks.Exchange(this->ThePeers, outgoing);
  for (std::size_t p = 0; p < incoming.size(); ++p)
  {
    unpack(this->Incoming[p], incoming[p]);
  }
}

template <class Array, class Changed>
void Partition::ExchangeCells(Array& values, const Changed& changed) const
{
  using Value = typename Array::value_type;
  this->ExchangeBoxes(
    [&](const IndexBox& box)
    {
      std::vector<Value> items;
      this->ForCells(box, [&](Index cell) { items.push_back(values[cell]); });
      return ToBytes(items);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      const std::vector<Value> items = FromBytes<Value>(bytes);
      std::size_t at = 0;
      this->ForCells(box,
        [&](Index cell)
        {
          if (values[cell] != items[at])
          {
            values[cell] = items[at];
            changed(cell);
          }
          ++at;
        });
    });
}

} // namespace vfm
