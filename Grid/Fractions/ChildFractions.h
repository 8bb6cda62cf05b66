/**
 * ChildFractions: divides the fractions of a mixed cell among its children, equal boxes in a given
 * number along each axis.
 *
 * Two parts are separated by the plane nearest to the fractions of the cell and its 26
 * neighbours. If the plane fits badly, the film between two parallel planes is tried. If
 * neither fits (edges, corners, rods, small balls), a part gets the region where a field,
 * linear between cell centres, exceeds the value that gives the right volume
 * (SharpFractions.h). This keeps thin objects connected.
 *
 * Three parts or more are separated by planes one after another: each plane cuts one part off the
 * remainder, the part whose plane fits best first. If fractions show no direction, children get the
 * fractions of the remainder.
 *
 * Each part keeps its volume to rounding, and no fraction is negative. The result depends only on
 * the fractions of the 27 cells, as far as they are in the domain, so it is equal on every rank.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// Fraction of each child, x fastest.
using ChildFractions = std::vector<double>;

/// Divides a mixed cell among its children.
/// @param fractions  the neighbours of the cell must be in the local box or outside the domain
/// @param cell  position of the cell
/// @param counts  number of children along each axis, >= 1
/// @return one entry per part of the cell, in the order of its parts
std::vector<ChildFractions> SplitCell(const CartesianGrid& grid, const FractionField& fractions,
  const Index3& cell, const Index3& counts);

} // namespace vfm
