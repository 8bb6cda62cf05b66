/**
 * BlockPoints: numbers and makes the points of tets, block by block (TetTopology.h).
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Tet/CoarseTets.h"
#include "Elements/Tet/LatticeStencils.h"

#include <bitset>
#include <numeric>

namespace vfm
{

/// Returns the number of bits that are set.
inline int CountBits(std::uint64_t slots)
{
  return static_cast<int>(slots < 4 ? (slots & 1) + (slots >> 1) : std::bitset<64>(slots).count());
}

/// Makes the points of the blocks of CartesianGrid::HexBox. Allocates the points of coarse tets
/// after them, which CoarseTets::Fill writes.
/// @param slotsOf  slotsOf(block, node) returns the slots in use, one bit per slot
/// @param positionOf  positionOf(block, node, slot) returns the PointPosition of a point
/// @param[out] firstPoint  first point of each block, by the linear index of its node
/// @return number of points of blocks, which is the index of the first point of coarse tets
/// @throws InputError  on all ranks if any rank has more points than 32 bits can number
/// @pre Collective.
template <class SlotsOf, class PositionOf, class FirstPoints>
Index MakeBlockPoints(const CartesianGrid& grid, const CoarseTets& coarse, Runtime& runtime,
  const SlotsOf& slotsOf, const PositionOf& positionOf, FirstPoints& firstPoint,
  TetTopology& result)
{
  const IndexBox blocks = NodesOf(grid.HexBox());
  const auto forRow = [&](Index j, Index k, const auto& body)
  {
    Index3 block{ { blocks.Lower[0], j, k } };
    Index node = grid.Linear(block);
    for (; block[0] < blocks.Upper[0]; ++block[0], ++node)
    {
      body(block, node, slotsOf(block, node));
    }
  };
  // First point of each row, and the end.
  std::vector<Index> firsts(blocks.Size(1) * blocks.Size(2) + 1, 0);
  ForRows(runtime, blocks,
    [&](Index j, Index k, Index row)
    {
      forRow(j, k,
        [&](const Index3&, Index, std::uint64_t slots) { firsts[row + 1] += CountBits(slots); });
    });
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  const Index points = firsts.back() + coarse.NumberOfPoints();
  CheckNumberOfPoints(points, runtime.Group());
  Mesh& mesh = result.Tets;
  mesh.Corners = 4;
  mesh.Ids = TetIds;
  mesh.Levels = coarse.Levels().shared_from_this();
  mesh.ResizePoints(points);
  result.Positions.assign(points, PointPosition::Inside);
  ForRows(runtime, blocks,
    [&](Index j, Index k, Index row)
    {
      Index point = firsts[row];
      forRow(j, k,
        [&](const Index3& block, Index node, std::uint64_t slots)
        {
          firstPoint[node] = static_cast<int>(point);
          const Index id = grid.NodeKey(block) * TetIds.PointSlots + 1;
          for (int slot = 0; slots != 0; slots >>= 1, ++slot)
          {
            if (slots & 1)
            {
              mesh.SetPoint(point, LatticeTables::Get().StartOf(grid, block, slot), id + slot);
              result.Positions[point++] = positionOf(block, node, slot);
            }
          }
        });
    });
  return firsts.back();
}

} // namespace vfm
