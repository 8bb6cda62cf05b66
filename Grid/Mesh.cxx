#include "Mesh.h"

#include "RefinedGrid.h"
#include "Runtime.h"

#include <limits>

namespace vfm
{
namespace
{

Index3 Unpack(Index key, const Index3& size)
{
  return { { key % size[0], key / size[0] % size[1], key / (size[0] * size[1]) } };
}

bool IsOuter(const Mesh& mesh, Index element)
{
  return mesh.Corners == 8 ? mesh.Levels->IsOuterElement(element, mesh.ElementSlots)
                           : mesh.Levels->IsOuterTet(element, mesh.ElementSlots);
}

} // namespace

Index3 NodeOfKey(const CartesianGrid& grid, Index key)
{
  const Index3& n = grid.Global().Upper;
  return Unpack(key, { { n[0] + 1, n[1] + 1, n[2] + 1 } });
}

Index3 NodeOfPoint(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  if (mesh.Levels && mesh.Levels->IsOuterPoint(id, mesh.PointSlots))
  {
    return mesh.Levels->NodeOfOuterPoint(id, mesh.PointSlots);
  }
  return NodeOfKey(grid, (id - 1) / mesh.PointSlots);
}

IndexBox CellsOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  if (mesh.Levels && IsOuter(mesh, id))
  {
    const RefinedLattice::Place cell = mesh.Corners == 8
      ? mesh.Levels->CellOfOuterElement(id, mesh.ElementSlots)
      : mesh.Levels->CellOfOuterTet(id, mesh.ElementSlots);
    return mesh.Levels->FinestCells(cell.Level, cell.At);
  }
  const Index key = (id - 1) / mesh.ElementSlots;
  const Index3& n = grid.Global().Upper;
  const Index3 cell = mesh.Corners == 8 ? Unpack(key, n) : CellOfBlock(grid, NodeOfKey(grid, key));
  return { cell, { { cell[0] + 1, cell[1] + 1, cell[2] + 1 } } };
}

Index3 CellOfElement(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  return CellsOfElement(grid, mesh, id).Lower;
}

Index3 CellOfBlock(const CartesianGrid& grid, const Index3& node)
{
  const Index3& n = grid.Global().Upper;
  return { { std::min(node[0], n[0] - 1), std::min(node[1], n[1] - 1),
    std::min(node[2], n[2] - 1) } };
}

void CheckIds(const CartesianGrid& grid, Index slots)
{
  double ids = static_cast<double>(slots);
  for (Index n : grid.Global().Upper)
  {
    ids *= static_cast<double>(n + 1);
  }
  if (ids >= static_cast<double>(std::numeric_limits<Index>::max()))
  {
    throw InputError("The grid has more nodes than 64-bit global ids can number.");
  }
}

void CheckNumberOfPoints(Index points, Ranks& ranks)
{
  if (ranks.Any(points > std::numeric_limits<int>::max()))
  {
    throw InputError("More than 2^31 mesh points on one rank: use more ranks.");
  }
}

} // namespace vfm
