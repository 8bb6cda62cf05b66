/**
 * PeriodImages: images of points in a periodic domain, whole periods apart.
 */
#pragma once

#include "Input/ImageFrame.h"
#include "Report/MeshFields.h"

namespace vfm
{

/// Images of points. In axes of the image (ImageFrame) periods are along x, y and z.
class PeriodImages
{
public:
  /// @param fields  ListDomain of the mesh; without PeriodLengths no point has images
  /// @param hasCopies  points on opposite sides are different points of the mesh, so elements need
  ///   no images of their points
  PeriodImages(const FieldArrays& fields, bool hasCopies);

  /// Returns the coordinates in axes of the image.
  Vector3 ToOwn(const Vector3& x) const;
  /// Returns the image of a point, in axes of the image, that is nearest to a point in space.
  Vector3 ImageOf(const Vector3& own, const Vector3& nearTo) const;
  /// Returns the image of a point that is nearest to another one, or the point itself if elements
  /// need no images.
  Vector3 Near(const Vector3& x, const Vector3& nearTo) const
  {
    return this->HasCopies ? x : this->ImageOf(this->ToOwn(x), nearTo);
  }

private:
  Vector3 Lengths; // 0: not periodic
  ImageFrame Frame;
  bool HasCopies;
};

} // namespace vfm
