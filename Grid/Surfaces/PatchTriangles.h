/**
 * PatchTriangles: triangles with their patches in an order that does not depend on that of the
 * input.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

namespace vfm
{

/// Triangle of a patch.
struct PatchTriangle
{
  PointTriangle Corners;
  int Patch = 0;

  /// Returns the corners in ascending order.
  PointTriangle Sorted() const;
  bool HasSameCorners(const PatchTriangle& other) const { return this->Sorted() == other.Sorted(); }
  /// Exchanges two corners, not the first one.
  void Turn() { std::swap(this->Corners[1], this->Corners[2]); }
};

/// Triangles with the points that they use.
struct PatchTriangles
{
  std::vector<Vector3> Points; ///< ascending, all different
  /// The first corner is the lowest. Sorted by their corners in ascending order, so that triangles
  /// with the same corners follow each other, then by turn and patch.
  std::vector<PatchTriangle> Triangles;
};

/// Merges equal points, drops points that no triangle uses and triangles with two equal corners,
/// and sorts. Only points of triangles are compared, because others need not be finite.
PatchTriangles SortTriangles(
  const std::vector<Vector3>& points, std::vector<PatchTriangle> triangles);

/// Returns coordinates in six digits, as (0, 0.5, 1), for messages.
std::string FormatPlace(const Vector3& point);

} // namespace vfm
