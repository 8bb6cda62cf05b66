#include "Mesh/Mesh.h"

#include "Base/Runtime.h"
#include "Mesh/LevelIds.h"

#include <limits>

namespace vfm
{
namespace
{

bool IsCoarse(const Mesh& mesh, Index element)
{
  return mesh.Corners == 8 ? IsCoarseElement(*mesh.Levels, element, mesh.Ids.ElementSlots)
                           : IsCoarseTet(*mesh.Levels, element, mesh.Ids.ElementSlots);
}

} // namespace

Index3 NodeOfPoint(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  if (IsCoarsePoint(*mesh.Levels, id, mesh.Ids.PointSlots))
  {
    return NodeOfCoarsePoint(*mesh.Levels, id, mesh.Ids.PointSlots);
  }
  return grid.NodeOfKey((id - 1) / mesh.Ids.PointSlots);
}

IndexBox CellsOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  if (IsCoarse(mesh, id))
  {
    const OctreeKeys::LevelIndex cell = mesh.Corners == 8
      ? CellOfCoarseElement(*mesh.Levels, id, mesh.Ids.ElementSlots)
      : CellOfCoarseTet(*mesh.Levels, id, mesh.Ids.ElementSlots);
    return mesh.Levels->FinestCells(cell.Level, cell.At);
  }
  const Index key = (id - 1) / mesh.Ids.ElementSlots;
  return BoxOfCell(mesh.Corners == 8 ? grid.CellOfKey(key) : grid.CellOfBlock(grid.NodeOfKey(key)));
}

Index3 CellOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  return CellsOfElement(grid, mesh, id).Lower;
}

void CheckNumberOfPoints(Index points, Ranks& ranks)
{
  if (ranks.Any(points > std::numeric_limits<int>::max()))
  {
    throw InputError("More than 2^31 mesh points on one rank: use more ranks.");
  }
}

} // namespace vfm
