#include "Mesh/PointValues.h"

#include "Base/Sorted.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

PointValues::PointValues(
  const std::vector<Index>& points, const Mesh& mesh, const Partition& partition) :
  Parts(partition), Wanted(partition.Peers().size())
{
  std::vector<std::vector<Index>> ids(this->Wanted.size());
  for (Index point : points)
  {
    const Index id = mesh.PointIds[point];
    const Index3 node = NodeOfPoint(mesh.Levels->Finest(), mesh, id);
    if (!partition.OwnsNode(node))
    {
      const int peer = partition.PeerOfNode(node);
      this->Wanted[peer].push_back(point);
      ids[peer].push_back(id);
    }
  }
  this->Asked =
    MapLists(partition.Exchange(ids), [&mesh](Index id) { return FindSorted(mesh.PointIds, id); });
}

} // namespace vfm
