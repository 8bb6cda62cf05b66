/**
 * ResolveLabels: changes labels of cells, or of leaves, until a valid mesh can be made.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/Labels.h"

namespace vfm
{

class RefinedGrid;

/// Changes made by ResolveLabels.
struct ResolveReport
{
  Index FlippedCells = 0; ///< cells or leaves, over all ranks, whose label differs from before
  std::vector<Index> LostCells;   ///< those of them that had label 0, 1, ..
  std::vector<Index> GainedCells; ///< those of them that have label 0, 1, .. now
  int Rounds = 0;
  /// Lowest cells of owned leaves of several cells whose flip moves the interface far.
  std::vector<Index3> CostlyFlips;
};

/// Changes labels until every star passes the label condition (LabelCondition.h). It works in
/// rounds. A cell flips if its score (violations removed against fraction lost) beats the scores of
/// its 26 neighbours. The result does not depend on the order of cells. Cells of labels with few
/// cells cost more. A label loses its last cell only if there is no other way. At the end, cells
/// get their initial labels again where that adds no violation. Ranks flip their own cells and
/// exchange the labels after each round.
/// @param fractions  fractions of the cells of the local box
/// @param[in,out] labels  labels of the same cells, from AssignMaterials or AssignLeafMaterials
/// @param leaves  if given, leaves flip as a whole and compete with all leaves that share a
///   node with them; labels must be equal within each leaf, and the grid needs ghost layers
///   of three base cells
/// @param keepsSeam  whether labels must also pass the condition of flat seams, as hexes need.
///   Without leaves, cells that are equal across a flat seam then flip together (GlueBlocks.h), and
///   a periodic grid needs its GhostLayers
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks and threads.
ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition, Runtime& runtime,
  const RefinedGrid* leaves = nullptr, bool keepsSeam = false);

} // namespace vfm
