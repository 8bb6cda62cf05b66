#include "Geometry/CloseSeam.h"

#include "Elements/PeriodicIds.h"
#include "Elements/PointValues.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{
namespace
{

/// A point of which there are copies in the mesh, its shift in periods from the owned copy, and the
/// axes (bits) along which it is on a seam.
struct SeamPoint
{
  Index Point;
  Index3 Shift;
  int Seams;
};

std::vector<SeamPoint> ListSeamPoints(const CartesianGrid& grid, const Mesh& mesh)
{
  std::vector<SeamPoint> points;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Index3 node = NodeOfPoint(grid, mesh, mesh.PointIds[p]);
    if (!HasCopies(grid, node))
    {
      continue;
    }
    const Index3 owned = grid.CanonicalNode(node);
    points.push_back({ static_cast<Index>(p), {}, 0 });
    for (int a = 0; a < 3; ++a)
    {
      const Index period = grid.Period(a);
      points.back().Shift[a] = period > 0 ? (node[a] - owned[a]) / period : 0;
      points.back().Seams |= (period > 0 && owned[a] == grid.Domain().Upper[a]) << a;
    }
  }
  return points;
}

} // namespace

void CloseSeam(const Partition& partition, Mesh& mesh)
{
  const CartesianGrid& grid = mesh.Levels->Finest();
  if (!grid.IsPeriodic())
  {
    return;
  }
  const std::vector<SeamPoint> seam = ListSeamPoints(grid, mesh);
  std::vector<Index> points;
  for (const SeamPoint& point : seam)
  {
    points.push_back(point.Point);
  }
  std::vector<Vector3> positions(mesh.PointIds.size());
  for (std::size_t p = 0; p < positions.size(); ++p)
  {
    positions[p] = mesh.PointAt(static_cast<Index>(p));
  }
  std::vector<Vector3> owned = positions;
  PointValues(points, mesh, partition)
    .Fetch(positions, [&owned](Index point, const Vector3& x) { owned[point] = x; });
  for (const SeamPoint& point : seam)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double length = grid.PeriodLength(a), x = owned[point.Point][a];
      const auto shift = static_cast<double>(point.Shift[a]);
      // Points inside keep their coordinate, and only points on seams have copies below them.
      mesh.Points[3 * point.Point + a] =
        point.Seams >> a & 1 ? (x - length) + (shift + 1.0) * length : x + shift * length;
    }
  }
}

} // namespace vfm
