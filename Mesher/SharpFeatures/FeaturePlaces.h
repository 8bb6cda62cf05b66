/**
 * FeaturePlaces: feet on the surfaces of a sharp-feature model, points of its edges, its corner.
 * All points are in the local frame of the model, in cells.
 */
#pragma once

#include "SharpFeatures/FeatureModel.h"

#include <optional>

namespace vfm
{

/// Returns whether the second label ends at a point at each of the surfaces of a mask.
/// @param mask  bits of surfaces on which y lies
bool IsBoundary(const FeatureModel& model, int mask, const Vector3& y);

/// Foot of a point on a surface of a model.
struct SidePlace
{
  int Surface;
  Vector3 Foot;
  Vector3 Normal;  ///< unit, at the foot
  double Distance; ///< distance to y
};
/// Returns the nearest foot from y that bounds the second label. If no foot bounds it,
/// returns the nearest foot.
SidePlace FindSide(const FeatureModel& model, const Vector3& y);

/// Returns the bluntness of an edge where surfaces with two unit normals meet. It is 1 for right
/// and obtuse angles, less for acute angles on one side, and 0 where both surfaces coincide.
inline double BluntnessOf(const Vector3& a, const Vector3& b)
{
  return std::min(1.0, std::sqrt(std::max(0.0, 1.0 + Dot(a, b))));
}

/// Point of an edge that bounds the second label.
struct EdgePlace
{
  std::array<int, 2> Surfaces;
  Vector3 Point;
  double Distance;                ///< distance to y
  std::array<Vector3, 2> Normals; ///< unit, of the surfaces there
};
/// Returns the point nearest to y on an edge that bounds the second label, or nothing if the model
/// has no such edge.
std::optional<EdgePlace> FindEdge(const FeatureModel& model, const Vector3& y);

/// Point where three surfaces meet.
struct CornerPlace
{
  Vector3 Point;
  double Distance;  ///< distance to y
  double Bluntness; ///< bluntness of its sharpest edge
};
/// Returns the corner of a model of three surfaces if it lies within 4 cells of y.
std::optional<CornerPlace> FindCorner(const FeatureModel& model, const Vector3& y);

} // namespace vfm
