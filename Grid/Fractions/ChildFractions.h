/**
 * The fractions of a mixed cell in its children, by planes: equal boxes, so many along each axis.
 *
 * Two parts: the plane, or where that fits badly the film between two parallel planes, nearest to the fractions of the
 * cell and its 26 neighbours. Where neither fits (edges, corners, rods, small balls) the part that a field, linear between
 * the middles of cells, makes with a value for which the volume is right (SharpFractions.h): that keeps thin things in
 * one piece. Three parts or more: planes one after another, each of which cuts a part off what the ones before it left; the
 * part whose plane fits best goes first; where fractions show no direction the children get those of the cell.
 * Each part keeps its volume to rounding, and no fraction is negative.
 *
 * The result depends on the fractions of the 27 cells alone, those outside the domain left out: it is the same on any rank.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// A fraction of each child, x fastest.
using ChildFractions = std::vector<double>;

/// Of the parts of a mixed cell, in their order; counts: of the children along each axis, >= 1. The neighbours of the cell must
/// be in the local box or outside the domain.
std::vector<ChildFractions> SplitCell(const CartesianGrid& grid, const FractionField& fractions,
  const Index3& cell, const Index3& counts);

} // namespace vfm
