#include "Elements/PointValues.h"

#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Octree/RefinedGrid.h"

#include <numeric>

namespace vfm
{

namespace
{

/// Points of a mesh by id. Near other ranks and copies, corners of coarse hexes may have ids of
/// finest cells that this rank does not make; these are not in order.
class PointsById
{
public:
  explicit PointsById(const Buffer<Index>& ids) : Ids(ids)
  {
    if (!std::is_sorted(ids.begin(), ids.end()))
    {
      this->Order.resize(ids.size());
      std::iota(this->Order.begin(), this->Order.end(), 0);
      std::sort(this->Order.begin(), this->Order.end(),
        [&ids](Index a, Index b) { return ids[a] < ids[b]; });
    }
  }
  /// Returns the point with an id, or -1.
  Index Find(Index id) const
  {
    if (this->Order.empty())
    {
      return FindSorted(this->Ids, id);
    }
    const auto at = std::lower_bound(this->Order.begin(), this->Order.end(), id,
      [this](Index point, Index key) { return this->Ids[point] < key; });
    return at == this->Order.end() || this->Ids[*at] != id ? -1 : *at;
  }

private:
  const Buffer<Index>& Ids;
  std::vector<Index> Order; // points by id; empty if they are in this order
};

} // namespace

PointValues::PointValues(
  const std::vector<Index>& points, const Mesh& mesh, const Partition& partition) :
  Parts(partition), Requested(partition.Peers().size())
{
  std::vector<std::vector<Index>> ids(this->Requested.size());
  for (Index point : points)
  {
    const Index id = mesh.PointIds[point];
    const Index3 node = NodeOfPoint(mesh.Levels->Finest(), mesh, id);
    if (!partition.OwnsNode(node))
    {
      const int peer = partition.PeerOfNode(node);
      this->Requested[peer].push_back(point);
      ids[peer].push_back(IdAtPeer(mesh, partition, peer, id));
    }
  }
  const PointsById byId(mesh.PointIds);
  this->ToSend = MapLists(partition.Exchange(ids), [&byId](Index id) { return byId.Find(id); });
}

} // namespace vfm
