/**
 * A plane in place of a curved surface within a box, with an estimate of the volume that it gets
 * wrong.
 */
#pragma once

#include "Shapes/Shapes.h"

namespace vfm
{

struct BoxGeometry
{
  Vector3 Center, Half;

  double Volume() const { return 8.0 * this->Half[0] * this->Half[1] * this->Half[2]; }
  Vector3 Corner(int c) const
  {
    return { { this->Center[0] + (c & 1 ? this->Half[0] : -this->Half[0]),
      this->Center[1] + (c & 2 ? this->Half[1] : -this->Half[1]),
      this->Center[2] + (c & 4 ? this->Half[2] : -this->Half[2]) } };
  }
  /// An eighth.
  BoxGeometry Child(int c) const
  {
    const Vector3 corner = this->Corner(c);
    BoxGeometry child;
    for (int a = 0; a < 3; ++a)
    {
      child.Center[a] = 0.5 * (this->Center[a] + corner[a]);
      child.Half[a] = 0.5 * this->Half[a];
    }
    return child;
  }
};

BoxGeometry MakeBoxGeometry(const Vector3& lower, const Vector3& upper);

/// What a plane gets wrong, as volumes.
struct FitError
{
  double Rim = 0.0;   ///< along the faces of the box
  double Sheet = 0.0; ///< between plane and surface: only their mean height is the same
};

class SurfaceFitter
{
public:
  /// Gives the plane that leaves the same volume behind it in the box as the shape's body, and an
  /// estimate of the error; infinite when the surface is not near any plane.
  ///
  /// The gradient is fitted to the corners. Where the plane cuts the box, the height of the surface
  /// over it, averaged over the polygon of the cut, shifts it to equal volume. What is left is of
  /// second order in the height and arises along the faces of the box.
  FitError Fit(const Shape& shape, const BoxGeometry& box, HalfSpace& plane);

private:
  /// Mean height over the plane of the surface; sets the largest difference from the mean and the
  /// area.
  double MeasureHeight(const Shape& shape, double slope, double& deviation, double& area) const;

  ConvexPiece Inside, Outside;
  std::vector<Vector3> Section;
};

} // namespace vfm
