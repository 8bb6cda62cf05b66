/**
 * ThinPlaces: requests refinement where the surfaces of bodies are close to themselves.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "Labels/RefinementCriteria.h"

namespace vfm
{

/// Returns the owned cells at places of surfaces where walls or gaps of a body are thinner than a
/// number of cells, with the halvings until they are not.
/// @param bodies  in grid coordinates of the grid
/// @param fractions  places count in cells that have some of the body
/// @param most  largest number of halvings
/// @note Bitwise reproducible on any number of ranks and threads.
std::vector<ChosenBox> FindThinPlaces(const BodySurfaces& bodies, const CartesianGrid& grid,
  const FractionField& fractions, double thinCells, int most, Runtime& runtime);

} // namespace vfm
