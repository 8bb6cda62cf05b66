/**
 * Crossings: points where an interface between two labels crosses the line between the
 * centres of two cells.
 */
#pragma once

#include "Interface/Interface.h"

namespace vfm
{

/// Returns where the interface crosses the dual edge of a face, in grid coordinates.
///
/// For isoValue 0.5, the point is the mean of the cuts of the PLIC planes of both cells, weighted
/// by f (1 - f). If neither cell is mixed, and for other iso values, it is interpolated linearly.
/// The normal blends the normals of both cells, which are along the gradient over 3^3 cells
/// (weighted least squares). The gradient is tilted in cells at a side of the domain. There, the
/// normal is that of the plane that best fits the fractions of the pair around (LayerFit.h).
/// @param fractions  the cells around both cells must be in the local box or outside the domain
Crossing FindCrossing(const CartesianGrid& grid, const FractionField& fractions,
  const InterfaceFace& face, double isoValue);

/// Returns the crossing of the nearest face whose cells have the same pair of labels by their
/// fractions, at most two cells away along each axis. If there is none, returns FindCrossing. It
/// suits faces of cells whose labels differ from their fractions.
Crossing FindCrossingNear(const CartesianGrid& grid, const FractionField& fractions,
  const InterfaceFace& face, double isoValue);

} // namespace vfm
