/**
 * One label a cell: the material it is meshed as, 0 void. The array has the shape of CartesianGrid's
 * cells, its outer layer mirrored.
 */
#pragma once

#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

class RefinedGrid;
class Runtime;

using LabelArray = PagedArray<int>;

/// The labels of all cells of the local box; of a pure one its own.
LabelArray AssignMaterials(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue);

/// Whether elements are made of a label; of -1, which stands for none, never.
inline bool IsMeshed(int label, bool meshVoid)
{
  return label > 0 || (label == 0 && meshVoid);
}

/// The eight labels around a node.
inline std::array<int, 8> StarOfNode(
  const CartesianGrid& grid, const LabelArray& labels, Index node)
{
  std::array<int, 8> star;
  const Index first = grid.CellOfNode(node, 0), i = labels.InRow(first);
  for (int c = 0; c < 8; c += 2)
  {
    const LabelArray::RowView row = labels.Row(first + grid.CornerOffset(c));
    star[c] = row[i];
    star[c + 1] = row[i + 1];
  }
  return star;
}

/// The nodes of the local box with more than one label around them, ascending.
std::vector<Index> FindMixedNodes(const CartesianGrid& grid, const LabelArray& labels);

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
