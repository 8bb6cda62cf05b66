#include "Elements/PointExchange.h"

#include <numeric>

namespace vfm
{
namespace
{

/// Index of the movers by id.
class MoversById
{
public:
  explicit MoversById(const std::vector<Mover>& movers) : Movers(movers), Order(movers.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    const auto isLess = [&](int a, int b) { return movers[a].Id < movers[b].Id; };
    if (!std::is_sorted(this->Order.begin(), this->Order.end(), isLess)) // mostly they are
    {
      std::sort(this->Order.begin(), this->Order.end(), isLess);
    }
  }
  int Find(Index id) const
  {
    return *std::lower_bound(this->Order.begin(), this->Order.end(), id,
      [this](int mover, Index key) { return this->Movers[mover].Id < key; });
  }

private:
  const std::vector<Mover>& Movers;
  std::vector<int> Order;
};

} // namespace

PointExchange::PointExchange(const std::vector<Mover>& movers, const Partition& partition,
  int colours, const MoverCopies& copies) :
  Parts(&partition)
{
  const std::size_t peers = partition.Peers().size();
  if (peers == 0)
  {
    return;
  }
  std::vector<std::vector<Link>> links(peers, std::vector<Link>(colours));
  std::vector<std::vector<Index>> requested(peers);
  for (std::size_t m = 0; m < movers.size(); ++m)
  {
    if (!partition.OwnsNode(movers[m].Owner))
    {
      const int peer = partition.PeerOfNode(movers[m].Owner);
      requested[peer].push_back(copies.IdBelow(movers[m].Id, partition.ShiftOf(peer)));
      links[peer][movers[m].Colour].Incoming.push_back(static_cast<int>(m));
    }
  }
  const MoversById byId(movers);
  const std::vector<std::vector<Index>> requests = partition.Exchange(requested);
  this->Peers.resize(colours);
  this->Links.resize(colours);
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (Index id : requests[peer])
    {
      const int mover = byId.Find(id);
      links[peer][movers[mover].Colour].Outgoing.push_back(mover);
    }
    for (int colour = 0; colour < colours; ++colour)
    {
      Link& link = links[peer][colour];
      if (!link.Outgoing.empty() || !link.Incoming.empty())
      {
        link.NeedsFlag.assign(link.Incoming.size(), 1);
        link.Translation = Divided(partition.TranslationOf(peer), copies.Unit);
        this->Peers[colour].push_back(peer);
        this->Links[colour].push_back(std::move(link));
      }
    }
  }
}

void PointExchange::RequestFlags(const std::vector<unsigned char>& ofMovers)
{
  for (std::vector<Link>& links : this->Links)
  {
    for (Link& link : links)
    {
      std::transform(link.Incoming.begin(), link.Incoming.end(), link.NeedsFlag.begin(),
        [&](int mover) { return ofMovers[mover]; });
    }
  }
}

void PointExchange::Send(int colour, std::vector<Vector3>& points,
  const std::vector<unsigned char>& flags, const std::function<void(int)>& received) const
{
  if (this->Links.empty())
  {
    return;
  }
  const auto pack = [&](int mover) { return Message{ points[mover], flags[mover] ? 1.0 : 0.0 }; };
  const auto unpack = [&](const Link& link, std::size_t i, const Message& message)
  {
    const int mover = link.Incoming[i];
    points[mover] = message.X + link.Translation;
    if (message.Flag > 0.0 && link.NeedsFlag[i])
    {
      received(mover);
    }
  };
  this->SendColour(colour, &Link::Outgoing, pack, unpack);
}

} // namespace vfm
