/**
 * ImageFrame: the axes of images with a direction matrix.
 *
 * Such images are meshed in image axes, as if the matrix were the identity. Afterwards the points
 * of the mesh are rotated about an origin. A matrix of determinant -1 inverts elements and facets;
 * the order of their corners is then reversed. All blocks must have the same matrix. Blocks with
 * other origins are shifted along the common axes to their position in space. State arrays that
 * are vectors or tensors in image axes are rotated as well (RotateTuple).
 */
#pragma once

#include "Base/Vector3.h"
#include "Elements/Mesh.h"
#include "Ranks/Ranks.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace vfm
{

/// A point u in image axes has world coordinates Origin + Axes (u - Origin).
struct ImageFrame
{
  std::array<double, 9> Axes{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }; ///< row-major, as in VTK
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };                         ///< centre of the rotation

  bool operator==(const ImageFrame& other) const
  {
    return this->Axes == other.Axes && this->Origin == other.Origin;
  }
  /// Orders by axes, then by origin.
  bool operator<(const ImageFrame& other) const
  {
    return this->Axes != other.Axes ? this->Axes < other.Axes : this->Origin < other.Origin;
  }
  bool IsIdentity() const { return this->Axes == ImageFrame().Axes; }
  /// Returns whether each image axis is parallel to x, y or z, up to rounding.
  bool IsAligned() const;
  bool IsMirrored() const;
  Vector3 ToSpace(const Vector3& own) const;
  Vector3 ToOwn(const Vector3& inSpace) const;
  /// Returns the origin of an image in image axes.
  Vector3 OriginOf(const Vector3& origin) const;
};

/// Makes the frame of an image.
/// @param axes direction matrix, row-major
/// @param name name of the image, for messages
/// @throws InputError if the axes are not orthonormal to 1e-5
ImageFrame MakeImageFrame(
  const std::array<double, 9>& axes, const Vector3& origin, const std::string& name);

/// Returns the common frame of the images of all ranks; the identity if there are no images.
/// @throws InputError if axes differ, on all ranks
/// @pre Collective
ImageFrame AgreeOnFrame(std::vector<ImageFrame> frames, Ranks& ranks);

/// Returns whether RotateTuple rotates tuples of a number of components: 3, 6 or 9.
bool CanRotate(int components);

/// Rotates a vector or tensor from image axes to world coordinates.
/// @param components  3: a vector; 6: a symmetric tensor in the order xx, yy, zz, xy, yz, xz; 9: a
/// tensor, row-major
void RotateTuple(const ImageFrame& frame, int components, double* values);

/// Transforms points, (n, 3), from image axes to world coordinates.
void TurnPoints(const ImageFrame& frame, std::span<double> points);

/// Transforms a mesh from image axes to world coordinates.
void TurnMesh(const ImageFrame& frame, Mesh& mesh);

} // namespace vfm
