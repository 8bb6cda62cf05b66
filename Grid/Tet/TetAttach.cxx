#include "Tet/TetAttach.h"

#include "Base/Vector3.h"
#include "Smoothing/Attach.h"

#include <limits>

namespace vfm
{
namespace
{

/// The surface point of the pair nearest to x among the nodes from one below a block to two above; -1: none.
Index FindNearestTarget(const Interface& interface, const Index3& block, const Vector3& x,
  const std::array<int, 2>& labels)
{
  const CartesianGrid& grid = interface.Grid();
  const std::vector<Index>& nodes = interface.Nodes();
  Index3 low, high; // nodes
  for (int a = 0; a < 3; ++a)
  {
    low[a] = std::max(block[a] - 1, grid.Local().Lower[a]);
    high[a] = std::min(block[a] + 2, grid.Local().Upper[a]);
  }
  Index best = -1;
  double nearest = std::numeric_limits<double>::max();
  for (Index k = low[2]; k <= high[2]; ++k)
  {
    for (Index j = low[1]; j <= high[1]; ++j)
    {
      const Index last = grid.Linear({ { high[0], j, k } });
      auto node = std::lower_bound(nodes.begin(), nodes.end(), grid.Linear({ { low[0], j, k } }));
      for (; node != nodes.end() && *node <= last; ++node)
      {
        const SurfacePoint* point = interface.FindPoint(node - nodes.begin(), labels[0], labels[1]);
        const double distance = point ? Dot(point->Point - x, point->Point - x) : nearest;
        if (distance < nearest)
        {
          nearest = distance;
          best = point - interface.Points().data();
        }
      }
    }
  }
  return best;
}

} // namespace

void AttachTets(const Interface& interface, const Mesh& mesh, const std::vector<Facet>& facets,
  TetMethod method, ActiveMesh& active)
{
  const CartesianGrid& grid = interface.Grid();
  const auto findTarget = [&](int point, const std::array<int, 2>& labels)
  {
    const Index3 block = NodeOfPoint(grid, mesh, mesh.PointIds[active.MeshPoint[point]]);
    const Index node = method == TetMethod::Lattice ? -1 : interface.Find(grid.Linear(block));
    const SurfacePoint* own = node < 0 ? nullptr : interface.FindPoint(node, labels[0], labels[1]);
    return own ? own - interface.Points().data()
               : FindNearestTarget(interface, block, active.Start[point], labels);
  };
  AttachToFacets(facets, findTarget, active);
}

} // namespace vfm
