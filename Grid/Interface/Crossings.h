/**
 * Where an interface between two labels crosses the line between the middles of two cells.
 */
#pragma once

#include "Interface/Interface.h"

namespace vfm
{

/// Crossing of the face's dual edge, grid coordinates.
/// isoValue 0.5: average of the PLIC planes of the two cells, weighted by f (1 - f); a linear interpolation
/// where neither is mixed, and for other iso values. The normal blends those of the two cells: of the gradient over 3^3 (weighted least
/// squares); in cells at a side of the domain, where that is tilted, of the plane that fits the fractions of the pair around best (LayerFit.h).
Crossing FindCrossing(const CartesianGrid& grid, const FractionField& fractions,
  const InterfaceFace& face, double isoValue);

/// The same of the nearest face where the fractions of the cells tell the pair, at most two cells away along each axis; where there is
/// none, FindCrossing. For faces of cells whose labels are not those that their fractions tell.
Crossing FindCrossingNear(const CartesianGrid& grid, const FractionField& fractions,
  const InterfaceFace& face, double isoValue);

} // namespace vfm
