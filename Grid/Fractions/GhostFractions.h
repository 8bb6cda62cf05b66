/**
 * The fractions of ghost cells, from the ranks that own them.
 */
#pragma once

#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Sets the ghost cells of a field to what it is in the cells of their owners. Collective.
void FillGhosts(const Partition& partition, FractionField& fractions);

/// The fractions of a grid on one with the same owned cells and other ghost layers. Collective.
FractionField CopyWithGhosts(
  const CartesianGrid& from, const FractionField& fractions, const CartesianGrid& to, Ranks& ranks);

} // namespace vfm
