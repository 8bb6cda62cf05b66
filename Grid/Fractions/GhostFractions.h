/**
 * The fractions of ghost cells, from the ranks that own them.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Sets the ghost cells of a field to what it is in the cells of their owners. Collective.
void FillGhosts(const Partition& partition, FractionField& fractions);

/// Gives a grid so many layers, and fractions in them; nothing where it has them on all ranks. Collective.
void WidenGrid(
  const GridLayers& layers, Ranks& ranks, CartesianGrid& grid, FractionField& fractions);

} // namespace vfm
