#include "Smoothing/Tet/TetAttach.h"

#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Elements/Tet/LeafNodes.h"
#include "Smoothing/Attach.h"

#include <limits>

namespace vfm
{
namespace
{

/// Returns the surface point of a pair of labels that is nearest to x, or -1 if there is none.
/// Candidates are the nodes from one below a block to two above, along each axis.
Index FindNearestTarget(const Interface& interface, const Index3& block, const Vector3& x,
  const std::array<int, 2>& labels)
{
  const CartesianGrid& grid = interface.Grid();
  const std::vector<Index>& nodes = interface.Nodes();
  // The cells whose nodes are the candidates.
  const IndexBox cells =
    Intersect({ CellOfStar(block, 0), CornerOfCell(CornerOfCell(block, 7), 7) }, grid.Local());
  Index best = -1;
  double nearest = std::numeric_limits<double>::max();
  ForRows(NodesOf(cells),
    [&](Index j, Index k)
    {
      const Index last = grid.Linear({ { cells.Upper[0], j, k } });
      auto node =
        std::lower_bound(nodes.begin(), nodes.end(), grid.Linear({ { cells.Lower[0], j, k } }));
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
    });
  return best;
}

/// Returns the target of a node of a refined grid in the finest possible level, or -1.
Index FindLevelTarget(const LevelInterfaces& interfaces, const RefinedGrid& levels,
  const Index3& node, const std::array<int, 2>& labels)
{
  Index target = -1;
  for (int level = FinestLevelAt(levels, node), shift; target < 0 && level >= 0; --level)
  {
    shift = levels.NumberOfRefinements() - level;
    const Index3 at{ { node[0] >> shift, node[1] >> shift, node[2] >> shift } };
    if (levels.FinestNode(level, at) != node)
    {
      break;
    }
    target = interfaces.FindTarget(level, at, labels);
  }
  return target;
}

} // namespace

void AttachTets(const LevelInterfaces& interfaces, const Mesh& mesh,
  const std::vector<Facet>& facets, TetMethod method, Runtime& runtime, ActiveMesh& active)
{
  const RefinedGrid& levels = *mesh.Levels;
  if (!levels.HasFineInterfaces())
  {
    const auto findTarget = [&](int point, const std::array<int, 2>& labels)
    {
      const Index id = mesh.PointIds[active.MeshPoint[point]];
      return FindLevelTarget(interfaces, levels, NodeOfPoint(levels.Finest(), mesh, id), labels);
    };
    AttachToFacets(facets, findTarget, runtime, active);
    return;
  }
  const Interface& interface = *interfaces.All().back();
  const CartesianGrid& grid = interface.Grid();
  const auto findTarget = [&](int point, const std::array<int, 2>& labels)
  {
    const Index3 block = NodeOfPoint(grid, mesh, mesh.PointIds[active.MeshPoint[point]]);
    const Index node = method == TetMethod::Lattice ? -1 : interface.Find(grid.Linear(block));
    const SurfacePoint* own = node < 0 ? nullptr : interface.FindPoint(node, labels[0], labels[1]);
    return own ? own - interface.Points().data()
               : FindNearestTarget(interface, block, active.X[point], labels);
  };
  AttachToFacets(facets, findTarget, runtime, active);
}

} // namespace vfm
