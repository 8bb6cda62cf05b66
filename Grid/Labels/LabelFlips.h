/**
 * LabelFlips: the state of ResolveLabels: labels that change, the nodes whose stars are violated,
 * and the prices of changes.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/LabelSizes.h"
#include "Labels/LeafLabels.h"

#include <unordered_map>

namespace vfm
{

/// Labels that change until no star is violated, and what determines how. Ranks change their own
/// cells and exchange the labels.
struct LabelFlips
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  LabelArray& Labels;
  const Partition& Parts;
  const RefinedGrid* Leaves; ///< nullptr if units are cells
  const bool KeepsSeam;      ///< whether the condition of flat seams holds too
  /// Whether cells glued across a flat seam (SeamBlocks.h) are one unit.
  const bool HasBlocks = KeepsSeam && !Leaves;
  const LabelUnits Units{ Grid, Leaves, HasBlocks ? &Labels : nullptr };
  /// Holds the units that compete with units of owned cells. A block of an owned cell ends one cell
  /// beyond it, so adjacent units end two cells beyond it.
  const IndexBox Near = Grid.Extended(HasBlocks ? 2 : Units.LargestWidth());
  /// Holds the units of cells in Near. All their nodes are known.
  const IndexBox Reach = Grid.Extended(HasBlocks ? 3 : Units.LargestWidth());
  std::vector<Index> Violated{}; ///< nodes in Reach that are violated, and changed nodes
  /// Initial labels of flipped cells or leaves that are owned or in Near, and of others.
  std::unordered_map<Index, int> Original{};
  std::unique_ptr<LabelSizes> Sizes{};
};

/// New label of some cells.
struct LabelChange
{
  IndexBox Cells;
  int Label;
};

/// Returns whether this rank owns a cell of a box.
inline bool OwnsSome(const LabelFlips& flips, const IndexBox& cells)
{
  return Intersect(cells, flips.Grid.Owned()).NumberOfCells() > 0;
}

/// Calls body(n, size) for the linear index n and the number of cells of each cell or leaf of a
/// unit or block.
template <class Body>
void ForParts(const LabelFlips& flips, const IndexBox& cells, const Body& body)
{
  if (flips.Leaves)
  {
    body(flips.Grid.Linear(cells.Lower), cells.NumberOfCells());
    return;
  }
  ForCells(cells, [&](const Index3& cell) { body(flips.Grid.Linear(cell), 1); });
}

/// Keeps the nodes in Violated that are in Reach and violated.
void KeepViolated(LabelFlips& flips, Runtime& runtime);

/// Returns the violations removed at the nodes of some cells by each of some labels.
/// @param cells  a unit, or cells without levels
std::vector<int> FindGains(
  const LabelFlips& flips, const IndexBox& cells, const std::vector<int>& labels);

/// Returns the fraction that a unit loses times its width: how far the interface moves, in
/// cells of the grid; for glued cells the sum of these distances.
double Cost(const LabelFlips& flips, const IndexBox& cells, int current, int label);

/// Returns the price of a flip of a unit: its cost, higher for small labels.
double Price(const LabelFlips& flips, const IndexBox& cells, int current, int label);

/// Applies changes on all ranks. Each rank also stores the initial labels of cells that change
/// around its own.
/// @param changes  changes of boxes that hold owned cells, the same for all copies of a box
/// @param others  boxes without owned cells that may change
/// @pre Collective.
void ApplyChanges(
  LabelFlips& flips, const std::vector<LabelChange>& changes, const std::vector<IndexBox>& others);

} // namespace vfm
