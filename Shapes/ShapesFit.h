/**
 * ShapesFit: approximates a curved surface in a box by a plane and estimates the
 * error of the volume.
 */
#pragma once

#include "Shapes/Shapes.h"

namespace vfm
{

/// Box given by its center and half edges.
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
  /// Returns eighth c of the box.
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

/// Error of a plane, as volumes.
struct FitError
{
  double Rim = 0.0; ///< error along the faces of the box
  /// Volume between plane and surface, of which only the mean heights are equal.
  double Sheet = 0.0;
};

/// Fit of planes. It keeps memory between calls; use one object per thread.
class SurfaceFitter
{
public:
  /// Finds the plane with the same volume behind it in the box as the shape's body.
  ///
  /// The gradient is fitted to the corners. If the plane cuts the box, it is shifted by the mean
  /// height of the surface over the polygon of the cut, which makes the volumes equal. The
  /// remaining error is of second order in the height and arises along the faces of the box.
  /// @return estimate of the error; infinite if the surface is not close to any plane
  FitError Fit(const Shape& shape, const BoxGeometry& box, HalfSpace& plane);

private:
  /// Returns the mean height of the surface over the plane.
  /// @param[out] deviation  largest deviation from the mean, at least the magnitude of the mean
  /// @param[out] area  area of the polygon of the cut
  double MeasureHeight(const Shape& shape, double slope, double& deviation, double& area) const;

  ConvexPiece Inside, Outside;
  std::vector<Vector3> Section;
};

} // namespace vfm
