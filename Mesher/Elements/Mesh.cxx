#include "Elements/Mesh.h"

#include "Base/Runtime.h"
#include "Octree/LevelIds.h"

#include <limits>

namespace vfm
{
namespace
{

bool IsCoarse(const Mesh& mesh, Index element)
{
  return mesh.HasHexes() ? IsCoarseElement(*mesh.Levels, element, mesh.Ids.ElementSlots)
                         : IsCoarseTet(*mesh.Levels, element, mesh.Ids.ElementSlots);
}

/// On a flat seam, tets 0 and 1 of a face belong to the cell below it.
Index3 CellOfTet(const CartesianGrid& grid, Index id)
{
  const Index3 block = grid.NodeOfKey((id - 1) / TetIds.ElementSlots);
  const int tet = static_cast<int>((id - 1) % TetIds.ElementSlots / PiecesPerTet);
  Index3 cell = grid.CellOfBlock(block);
  cell[tet / 4] -= tet % 4 < 2 && grid.IsOnFlatSeam(block, tet / 4);
  return cell;
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
    const OctreeKeys::LevelIndex cell = mesh.HasHexes()
      ? CellOfCoarseElement(*mesh.Levels, id, mesh.Ids.ElementSlots)
      : CellOfCoarseTet(*mesh.Levels, id, mesh.Ids.ElementSlots);
    return mesh.Levels->FinestCells(cell.Level, cell.At);
  }
  const Index key = (id - 1) / mesh.Ids.ElementSlots;
  return BoxOfCell(mesh.HasHexes() ? grid.CellOfKey(key) : CellOfTet(grid, id));
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
