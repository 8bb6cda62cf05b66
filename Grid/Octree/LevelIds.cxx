#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

Index NumberOfNodes(const CartesianGrid& grid)
{
  return grid.NodeKey(grid.Global().Upper) + 1;
}

Index NumberOfCells(const CartesianGrid& grid)
{
  return grid.Global().NumberOfCells();
}

} // namespace

Index CoarsePointId(const RefinedGrid& grid, Index key, Index slots, int slot)
{
  return (NumberOfNodes(grid.Finest()) + key) * slots + slot + 1;
}

Index PointId(const RefinedGrid& grid, Index key, Index slots, int slot)
{
  const OctreeKeys::LevelIndex index = grid.Lattice().NodeOfKey(key);
  const Index3 node = grid.FinestNode(index.Level, index.At);
  return index.Slot == 0 && grid.TouchesFine(node) ? grid.Finest().NodeKey(node) * slots + slot + 1
                                                   : CoarsePointId(grid, key, slots, slot);
}

Index ElementId(const RefinedGrid& grid, Index key, Index slots, int slot)
{
  return (NumberOfCells(grid.Finest()) + key) * slots + slot + 1;
}

bool IsCoarsePoint(const RefinedGrid& grid, Index id, Index slots)
{
  return id > NumberOfNodes(grid.Finest()) * slots;
}

bool IsCoarseElement(const RefinedGrid& grid, Index id, Index slots)
{
  return id > NumberOfCells(grid.Finest()) * slots;
}

Index KeyOfPoint(const RefinedGrid& grid, Index id, Index slots)
{
  return IsCoarsePoint(grid, id, slots) ? (id - 1) / slots - NumberOfNodes(grid.Finest())
                                        : grid.Lattice().LatticeKey(grid.NumberOfRefinements(),
                                            grid.Finest().NodeOfKey((id - 1) / slots));
}

Index3 NodeOfCoarsePoint(const RefinedGrid& grid, Index id, Index slots)
{
  if (IsCoarseCentre(grid, id, slots))
  {
    const OctreeKeys::LevelIndex cell = CellOfCoarseCentre(grid, id, slots);
    return grid.FinestCells(cell.Level, cell.At).Upper; // the owner of the cell owns this node
  }
  const OctreeKeys::LevelIndex index = grid.Lattice().NodeOfKey(KeyOfPoint(grid, id, slots));
  return grid.FinestNode(index.Level, index.At);
}

OctreeKeys::LevelIndex CellOfCoarseElement(const RefinedGrid& grid, Index id, Index slots)
{
  return grid.Lattice().HexOfKey((id - 1) / slots - NumberOfCells(grid.Finest()));
}

Index CentreId(const RefinedGrid& grid, Index hexKey, Index slots)
{
  const Index nodeKeys = grid.Lattice().NodeKey(grid.NumberOfRefinements(),
                           grid.Finest().Global().Upper, OctreeKeys::NodeSlots - 1) +
    1;
  return (NumberOfNodes(grid.Finest()) + nodeKeys) * slots + hexKey + 1;
}

Index TetId(const RefinedGrid& grid, Index hexKey, Index number, Index slots)
{
  return NumberOfNodes(grid.Finest()) * slots + TetsOfCell * (hexKey / OctreeKeys::HexSlots) +
    number + 1;
}

bool IsCoarseCentre(const RefinedGrid& grid, Index id, Index slots)
{
  return id >= CentreId(grid, 0, slots);
}

bool IsCoarseTet(const RefinedGrid& grid, Index id, Index slots)
{
  return id >= TetId(grid, 0, 0, slots);
}

OctreeKeys::LevelIndex CellOfCoarseCentre(const RefinedGrid& grid, Index id, Index slots)
{
  return grid.Lattice().HexOfKey(id - CentreId(grid, 0, slots));
}

OctreeKeys::LevelIndex CellOfCoarseTet(const RefinedGrid& grid, Index id, Index slots)
{
  return grid.Lattice().HexOfKey(
    (id - TetId(grid, 0, 0, slots)) / TetsOfCell * OctreeKeys::HexSlots);
}

Index EndOfPointIds(const RefinedGrid& grid, Index slots)
{
  if (grid.IsUniform())
  {
    return NumberOfNodes(grid.Finest()) * slots + 1;
  }
  Index3 last;
  for (int a = 0; a < 3; ++a)
  {
    last[a] = grid.Finest().Global().Upper[a] - 1;
  }
  return CentreId(grid,
           grid.Lattice().HexKey(grid.NumberOfRefinements(), last, OctreeKeys::HexSlots - 1),
           slots) +
    1;
}

} // namespace vfm
