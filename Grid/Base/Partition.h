/**
 * Partition: the ownership of cells and nodes by ranks, and the exchange of their cell values.
 */
#pragma once

#include "Base/Groups.h"
#include "Base/PagedArray.h"
#include "Base/RunCoding.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Distribution of a grid over ranks. Each rank owns a box of cells. A node is owned by the rank
/// that owns the cell with the lowest indices at it. A rank with an empty box owns nothing. The
/// grid and the ranks must outlive this object.
///
/// On a periodic grid a peer is a rank and a shift, a number of periods along each axis: the cells
/// that one of both ranks owns are ghosts of the other one so many periods higher. A rank may be a
/// peer with several shifts, and its own peer.
class Partition
{
public:
  /// Finds the ranks near this one (FindMeetings.h), and stores the boxes of peers (Peers).
  /// @pre Collective over `ranks`.
  /// @note About 2 log2 P messages of a few boxes per rank, and one sum.
  Partition(const CartesianGrid& grid, Ranks& ranks);

  Ranks& Group() const { return this->TheRanks; }
  /// Returns the rank of each peer, ascending. Peers own ghost cells of this rank, or hold owned
  /// cells of this rank as ghosts.
  const std::vector<int>& Peers() const { return this->ThePeers; }
  /// Returns the shift of a peer in cells. A cell or node of the peer is so much higher here.
  Index3 ShiftOf(std::size_t peer) const { return this->Grid.CellsInPeriods(this->Shifts[peer]); }
  /// Returns the shift of a peer in length units.
  Vector3 TranslationOf(std::size_t peer) const;
  /// Returns the key that a node of a peer has here minus the key that it has there.
  Index NodeKeyShift(std::size_t peer) const { return this->Grid.NodeKey(this->ShiftOf(peer)); }
  /// Returns the key that a cell of a peer has there.
  /// @param cell  cell of the peer, as counted here
  Index CellKeyAtPeer(std::size_t peer, const Index3& cell) const
  {
    return this->Grid.CellKey(cell) - this->Grid.CellKey(this->ShiftOf(peer));
  }
  bool OwnsCell(const Index3& cell) const { return this->Grid.Owned().Contains(cell); }
  bool OwnsNode(const Index3& node) const { return this->OwnsCell(LowestCell(node)); }
  /// PeerOfCell and PeerOfNode return the position in Peers() of the owner of a cell or node.
  /// @pre This rank does not own the cell or node. The cell, or the cell that determines the owner
  ///   of the node, is in the local box.
  int PeerOfCell(const Index3& cell) const;
  int PeerOfNode(const Index3& node) const { return this->PeerOfCell(LowestCell(node)); }

  /// Sends data of owned cells to the peers that hold them as ghosts.
  /// @param pack  pack(box) returns the bytes of a box of owned cells of this rank
  /// @param unpack  unpack(box, bytes) stores the bytes of a box of ghost cells
  /// @pre Collective among peers.
  template <class Pack, class Unpack>
  void ExchangeBoxes(const Pack& pack, const Unpack& unpack) const;

  /// Calls body(cell) for the linear indices of the cells of a box, x fastest.
  template <class Body>
  void ForCells(const IndexBox& box, const Body& body) const;
  /// Calls body(first, last) for each row along x of a box, with the linear indices of its first
  /// cell and of the end; rows in order, y fastest.
  template <class Body>
  void ForRows(const IndexBox& box, const Body& body) const;

  /// Sets the ghost cells of an array to the values of their owners.
  /// @param values  array of the grid's shape
  /// @param changed  changed(cell) is called for every ghost cell whose value changes, after its
  ///   row has been set
  /// @pre Collective among peers.
  template <class T, class Changed>
  void ExchangeCells(PagedArray<T>& values, const Changed& changed) const;
  /// Sets the ghost cells of an array by linear index to the values of their owners.
  /// @pre Collective among peers.
  template <class T>
  void ExchangeCells(T* values) const;

  /// Sends messages[i] to peer peers[i] and returns the message received from each of them.
  /// @param peers  positions in Peers(), ascending, the same pairs of peers on all ranks
  /// @pre Collective among these peers.
  std::vector<Bytes> Send(
    const std::vector<std::size_t>& peers, const std::vector<Bytes>& messages) const;
  /// Sends lists[p] to peer p and returns the list received from each peer.
  /// @pre Collective among peers.
  template <class T>
  std::vector<std::vector<T>> Exchange(const std::vector<std::vector<T>>& lists) const
  {
    std::vector<std::vector<T>> received;
    for (const Bytes& message : this->SendAll(PackLists(lists)))
    {
      received.push_back(FromBytes<T>(message));
    }
    return received;
  }
  /// Sends a list of ids to each peer and returns their answers, one list per peer, in the order of
  /// the ids.
  /// @param ids  one list per peer
  /// @param answer  answer(id) is called on the peer that receives the id
  /// @pre Collective among peers.
  template <class Answer>
  auto Query(const std::vector<std::vector<Index>>& ids, const Answer& answer) const;

private:
  std::vector<Bytes> SendAll(const std::vector<Bytes>& messages) const;
  /// Returns the cell with the lowest index at a node, whose owner owns the node.
  static Index3 LowestCell(const Index3& node)
  {
    return { { std::max<Index>(node[0] - 1, 0), std::max<Index>(node[1] - 1, 0),
      std::max<Index>(node[2] - 1, 0) } };
  }

