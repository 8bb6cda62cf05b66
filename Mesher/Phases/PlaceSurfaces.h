/**
 * PlaceSurfaces: the surfaces of a run that fit its fractions, in coordinates of a grid.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "Phases/ReadCells.h"

#include <memory>

namespace vfm
{

/// Sets Cells::Surfaces to the surfaces of the input whose exact fractions are those of the cells
/// (FindMatches); warns of the other ones. None if the option UseSurfaces is off.
/// @pre Collective.
void MatchSurfaces(const MesherJob& job, Cells& cells);

/// Returns Cells::Surfaces in coordinates of the finest grid; null if there are none.
std::unique_ptr<const BodySurfaces> PlaceSurfaces(const MesherJob& job, const Cells& cells);

} // namespace vfm
