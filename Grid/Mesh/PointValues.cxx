#include "Mesh/PointValues.h"

#include "Base/Sorted.h"
#include "Mesh/PeriodicIds.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

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
  this->ToSend =
    MapLists(partition.Exchange(ids), [&mesh](Index id) { return FindSorted(mesh.PointIds, id); });
}

} // namespace vfm
