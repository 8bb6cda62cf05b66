/**
 * ThinParts: gives cells to films, threads and drops that fill no cell by more than half.
 *
 * AssignMaterials tears a film of less than a cell, and loses drops. LabelThinParts adds cells to
 * the set of each material: the cells with its label and all candidates (ThinCandidates.h). Then it
 * thins the set. Candidates leave in the order of their keys, as long as that neither joins nor
 * divides anything. So each part keeps its shape, and becomes as thin as cells allow:
 * - A candidate stays if the rest around it has several parts (it is in a film), if the set around
 *   it has several parts (it is in a thread) or none (it is a drop), or if it is a ridge. It also
 *   stays if it separates what lies inside and outside the domain: a film on a side.
 * - It leaves if it is simple (PartsAround.h).
 * - Candidates inside a thick cloud of small fractions never get a turn. They leave at the end.
 * At a well-resolved interface all candidates are simple, so labels there do not change.
 *
 * Then candidates leave where a part is thinner than the least thickness, whatever they separate,
 * and those that only join corners of thick bodies (ThinSizes.h).
 *
 * In each round the candidates act whose keys are the smallest among all around them that have a
 * turn. They are not adjacent, and their turn depends only on the cells around them. So the result
 * is that of any order which respects keys, on any number of ranks and threads.
 *
 * Thinning that keeps surfaces and curves: G. Bertrand, M. Couprie, Isthmus based parallel and
 * symmetric 3D thinning algorithms, Graphical Models 80 (2015).
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/Labels.h"

#include <optional>

namespace vfm
{

/// A cell that got the label of a thin part.
struct ThinCell
{
  Index Cell;  ///< linear index
  double Load; ///< material that its elements hold, as a fraction of the cell (FindLoad)
};

/// Returns the indices of thin cells, in their order.
inline std::vector<Index> CellsOf(const std::vector<ThinCell>& thin)
{
  std::vector<Index> cells(thin.size());
  std::transform(
    thin.begin(), thin.end(), cells.begin(), [](const ThinCell& cell) { return cell.Cell; });
  return cells;
}

/// Gives cells to the thin parts of all materials. If several materials want a cell, the one with
/// the largest fraction gets it, the smaller number on a tie.
/// @param leastThickness  in cells: where a part is thinner, cells keep their labels
/// @param[in,out] labels  AssignMaterials of the same cells
/// @return the cells of the local box whose label changed, ascending
/// @pre Collective over the ranks of the partition. The grid has at least GhostLayers.
/// @note Bitwise reproducible on any number of ranks and threads.
std::vector<ThinCell> LabelThinParts(const CartesianGrid& grid, const FractionField& fractions,
  double leastThickness, const Partition& partition, Runtime& runtime, LabelArray& labels);

/// Fractions of which thin cells contain more of their label than of any other. With them
/// ResolveLabels prefers to change other cells.
class WithClaims
{
public:
  /// @param fractions  must outlive this object
  /// @param labels,thin  results of LabelThinParts; without thin cells nothing is copied
  WithClaims(
    const FractionField& fractions, const LabelArray& labels, const std::vector<ThinCell>& thin);
  const FractionField& Field() const { return this->Claims ? *this->Claims : this->Fractions; }

private:
  const FractionField& Fractions;
  std::optional<FractionField> Claims;
};

} // namespace vfm
