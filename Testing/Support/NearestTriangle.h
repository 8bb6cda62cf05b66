/**
 * Distance of points to the nearest of many triangles. It is fast if triangles are about as large
 * as the bins into which they are sorted.
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Vector3.h"

#include <functional>

namespace vfm
{
namespace testing
{

class NearestTriangle
{
public:
  using Corners = std::array<Vector3, 3>;

  /// triangles: not empty; may degenerate to lines or points. binWidth: in the unit of the points.
  explicit NearestTriangle(std::vector<Corners> triangles, double binWidth = 1.0);

  double Distance(const Vector3& x) const;
  /// Returns the triangle of the least badness(triangle, distance), which must not be below the
  /// distance of the triangle from x.
  int Find(const Vector3& x, const std::function<double(int, double)>& badness) const;

private:
  struct Ball
  {
    Vector3 Centre;
    double Radius;
  };
  static Ball BallAround(const Corners& triangle);
  Index3 BinOf(const Vector3& x) const;
  IndexBox BinsOf(const Corners& triangle) const;

  std::vector<Corners> Triangles;
  std::vector<Ball> Balls; // around the triangles
  Vector3 Lower;
  double Width;
  IndexBox Box; // box of all bins
  Groups<int> Members;
};

/// Returns the distance of a point to one triangle.
double DistanceToTriangle(const Vector3& x, const NearestTriangle::Corners& triangle);

} // namespace testing
} // namespace vfm