  const CartesianGrid& Grid;
  Ranks& TheRanks;
  std::vector<int> ThePeers;
  std::vector<Index3> Shifts;     // shift of each peer in periods
  std::vector<IndexBox> Owned;    // owned cells of each peer
  std::vector<IndexBox> Outgoing; // owned cells of this rank that each peer holds as ghosts
  std::vector<IndexBox> Incoming; // ghost cells of this rank that each peer owns
};

template <class Body>
void Partition::ForRows(const IndexBox& box, const Body& body) const
{
  vfm::ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = this->Grid.Linear({ { box.Lower[0], j, k } });
      body(first, first + box.Size(0));
    });
}

template <class Body>
void Partition::ForCells(const IndexBox& box, const Body& body) const
{
  this->ForRows(box,
    [&](Index first, Index last)
    {
      for (Index cell = first; cell < last; ++cell)
      {
        body(cell);
      }
    });
}

template <class Pack, class Unpack>
void Partition::ExchangeBoxes(const Pack& pack, const Unpack& unpack) const
{
  std::vector<Bytes> outgoing;
  for (const IndexBox& box : this->Outgoing)
  {
    outgoing.push_back(pack(box));
  }
  const std::vector<Bytes> incoming = this->SendAll(outgoing);
  for (std::size_t p = 0; p < incoming.size(); ++p)
  {
    unpack(this->Incoming[p], incoming[p]);
  }
}

template <class T>
void Partition::ExchangeCells(T* values) const
{
  this->ExchangeBoxes(
    [&](const IndexBox& box)
    {
      std::vector<T> own;
      this->ForRows(box,
        [&](Index first, Index last) { own.insert(own.end(), values + first, values + last); });
      return ToBytes(own);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      const std::vector<T> received = FromBytes<T>(bytes);
      auto next = received.begin();
      this->ForRows(box,
        [&](Index first, Index last)
        {
          std::copy_n(next, last - first, values + first);
          next += last - first;
        });
    });
}

template <class Answer>
auto Partition::Query(const std::vector<std::vector<Index>>& ids, const Answer& answer) const
{
  return this->Exchange(MapLists(this->Exchange(ids), answer));
}

/// Appends the indices in [first, last), a range in one row, whose value differs from `value`, to
/// the list `others`.
template <class T>
void FindOthers(
  const PagedArray<T>& values, Index first, Index last, T value, std::vector<Index>& others)
{
  values.Visit(
    first, last,
    [&](Index begin, Index end, T own)
    {
      for (Index n = begin; own != value && n < end; ++n)
      {
        others.push_back(n);
      }
    },
    [&](Index begin, Index end, const T* own)
    {
      for (Index n = begin; n < end; ++n)
      {
        if (own[n - begin] != value)
        {
          others.push_back(n);
        }
      }
    });
}

template <class T, class Changed>
void Partition::ExchangeCells(PagedArray<T>& values, const Changed& changed) const
{
  const auto pack = [&](const IndexBox& box)
  {
    RunCoder<T> coder;
    this->ForRows(box,
      [&](Index first, Index last)
      {
        values.Visit(
          first, last, [&](Index begin, Index end, T value) { coder.AddRun(value, end - begin); },
          [&](Index begin, Index end, const T* own)
          { std::for_each(own, own + (end - begin), [&](T value) { coder.Add(value); }); });
      });
    return ToBytes(coder.Coded());
  };
  std::vector<Index> others;
  const auto unpack = [&](const IndexBox& box, const Bytes& bytes)
  {
    RunReader<T> reader(FromBytes<T>(bytes));
    this->ForRows(box,
      [&](Index first, Index last)
      {
        others.clear();
        Index at = first;
        reader.Read(
          last - first,
          [&](Index count, T value)
          {
            FindOthers(values, at, at + count, value, others);
            values.Fill(at, at + count, value);
            at += count;
          },
          [&](Index count, const T* items)
          {
            for (Index c = 0; c < count; ++c)
            {
              FindOthers(values, at + c, at + c + 1, items[c], others);
            }
            values.Write(at, at + count, items);
            at += count;
          });
        std::for_each(others.begin(), others.end(), changed);
      });
  };
  this->ExchangeBoxes(pack, unpack);
}

} // namespace vfm
