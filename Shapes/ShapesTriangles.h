/**
 * ShapesTriangles: exact volumes, in boxes, of the solid inside a closed triangle surface.
 */
#pragma once

#include "Base/Groups.h"
#include "Shapes/Shapes.h"
#include "Surfaces/ClosedSurface.h"

namespace vfm
{

/// Solid whose triangles are sorted into columns along x. A point is inside if its ray to +x
/// leaves the solid once more than it enters. Therefore the volume in a box is a sum over the
/// triangles in and beyond the box, without special cases. The object is constant, so threads may
/// use it at the same time.
class TriangleSolid
{
public:
  /// @param triangles  closed surface; otherwise the results are undefined
  explicit TriangleSolid(std::vector<Triangle> triangles);

  /// Returns whether the bounds of a triangle touch the box.
  bool Meets(const Vector3& lower, const Vector3& upper) const;
  /// Returns the volume of the solid inside the box, exact except for rounding.
  double MeasureVolume(const Vector3& lower, const Vector3& upper) const;
  /// Sets the plane through the centroid of the surface in the box, with its mean normal.
  /// Its offset is infinite if the solid fills all of the box or nothing. Returns the value
  /// of BoxQueries::FitPlane.
  double FitPlane(const Vector3& lower, const Vector3& upper, HalfSpace& plane) const;

private:
  struct Bounds
  {
    Vector3 Lower, Upper;
  };
  template <class Visitor>
  void ForBins(const Bounds& box, const Visitor& visit) const;
  /// Returns the first and the last bin that an interval along y (0) or z (1) overlaps.
  std::array<int, 2> FindBins(int axis, double low, double high) const;
  /// Calls visit(triangle), until it returns true, once for each triangle whose bounds overlap the
  /// box extended to x = infinity.
  template <class Visit>
  void VisitColumn(const Vector3& lower, const Vector3& upper, const Visit& visit) const;

  std::vector<Triangle> Triangles;
  std::vector<Bounds> Boxes; // bounds of the triangles
  Bounds All;
  int Bins = 1;        // number of bins along y and along z
  Groups<int> Members; // triangles by bin
};

/// Returns the functions for a shape that is the solid.
BoxQueries QueriesOf(std::shared_ptr<const TriangleSolid> solid);

/// Returns the solid inside a closed surface as a shape.
/// @param distance  signed distance, negative inside; used only where other shapes cut this one
Shape MakeSolid(
  int material, const ClosedSurface& surface, std::function<double(const Vector3&)> distance);

} // namespace vfm
