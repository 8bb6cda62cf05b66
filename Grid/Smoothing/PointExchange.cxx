#include "Smoothing/PointExchange.h"

namespace vfm
{
namespace
{

std::vector<PointExchange::Entry> ListPoints(
  const ActiveMesh& active, const Mesh& mesh, const CartesianGrid& grid)
{
  std::vector<PointExchange::Entry> entries;
  for (int point = 0; point < static_cast<int>(active.X.size()); ++point)
  {
    const Index id = mesh.PointIds[active.MeshPoint[point]];
    const Index3 node = NodeOfPoint(grid, mesh, id);
    entries.push_back(
      { point, id, node, CartesianGrid::Colour(node), active.IsActive[point] != 0 });
  }
  return entries;
}

} // namespace

PointExchange::PointExchange(const ActiveMesh& active, const Mesh& mesh, const CartesianGrid& grid,
  const Partition& partition) :
  PointExchange(ListPoints(active, mesh, grid), partition)
{
}

PointExchange::PointExchange(
  const std::vector<Entry>& entries, const Partition& partition, int colours) :
  Group(partition.Group()), Peers(colours), Links(colours)
{
  const std::size_t peers = partition.Peers().size();
  std::vector<std::vector<Link>> links(peers, std::vector<Link>(colours));
  std::vector<std::vector<Index>> wanted(peers);
  for (const Entry& entry : entries)
  {
    if (entry.IsWanted && !partition.OwnsNode(entry.Node))
    {
      const int peer = partition.PeerOfNode(entry.Node);
      wanted[peer].push_back(entry.Id);
      links[peer][entry.Colour].Incoming.push_back(entry.Point);
    }
  }
  const std::vector<std::vector<Index>> requests = partition.Request(wanted);
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (Index id : requests[peer])
    {
      const Entry& entry = *std::lower_bound(
        entries.begin(), entries.end(), id, [](const Entry& e, Index key) { return e.Id < key; });
      links[peer][entry.Colour].Outgoing.push_back(entry.Point);
    }
  }
  for (std::size_t peer = 0; peer < peers; ++peer)
  {
    for (int colour = 0; colour < colours; ++colour)
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
