/**
 * PointExchange: after a colour has moved, its new positions go to the ranks that hold the points as ghosts.
 */
#pragma once

#include "Base/Partition.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

class PointExchange
{
public:
  /// Nothing to exchange.
  explicit PointExchange(Ranks& ranks) : Group(ranks), Peers(8), Links(8) {}
  /// Collective among peers: each asks the owners for the active points that it does not own.
  PointExchange(const ActiveMesh& active, const Mesh& mesh, const CartesianGrid& grid,
    const Partition& partition);

  struct Entry
  {
    int Point;   ///< of the active mesh
    Index Id;    ///< global
    Index3 Node; ///< whose owner moves the point
    int Colour;
    bool IsWanted; ///< whether the point moves, so that ranks that do not own it ask for it
  };
  /// The same for any points; entries: by ascending id. Collective among peers.
  PointExchange(const std::vector<Entry>& entries, const Partition& partition, int colours = 8);

  /// Sends the positions of the points of a colour and receives those of the peers' points.
  /// flags: of every point; sent along with the points. received(point) is called where a flag was set.
  void Send(int colour, ActiveMesh& active, const std::vector<unsigned char>& flags,
    const std::function<void(int)>& received) const;

private:
  struct Message
  {
    Vector3 X;
    double Flag;
  };
  /// The points of one colour that go between this rank and another; both list them in the order of their ids.
  struct Link
  {
    std::vector<int> Outgoing, Incoming;
  };

  Ranks& Group;
  std::vector<std::vector<int>> Peers;  // by colour: the ranks with points in common
  std::vector<std::vector<Link>> Links; // by colour and peer
};

} // namespace vfm
