/**
 * PointExchange: sends the new positions of points to the ranks that hold them as ghosts.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Vector3.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace vfm
{

/// Point that moves, and its node. The points of one node move one after another.
struct Mover
{
  Index MeshPoint; ///< index in the mesh
  Index Id;        ///< id, equal on all ranks; points of one node move in this order
  Index Node;      ///< key of the node
  Index3 Owner;    ///< node of the partition's grid; its owner moves the point
  int Colour;      ///< colour of the node
};

/// How the ids and positions of movers change between their copies on a periodic grid.
struct MoverCopies
{
  /// idBelow(id, cells) returns the id of the copy that is `cells` lower in the partition's grid.
  std::function<Index(Index, const Index3&)> IdBelow;
  Vector3 Unit; ///< unit of positions along each axis, in length units of the grid
};

/// Exchange of movers by colour. The owner of a mover sends its position to the
/// ranks that requested it.
class PointExchange
{
public:
  /// Makes an exchange without peers.
  PointExchange() = default;
  /// Requests the movers that this rank does not own from their owners.
  /// @param movers  movers of this rank, owned or not; owners must have the
  ///   movers that others request
  /// @param colours  number of colours
  /// @pre Collective among peers.
  PointExchange(const std::vector<Mover>& movers, const Partition& partition, int colours,
    const MoverCopies& copies);

  bool HasPeers() const { return !this->Links.empty(); }
  int CountColours() const { return static_cast<int>(this->Links.size()); }
  /// Calls visit(mover) for the movers that are sent, once per receiving rank.
  template <class Visitor>
  void ForSent(const Visitor& visit) const;

  /// Selects the movers of peers whose flags Send reports. Initially all are selected.
  /// @param ofMovers  nonzero for each selected mover
  void RequestFlags(const std::vector<unsigned char>& ofMovers);

  /// Sends the positions and flags of the movers of a colour and receives the data
  /// of the peers' movers.
  /// @param[in,out] points  positions; the first entries are the movers in their order
  /// @param flags  flags in the same order
  /// @param received  received(mover) is called for each selected mover whose flag is set
  /// @pre Collective among the peers that have movers of the colour in common.
  void Send(int colour, std::vector<Vector3>& points, const std::vector<unsigned char>& flags,
    const std::function<void(int)>& received) const;
  /// Sends the value pack(mover) of every mover, colour by colour, and calls unpack(mover, value)
  /// for the values received.
  /// @pre Collective among peers.
  template <class Pack, class Unpack>
  void SendAll(const Pack& pack, const Unpack& unpack) const
  {
    this->SendPositions(
      pack, [&](int mover, const auto& value, const Vector3&) { unpack(mover, value); });
  }
  /// Does the same for values that contain positions. Calls unpack(mover, value, translation);
  /// positions received must be translated.
  template <class Pack, class Unpack>
  void SendPositions(const Pack& pack, const Unpack& unpack) const;
  /// Sends values of the movers that this rank received back to their owners: the opposite of
  /// SendAll. The value of a mover arrives once per rank that holds it as a ghost.
  /// @pre Collective among peers.
  template <class Pack, class Unpack>
  void ReturnAll(const Pack& pack, const Unpack& unpack) const;

private:
  struct Message
  {
    Vector3 X;
    double Flag;
  };
  /// Movers of one colour that this rank sends to and receives from another rank. Both ranks list
  /// them in the order of the requests.
  struct Link
  {
    std::vector<int> Outgoing, Incoming;
    std::vector<unsigned char> NeedsFlag; // whether the flag of each incoming mover is selected
    Vector3 Translation{};                // from positions of the peer to positions here
  };

  /// Sends pack(mover) of the movers of a colour and calls unpack(link, i, value) for mover i that
  /// each link receives.
  /// @param sent  Link::Outgoing or Link::Incoming
  template <class Pack, class Unpack>
  void SendColour(
    int colour, std::vector<int> Link::*sent, const Pack& pack, const Unpack& unpack) const;

  const Partition* Parts = nullptr;
  std::vector<std::vector<std::size_t>> Peers; // peers with common movers, by colour
  std::vector<std::vector<Link>> Links;        // links by colour and peer; empty without peers
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
void PointExchange::SendColour(
  int colour, std::vector<int> Link::*sent, const Pack& pack, const Unpack& unpack) const
{
  const std::vector<Link>& links = this->Links[colour];
  using Value = decltype(pack(0));
  std::vector<Bytes> messages;
  for (const Link& link : links)
  {
    std::vector<Value> values;
    std::transform((link.*sent).begin(), (link.*sent).end(), std::back_inserter(values), pack);
    messages.push_back(ToBytes(values));
  }
  messages = this->Parts->Send(this->Peers[colour], messages);
  for (std::size_t peer = 0; peer < messages.size(); ++peer)
  {
    const std::vector<Value> values = FromBytes<Value>(messages[peer]);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      unpack(links[peer], i, values[i]);
    }
  }
}

template <class Pack, class Unpack>
void PointExchange::SendPositions(const Pack& pack, const Unpack& unpack) const
{
  for (int colour = 0; colour < this->CountColours(); ++colour)
  {
    this->SendColour(colour, &Link::Outgoing, pack,
      [&unpack](const Link& link, std::size_t i, const auto& value)
      { unpack(link.Incoming[i], value, link.Translation); });
  }
}

template <class Pack, class Unpack>
void PointExchange::ReturnAll(const Pack& pack, const Unpack& unpack) const
{
  for (int colour = 0; colour < this->CountColours(); ++colour)
  {
    this->SendColour(colour, &Link::Incoming, pack,
      [&unpack](const Link& link, std::size_t i, const auto& value)
      { unpack(link.Outgoing[i], value); });
  }
}

} // namespace vfm
