/**
 * GhostFractions: receives the fractions of ghost cells from the ranks that own them.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Sets the fractions of ghost cells to the values on the ranks that own them.
/// @pre Collective.
void FillGhosts(const Partition& partition, FractionField& fractions);

/// Replaces a grid by a grid of the same domain with other layers or copies, and its fractions.
/// @param to  grid of which this rank owns the same cells; their indices may differ
/// @pre Collective.
void ReplaceGrid(CartesianGrid to, Ranks& ranks, CartesianGrid& grid, FractionField& fractions);

/// Extends a grid and its fractions to the requested layers. Does nothing if all
/// ranks have them already.
/// @param layers  requested layers of ghost cells and hexes
/// @param[in,out] grid,fractions  replaced together
/// @pre Collective.
void WidenGrid(
  const GridLayers& layers, Ranks& ranks, CartesianGrid& grid, FractionField& fractions);

} // namespace vfm
