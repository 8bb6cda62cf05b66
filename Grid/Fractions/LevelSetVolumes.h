/**
 * LevelSetVolumes: volumes of materials in a box, from functions that are negative inside their
 * materials and linear in the six tetrahedra around a diagonal of the box.
 *
 * A tetrahedron is cut along the plane where a function, or the difference of two, is zero; the
 * parts are tetrahedra again. Volumes of parts are products of shares of edges, so a plane in any
 * position gives its volume to rounding.
 */
#pragma once

#include "Fractions/LevelSetRule.h"

#include <array>
#include <vector>

namespace vfm
{

/// Values of a function at the corners of a box.
using CornerValues = std::array<double, 8>;

/// Adds the volumes of void (0) and of the materials (1, 2, ..) in a box.
/// @param functions  corner values of the function of each material
/// @param volume  of the box
/// @param[in,out] volumes  one per function, and before them that of void
void AddVolumesInBox(const std::vector<CornerValues>& functions, LevelSetRule rule, double volume,
  std::vector<double>& volumes);

} // namespace vfm
