/**
 * ResolveLabels: labels of cells, or of leaves, from which a valid mesh can be made.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/Labels.h"

namespace vfm
{

class RefinedGrid;

struct ResolveReport
{
  Index FlippedCells = 0; ///< cells, or leaves, that have another label than before
  int Rounds = 0;
  std::vector<Index3>
    CostlyFlips; ///< lowest cells of owned leaves, coarser than the grid's cells, whose flip moves the interface far
};

/// Changes labels until every star passes the label condition (LabelCondition.h). The result does not
/// depend on the order of cells: a round flips every cell whose score (violations removed against
/// fraction given up) beats those of its 26 neighbours. Cells of labels with few cells cost more, and no label loses its last while there
/// is another way; at the end cells get their first labels again where that does no harm. Ranks flip their own cells and exchange the labels after each round.
/// leaves: where given, leaves flip as a whole, and a leaf competes with all that share a node with it; labels must be alike
/// within each (AssignLeafMaterials), and the grid needs 3 base cells of ghosts.
ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition, Runtime& runtime,
  const RefinedGrid* leaves = nullptr);

} // namespace vfm
