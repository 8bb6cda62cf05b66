/**
 * ImageFrame: the axes of images with a direction matrix.
 *
 * Such images are meshed in their own axes, as if their matrix were the identity; then the points of the mesh are turned about an origin.
 * A matrix that mirrors (determinant -1) turns elements and facets inside out: they get the order of their corners reversed.
 * All blocks have one matrix. Blocks with other origins are moved along the common axes, so that they stand where they do in space.
 */
#pragma once

#include "Base/Vector3.h"
#include "Mesh/Mesh.h"
#include "Ranks/Ranks.h"

#include <array>
#include <string>
#include <vector>

namespace vfm
{

struct ImageFrame
{
  std::array<double, 9> Axes{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }; ///< row by row, as VTK's
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };                         ///< stays in its place

  bool operator==(const ImageFrame& other) const
  {
    return this->Axes == other.Axes && this->Origin == other.Origin;
  }
  /// By axes first.
  bool operator<(const ImageFrame& other) const
  {
    return this->Axes != other.Axes ? this->Axes < other.Axes : this->Origin < other.Origin;
  }
  bool IsIdentity() const { return this->Axes == ImageFrame().Axes; }
  /// Whether each axis of the images lies along one of space, but for rounding.
  bool IsAligned() const;
  bool IsMirrored() const;
  Vector3 ToSpace(const Vector3& own) const;
  Vector3 ToOwn(const Vector3& inSpace) const;
  /// Where the axes of an image with an origin begin.
  Vector3 OriginOf(const Vector3& origin) const;
};

/// Of an image. axes: its direction matrix, row by row; name: of the image, for messages. Throws InputError when they are not orthonormal.
ImageFrame MakeImageFrame(
  const std::array<double, 9>& axes, const Vector3& origin, const std::string& name);

/// Collective: that of the images of all ranks; of none the identity. Throws InputError, on all ranks alike, where axes differ.
ImageFrame AgreeOnFrame(std::vector<ImageFrame> frames, Ranks& ranks);

/// From the images' own axes to space.
void TurnMesh(const ImageFrame& frame, Mesh& mesh);

} // namespace vfm
