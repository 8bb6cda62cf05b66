#include "Elements/Tet/TetTopology.h"

#include "Octree/LevelIds.h"

namespace vfm
{

bool IsCentre(const Mesh& mesh, Index pointId)
{
  return IsCoarsePoint(*mesh.Levels, pointId, mesh.Ids.PointSlots)
    ? IsCoarseCentre(*mesh.Levels, pointId, mesh.Ids.PointSlots)
    : SlotOfPoint(pointId) == CentreSlot;
}

Index3 CellOfCentre(const CartesianGrid& grid, const Mesh& mesh, Index pointId)
{
  if (!IsCoarsePoint(*mesh.Levels, pointId, mesh.Ids.PointSlots))
  {
    return NodeOfPoint(grid, mesh, pointId);
  }
  const OctreeKeys::LevelIndex leaf =
    CellOfCoarseCentre(*mesh.Levels, pointId, mesh.Ids.PointSlots);
  return mesh.Levels->NearestCell(leaf.Level, leaf.At);
}

} // namespace vfm
