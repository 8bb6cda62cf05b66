/**
 * ImagePlace: size, origin, spacing and axes of an image, and checks of them.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <string>

namespace vfm
{

/// Place of the values of an image in the coordinates of the file.
struct ImagePlace
{
  Index3 Size{}; ///< number of values along each axis of the image
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  Vector3 Spacing{ { 1.0, 1.0, 1.0 } };
  /// Directions of the axes, orthonormal; they may be left-handed.
  std::array<Vector3, 3> Axes{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
};

/// Tests whether the three axes are at right angles, up to a cosine of 1e-4, and longer than 0.
/// @param steps  vector from one value to the next along each axis
bool AreAtRightAngles(const std::array<Vector3, 3>& steps);

/// Sets spacing and axes. The second and third axis are made exactly orthogonal (Gram-Schmidt).
/// @param steps  vector from one value to the next along each axis; AreAtRightAngles
void SetSteps(const std::array<Vector3, 3>& steps, ImagePlace& place);

/// Converts a size that a header contains; returns 0, which CheckPlace rejects, if it is not an
/// integer from 0 to the range of int.
Index ToSize(double value);

/// Checks the numbers of an image's place.
/// @throws InputError  if a size is below 1 or exceeds int, if there are too many values
///   (CountCells), if a spacing is not above 0, or if a number is not finite
void CheckPlace(const ImagePlace& place);

/// Checks that a file is long enough for its values. For compressed values, a compression ratio of
/// 5000 is assumed to be possible, and any ratio if the input is trusted.
/// @param offset  place of the first value in the file, bytes
/// @param bytes  size of the values, uncompressed
/// @throws InputError  if the file is too short or not a regular file
void CheckLength(const std::string& path, Index offset, Index bytes, bool areCompressed);

} // namespace vfm
