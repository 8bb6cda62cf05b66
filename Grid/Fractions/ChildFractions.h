/**
 * The fractions of a mixed cell in the eight halves along each axis (octants) of it, by planes.
 *
 * Two parts: the plane, or where that fits badly the film between two parallel planes, nearest to the fractions of the
 * cell and its 26 neighbours. Where neither fits (edges, corners, rods, small balls) the part that a field, linear between
 * the middles of cells, makes with a value for which the volume is right (SharpFractions.h): that keeps thin things in
 * one piece. Three parts or more: planes one after another, each of which cuts a part off what the ones before it left; the
 * part whose plane fits best goes first; where fractions show no direction the octants get those of the cell.
 * Each part keeps its volume to rounding, and no fraction is negative.
 *
 * The result depends on the fractions of the 27 cells alone, those outside the domain left out: it is the same on any rank.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// A fraction of each octant: bit a of the number is set on the + side of axis a.
using OctantFractions = std::array<double, 8>;

/// Of the parts of a mixed cell, in their order. The neighbours of the cell must be in the local box or outside the domain.
std::vector<OctantFractions> SplitCell(
  const CartesianGrid& grid, const FractionField& fractions, const Index3& cell);

} // namespace vfm
