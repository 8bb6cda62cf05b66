#include "PointExchange.h"

namespace vfm
{

PointExchange::PointExchange(const ActiveMesh& active, const HexMesh& mesh,
  const CartesianGrid& grid, const Partition& partition) :
  Parts(partition)
{
  const std::size_t peers = partition.Peers().size();
  const int count = static_cast<int>(active.X.size());
  const auto idOf = [&](int point) { return mesh.PointIds[active.MeshPoint[point]]; };
  for (int colour = 0; colour < 8; ++colour)
  {
    this->Outgoing[colour].resize(peers);
    this->Incoming[colour].resize(peers);
  }
  std::vector<std::vector<Index>> wanted(peers);
  for (int point = 0; point < count; ++point)
  {
    const Index3 node = NodeOfPoint(grid, idOf(point));
    if (active.IsActive[point] && !partition.OwnsNode(node))
    {
      const int peer = partition.PeerOfNode(node);
      wanted[peer].push_back(idOf(point));
      this->Incoming[CartesianGrid::Colour(node)][peer].push_back(point);
    }
  }
  std::vector<Bytes> requests;
  for (const std::vector<Index>& ids : wanted)
  {
    requests.push_back(ToBytes(ids));
  }
  requests = partition.Group().Exchange(partition.Peers(), requests);
  std::vector<int> points(count);
  for (int point = 0; point < count; ++point)
  {
    points[point] = point;
  }
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (Index id : FromBytes<Index>(requests[peer]))
    {
      const int point = *std::lower_bound(
        points.begin(), points.end(), id, [&](int p, Index key) { return idOf(p) < key; });
      this->Outgoing[CartesianGrid::Colour(NodeOfPoint(grid, id))][peer].push_back(point);
    }
  }
}

void PointExchange::Send(int colour, ActiveMesh& active, const std::vector<unsigned char>& flags,
  const std::function<void(int)>& received) const
{
  std::vector<Bytes> messages;
  for (const std::vector<int>& points : this->Outgoing[colour])
  {
    std::vector<Message> items;
    for (int point : points)
    {
      items.push_back({ active.X[point], flags[point] ? 1.0 : 0.0 });
    }
    messages.push_back(ToBytes(items));
  }
  messages = this->Parts.Group().Exchange(this->Parts.Peers(), messages);
  for (std::size_t peer = 0; peer < messages.size(); ++peer)
  {
    const std::vector<Message> items = FromBytes<Message>(messages[peer]);
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const int point = this->Incoming[colour][peer][i];
      active.X[point] = items[i].X;
      if (items[i].Flag > 0.0)
      {
        received(point);
      }
    }
  }
}

} // namespace vfm
