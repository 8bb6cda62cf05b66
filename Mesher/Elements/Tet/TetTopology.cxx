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

void FillFragments(const CartesianGrid& grid, const Fragments& fragments, Mesh& mesh)
{
  mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    Index centre = mesh.Elements[4 * t + 3];
    if (IsCentre(mesh, mesh.PointIds[mesh.Elements[4 * t]]))
    {
      centre = mesh.Elements[4 * t];
    }
    mesh.Fragment[t] = fragments.FragmentOfCell(CellOfCentre(grid, mesh, mesh.PointIds[centre]));
  }
}

void FillInside(Mesh& mesh)
{
  mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
  std::fill(mesh.GeometryId.begin(), mesh.GeometryId.end(), 0); // barriers leave points out
  for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
  {
    mesh.GeometryId[mesh.Elements[at]] = mesh.Fragment[at / 4];
  }
}

} // namespace vfm
