/**
 * BoxCut: the part of the unit cube centred at 0 on the inner side of up to three planes, and how it changes with each.
 */
#pragma once

#include "Base/Vector3.h"

#include <array>

namespace vfm
{

/// Inside: Normal . x + Height >= 0. The normal need not be a unit vector; not zero.
struct BoxPlane
{
  Vector3 Normal;
  double Height;
};

/// What a plane's part of the boundary does to a volume: its area and first moments over |Normal|.
struct PlaneRates
{
  double ByHeight;  ///< dVolume / dHeight
  Vector3 ByNormal; ///< dVolume / dNormal
};

/// Largest |Normal . x| in the cube.
inline double ReachOf(const BoxPlane& plane)
{
  return 0.5 *
    (std::fabs(plane.Normal[0]) + std::fabs(plane.Normal[1]) + std::fabs(plane.Normal[2]));
}

/// Volume inside of a plane that cuts the cube. Closed: the section, seen along the largest component of the normal, is what two parallel
/// lines leave of a square.
double CutBox(const BoxPlane& plane, PlaneRates& rates);

/// Volume inside of all planes of a mask, two or more; their sections and three faces of the cube are clipped.
double CutBox(const std::array<BoxPlane, 3>& planes, int mask, std::array<PlaneRates, 3>& rates);

} // namespace vfm
