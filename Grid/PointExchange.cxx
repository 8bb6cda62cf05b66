#include "PointExchange.h"

#include <numeric>

namespace vfm
{

PointExchange::PointExchange(const ActiveMesh& active, const Mesh& mesh, const CartesianGrid& grid,
  const Partition& partition) :
  Group(partition.Group())
{
  const std::size_t peers = partition.Peers().size();
  const int count = static_cast<int>(active.X.size());
  const auto idOf = [&](int point) { return mesh.PointIds[active.MeshPoint[point]]; };
  std::vector<std::array<Link, 8>> links(peers);
  std::vector<std::vector<Index>> wanted(peers);
  for (int point = 0; point < count; ++point)
  {
    const Index3 node = NodeOfPoint(grid, mesh, idOf(point));
    if (active.IsActive[point] && !partition.OwnsNode(node))
    {
      const int peer = partition.PeerOfNode(node);
      wanted[peer].push_back(idOf(point));
      links[peer][CartesianGrid::Colour(node)].Incoming.push_back(point);
    }
  }
  const std::vector<std::vector<Index>> requests = partition.Request(wanted);
  std::vector<int> points(count);
  std::iota(points.begin(), points.end(), 0);
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (Index id : requests[peer])
    {
      const int point = *std::lower_bound(
        points.begin(), points.end(), id, [&](int p, Index key) { return idOf(p) < key; });
      links[peer][CartesianGrid::Colour(NodeOfPoint(grid, mesh, id))].Outgoing.push_back(point);
    }
  }
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (int colour = 0; colour < 8; ++colour)
    {
      Link& link = links[peer][colour];
      if (!link.Outgoing.empty() || !link.Incoming.empty())
      {
        this->Peers[colour].push_back(partition.Peers()[peer]);
        this->Links[colour].push_back(std::move(link));
      }
    }
  }
}

void PointExchange::Send(int colour, ActiveMesh& active, const std::vector<unsigned char>& flags,
  const std::function<void(int)>& received) const
{
  std::vector<Bytes> messages;
  for (const Link& link : this->Links[colour])
  {
    std::vector<Message> items;
    for (int point : link.Outgoing)
    {
      items.push_back({ active.X[point], flags[point] ? 1.0 : 0.0 });
    }
    messages.push_back(ToBytes(items));
  }
  messages = this->Group.Exchange(this->Peers[colour], messages);
  for (std::size_t peer = 0; peer < messages.size(); ++peer)
  {
    const std::vector<Message> items = FromBytes<Message>(messages[peer]);
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const int point = this->Links[colour][peer].Incoming[i];
      active.X[point] = items[i].X;
      if (items[i].Flag > 0.0)
      {
        received(point);
      }
    }
  }
}

} // namespace vfm
