/**
 * ImagePlace: where the values of an image lie.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <string>

namespace vfm
{

struct ImagePlace
{
  Index3 Size{}; ///< values along each axis of the image
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  Vector3 Spacing{ { 1.0, 1.0, 1.0 } };
  /// Unit vectors at right angles, in the file's coordinates; the third may point either way.
  std::array<Vector3, 3> Axes{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
};

/// Whether steps from value to value along the three axes are at right angles, to a ten-thousandth, and none is 0.
bool AreAtRightAngles(const std::array<Vector3, 3>& steps);

/// Spacing and axes from steps at right angles; what is left of others after rounding is taken from the second and third.
void SetSteps(const std::array<Vector3, 3>& steps, ImagePlace& place);

/// The size that a header tells; 0, which CheckPlace refuses, of one that no image can have.
Index ToSize(double told);

/// Throws InputError on a size below 1 or beyond int, a spacing not above 0, numbers that are not finite.
void CheckPlace(const ImagePlace& place);

/// Throws InputError when the file at path ends before values of that many bytes, which begin at offset; of compressed ones, when it is
/// so short that it could not hold them.
void CheckLength(const std::string& path, double offset, double bytes, bool areCompressed);

} // namespace vfm
