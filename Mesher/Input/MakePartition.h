/**
 * MakePartition: partitions the grid into one box of cells per rank.
 *
 * Recursive coordinate bisection (Berger and Bokhari, IEEE Transactions on Computers C-36, 1987):
 * the global box is cut across its longest axis, the ranks are divided in halves, and so on. A cut
 * lies where the weights of the sides are nearest to the shares of their ranks. Weights of planes
 * are integers summed over the ranks that divide a box, so they find the same cut. Then a rank of
 * one half and one of the other swap the weights of cells, so that the ranks of a half hold all
 * weights in it. No rank needs the whole grid, or learns of the boxes of all ranks.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Ranks/Ranks.h"

#include <functional>

namespace vfm
{

constexpr Index CellWeight = 1, InterfaceCellWeight = 20;
/// The input is not redistributed if the ratio of maximum to mean weight of the ranks is at
/// most this.
constexpr double GoodBalance = 1.5;

/// Reads the material of each cell of a row along x; negative if a cell has several.
using RowReader = std::function<void(const Index3& first, Index count, int* materials)>;

/// Appends the cells of a box that are mixed, or differ from the previous cell of the box along any
/// axis.
void FindInterfaceCells(const IndexBox& box, const RowReader& read, std::vector<Index3>& found);

/// Partitions the global box.
/// @param blocks cells that this rank holds; the cells of all ranks fill the global box once. If
/// they form one box on every rank and the weights are balanced, these boxes are the partition.
/// @param findInterfaceCells returns the cells of this rank that weigh more. It must not
/// communicate; its exceptions are thrown on all ranks (WorkTogether). Not called on a single rank.
/// @param mayStay false: never use the boxes of the blocks, which may then overlap and leave gaps
/// @return box of this rank; the boxes of all ranks are disjoint, fill the global box, and may be
/// empty
/// @pre Collective
/// @note About log2 P times: messages of 8 bytes per plane of the box that is cut to log2 P ranks,
/// and one message with about 1 to 2 bytes per cell that weighs more and 48 bytes per block.
IndexBox MakePartition(const IndexBox& global, const std::vector<IndexBox>& blocks,
  const std::function<std::vector<Index3>()>& findInterfaceCells, Ranks& ranks,
  bool mayStay = true);

} // namespace vfm
