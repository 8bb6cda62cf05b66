/**
 * JoinCopies: a mesh of a periodic domain in which each point exists once.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Joins the copies of points on opposite sides: each point gets the id that PeriodicPartner names,
/// and the position of the copy with the lowest id. Elements at the sides then have corners on
/// both. Empties PeriodicPartner.
/// @return the points that remain, in their new order
/// @pre Collective.
std::vector<Index> JoinCopies(Runtime& runtime, Mesh& mesh);

} // namespace vfm
