/**
 * The solid inside a closed surface of triangles: exact volumes in boxes.
 */
#pragma once

#include "Base/Groups.h"
#include "Shapes/Shapes.h"

namespace vfm
{

/// Corners counter-clockwise seen from outside.
using Triangle = std::array<Vector3, 3>;

/// Triangles sorted into columns along x. A point is inside when its ray to +x leaves the solid
/// once more often than it enters; so the volume in a box is a sum over the triangles beyond it,
/// with no case apart.
class TriangleSolid
{
public:
  /// The triangles must close: what is inside is undefined else.
  explicit TriangleSolid(std::vector<Triangle> triangles);

  /// Whether the bounds of a triangle touch the box.
  bool Meets(const Vector3& lower, const Vector3& upper) const;
  /// Volume of the solid inside the box, to rounding.
  double MeasureVolume(const Vector3& lower, const Vector3& upper) const;
  /// The plane of the mean normal through the centroid of the surface in the box; see
  /// BoxQueries::FitPlane. Has an infinite offset when the solid fills all or nothing of the box.
  double FitPlane(const Vector3& lower, const Vector3& upper, HalfSpace& plane) const;
  /// Volume of the whole solid; negative when the triangles face inwards.
  double MeasureVolume() const;

private:
  struct Bounds
  {
    Vector3 Lower, Upper;
  };
  /// Bins that an interval along y (0) or z (1) overlaps, from first to last.
  template <class Visitor>
  void ForBins(const Bounds& box, const Visitor& visit) const;
  std::array<int, 2> FindBins(int axis, double low, double high) const;
  /// Calls visit(triangle) for triangles whose bounds overlap the box but for its upper x, each
  /// once, until it returns true.
  template <class Visit>
  void VisitColumn(const Vector3& lower, const Vector3& upper, const Visit& visit) const;

  std::vector<Triangle> Triangles;
  std::vector<Bounds> Boxes; // of the triangles
  Bounds All;
  int Bins = 1;        // along y and z
  Groups<int> Members; // triangles by bin
};

/// What a shape made of the solid may know of boxes.
BoxQueries QueriesOf(std::shared_ptr<const TriangleSolid> solid);

} // namespace vfm
