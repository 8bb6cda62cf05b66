#include "Tet/TetTopology.h"

#include "Octree/RefinedGrid.h"

namespace vfm
{

bool IsCentre(const Mesh& mesh, Index pointId)
{
  return mesh.Levels->IsCoarsePoint(pointId, mesh.Ids.PointSlots)
    ? mesh.Levels->IsCoarseCentre(pointId, mesh.Ids.PointSlots)
    : SlotOfPoint(pointId) == CentreSlot;
}

Index3 CellOfCentre(const CartesianGrid& grid, const Mesh& mesh, Index pointId)
{
  if (!mesh.Levels->IsCoarsePoint(pointId, mesh.Ids.PointSlots))
  {
    return NodeOfPoint(grid, mesh, pointId);
  }
  const OctreeKeys::LevelIndex leaf = mesh.Levels->CellOfCoarseCentre(pointId, mesh.Ids.PointSlots);
  return mesh.Levels->NearestCell(leaf.Level, leaf.At);
}

} // namespace vfm
