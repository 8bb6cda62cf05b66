#include "Smoothing/Hex/FlatColumns.h"

namespace vfm
{
namespace
{

/// Difference of the ids of the points of a column.
Index IdStep(const CartesianGrid& grid, int axis, const Mesh& mesh)
{
  Index3 step{};
  step[axis] = 1;
  return mesh.Ids.PointSlots * grid.NodeKey(step);
}

/// Returns the mesh point with an id, or -1.
Index FindPoint(const Mesh& mesh, Index id)
{
  const auto found = std::lower_bound(mesh.PointIds.begin(), mesh.PointIds.end(), id);
  return found != mesh.PointIds.end() && *found == id ? found - mesh.PointIds.begin() : -1;
}

/// Returns the mesh point above a lower point, or -1 for an upper point.
Index FindAbove(const CartesianGrid& grid, int axis, const Mesh& mesh, Index step, Index point)
{
  const Index id = mesh.PointIds[point];
  return NodeOfPoint(grid, mesh, id)[axis] == 0 ? FindPoint(mesh, id + step) : -1;
}

} // namespace

void StraightenColumns(const CartesianGrid& grid, int axis, Runtime& runtime, Mesh& mesh)
{
  const Index step = IdStep(grid, axis, mesh);
  ForEach(runtime, mesh.PointIds.size(),
    [&](Index point)
    {
      const Index above = FindAbove(grid, axis, mesh, step, point);
      for (int a = 0; above >= 0 && a < 3; ++a)
      {
        if (a != axis)
        {
          mesh.Points[3 * above + a] = mesh.Points[3 * point + a];
        }
      }
    });
}

void ListColumns(const CartesianGrid& grid, const Mesh& mesh, int axis, ActiveMesh& active)
{
  const Index step = IdStep(grid, axis, mesh);
  active.ColumnAxis = axis;
  for (std::size_t p = 0; p < active.X.size(); ++p)
  {
    const Index above = FindAbove(grid, axis, mesh, step, active.MeshPoint[p]);
    const int upper = above >= 0 ? active.PointOf[above] : -1;
    if (upper >= 0 && active.IsActive[p])
    {
      active.Columns.push_back({ { static_cast<int>(p), upper } });
      active.IsActive[upper] = 0;
    }
  }
  active.AlignColumns();
}

} // namespace vfm
