/**
 * PointExchange: after a colour has moved, its new positions go to the ranks that hold the points as ghosts.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Vector3.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace vfm
{

/// A point that moves, and the node that it moves with: the points of one node move one after another.
struct Mover
{
  Index MeshPoint; ///< its index in the mesh
  Index Id;        ///< the same on all ranks; points of one node move in this order
  Index Node;      ///< key of the node
  Index3 Owner;    ///< node of the partition's grid: who owns it moves the point
  int Colour;      ///< of the node
};

class PointExchange
{
public:
  /// Nothing to exchange.
  PointExchange() = default;
  /// Each rank asks the owners for the movers that it does not own; those know them. Collective among peers.
  PointExchange(const std::vector<Mover>& movers, const Partition& partition, int colours);

  bool HasPeers() const { return !this->Links.empty(); }
  int CountColours() const { return static_cast<int>(this->Links.size()); }
  /// Calls visit(mover) for the movers that are sent; for one that goes to several ranks as often.
  template <class Visitor>
  void ForSent(const Visitor& visit) const;

  /// Says of which of the peers' movers flags are wanted; before, of all.
  void RequestFlags(const std::vector<unsigned char>& ofMovers);

  /// Sends the positions of the movers of a colour and receives those of the peers' movers.
  /// points, flags: those of the movers come first, in their order; flags are sent along. received(mover) is called where a flag was set
  /// that is wanted.
  void Send(int colour, std::vector<Vector3>& points, const std::vector<unsigned char>& flags,
    const std::function<void(int)>& received) const;
  /// Sends what pack(mover) returns of every mover, of all colours, and calls unpack(mover, value) with what comes of the peers' movers.
  template <class Pack, class Unpack>
  void SendAll(const Pack& pack, const Unpack& unpack) const;

private:
  struct Message
  {
    Vector3 X;
    double Flag;
  };
  /// The movers of one colour that go between this rank and another; both list them in the order in which they were asked for.
  struct Link
  {
    std::vector<int> Outgoing, Incoming;
    std::vector<unsigned char> NeedsFlag; // of the incoming ones
  };

  /// Sends what pack(mover) returns of the movers of a colour; calls unpack(link, i, value) with what comes of its incoming movers.
  template <class Pack, class Unpack>
  void SendColour(int colour, const Pack& pack, const Unpack& unpack) const;

  Ranks* Group = nullptr;
  std::vector<std::vector<int>> Peers;  // by colour: the ranks with movers in common
  std::vector<std::vector<Link>> Links; // by colour and peer; none without peers
};

template <class Visitor>
void PointExchange::ForSent(const Visitor& visit) const
{
  for (const std::vector<Link>& links : this->Links)
  {
    for (const Link& link : links)
    {
      std::for_each(link.Outgoing.begin(), link.Outgoing.end(), visit);
    }
  }
}

template <class Pack, class Unpack>
void PointExchange::SendColour(int colour, const Pack& pack, const Unpack& unpack) const
{
  const std::vector<Link>& links = this->Links[colour];
  std::vector<std::vector<decltype(pack(0))>> values;
  for (const Link& link : links)
  {
    values.emplace_back();
    std::transform(
      link.Outgoing.begin(), link.Outgoing.end(), std::back_inserter(values.back()), pack);
  }
  values = ExchangeLists(*this->Group, this->Peers[colour], values);
  for (std::size_t peer = 0; peer < values.size(); ++peer)
  {
    for (std::size_t i = 0; i < values[peer].size(); ++i)
    {
      unpack(links[peer], i, values[peer][i]);
    }
  }
}

template <class Pack, class Unpack>
void PointExchange::SendAll(const Pack& pack, const Unpack& unpack) const
{
  for (int colour = 0; colour < this->CountColours(); ++colour)
  {
    this->SendColour(colour, pack,
      [&unpack](const Link& link, std::size_t i, const auto& value)
      { unpack(link.Incoming[i], value); });
  }
}

} // namespace vfm
