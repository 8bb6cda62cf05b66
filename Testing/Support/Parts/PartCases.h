/**
 * Parts with named patches, as exported by CAD programs, for tests.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"

namespace vfm
{
namespace testing
{

/// Returns a body moved and turned by an angle of about 37 degrees about z, then 23 about x.
BodySurface Turned(BodySurface body, const Vector3& shift);

/// Returns a body without names of patches.
BodySurface WithoutPatches(BodySurface body);

/// Returns an angle section along z. Patches: base, end, step, inside, top, back, low, high.
/// @param length  of both legs
BodySurface BracketBody(const std::string& name, double length, double thickness, double width);

/// Returns a plate with round holes through it, in tiles of equal size. Patches: bottom, top,
/// outside, and hole_1, hole_2, .. of each tile, x fastest.
/// @param segments  flat parts of a hole, a multiple of 8
BodySurface PlateBody(const std::string& name, Index tilesX, Index tilesY, double tile,
  double radius, double thickness, int segments);

/// Returns a slice of a cylinder along z: an arc of a third of a circle. Patches: low, high, arc,
/// first, last.
BodySurface SliceBody(const std::string& name, double radius, double height, int segments);

/// Returns the area of each patch.
std::vector<double> AreasOfPatches(const BodySurface& body);

} // namespace testing
} // namespace vfm
