/**
 * MakePartition: one box of cells a rank.
 *
 * The global box is cut in two across its longest axis, the ranks likewise, and so on (recursive coordinate bisection:
 * Berger, Bokhari 1987). A cut lies where the weights of the two sides come nearest to their ranks' shares. Planes are
 * weighed in integers summed over the ranks, so all ranks find the same boxes, and none sees the grid.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Ranks/Ranks.h"

#include <functional>

namespace vfm
{

constexpr Index CellWeight = 1, InterfaceCellWeight = 20;
/// Largest over mean weight of the ranks up to which input stays where it is.
constexpr double GoodBalance = 1.5;

/// The box of each rank, the same list on all ranks. Boxes are disjoint, fill global, and may be empty.
/// blocks: the cells that this rank holds; those of all ranks fill global once. When they form one box on every rank
/// and the weights are balanced, those boxes are the partition.
/// findInterfaceCells: lists those of this rank's cells that weigh more; it must not communicate. Its exceptions are
/// thrown on all ranks (WorkTogether). Not called when there is one rank.
/// mayStay: false: never those boxes; blocks may then overlap and leave gaps.
/// Memory and messages a rank: 48 bytes a rank of all, and 8 bytes a plane of the boxes that are being cut.
std::vector<IndexBox> MakePartition(const IndexBox& global, const std::vector<IndexBox>& blocks,
  const std::function<std::vector<Index3>()>& findInterfaceCells, Ranks& ranks,
  bool mayStay = true);

} // namespace vfm
