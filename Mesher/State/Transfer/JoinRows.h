/**
 * JoinRows: joins contents of neighbour cells that become particles.
 *
 * Cells are chosen as seeds. Every other cell joins the best seed of its material among the 26
 * cells around it: the one with the largest score, then the smallest key. The score of a cell is
 * its fraction and a tenth of the sum of the fractions in the 27 cells; only rows count. Seeds are
 * found in rounds: a cell without a seed around becomes one if it is better than all such cells
 * around it. The owner of a seed joins the cells in a fixed order, so the result does not depend on
 * ranks.
 */
#pragma once

#include "Base/Partition.h"
#include "State/Transfer/StateColumns.h"

namespace vfm
{

/// Which rows are joined.
struct JoinRule
{
  bool All;     ///< else only small rows; all others are seeds
  double Least; ///< volume in cells below which a row is small
};

/// @param rows  of owned cells, one per cell and material
/// @return rows of the seeds in owned cells, ascending by cell and material; positions are in the
///   domain
/// @pre Collective.
UnmeshedRows JoinRows(UnmeshedRows rows, const JoinRule& rule, const StateColumns& columns,
  const Partition& partition, const CartesianGrid& grid);

} // namespace vfm
