/**
 * PlaceSurfaces: the surfaces of a run in coordinates of a grid.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "Phases/MesherInput.h"

#include <memory>

namespace vfm
{

/// Returns the surfaces of the fractions in grid coordinates; null if there are none, or if the
/// option UseSurfaces is off.
std::unique_ptr<const BodySurfaces> PlaceSurfaces(const MesherJob& job, const CartesianGrid& grid);

} // namespace vfm
