/**
 * SurfaceMatch: whether fractions are those of given surfaces. They are not if the grid was moved
 * after the fractions were computed.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "GivenSurfaces/BodySurfaces.h"

namespace vfm
{

/// Compares the exact fractions of bodies with those of the owned cells, in up to 16 layers of
/// cells over the whole domain. A body does not match if the fractions of the cells that its
/// surface cuts differ by more than 0.1 on average (a shift by a fifth of a cell), or if it cuts no
/// cell but its material is mixed with others.
/// @return whether each body matches, equal on all ranks
/// @pre Collective.
std::vector<bool> FindMatches(const BodySurfaces& bodies, const CartesianGrid& grid,
  const FractionField& fractions, Runtime& runtime);

} // namespace vfm
