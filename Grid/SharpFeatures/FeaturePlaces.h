/**
 * Places on a crease model: feet on its surfaces, points of its edges, its corner.
 */
#pragma once

#include "SharpFeatures/FeatureModel.h"

#include <optional>

namespace vfm
{

/// Whether the second label ends at y, which lies on the surfaces of a mask, at all of these.
bool IsBoundary(const FeatureModel& model, int mask, const Vector3& y);

/// The nearest surface whose foot from y bounds the second label; where none does, the nearest of all.
struct SidePlace
{
  int Surface;
  Vector3 Foot;
  Vector3 Normal;  ///< unit, there
  double Distance; ///< from y
};
SidePlace FindSide(const FeatureModel& model, const Vector3& y);

/// How blunt an edge is where two surfaces with such unit normals meet: 1 where the angle between them is right or obtuse, less where it is
/// acute on one side, and 0 where both fall together.
inline double BluntnessOf(const Vector3& a, const Vector3& b)
{
  return std::min(1.0, std::sqrt(std::max(0.0, 1.0 + Dot(a, b))));
}

/// The point nearest to y of an edge that bounds the second label.
struct EdgePlace
{
  std::array<int, 2> Surfaces;
  Vector3 Point;
  double Distance;                ///< from y
  std::array<Vector3, 2> Normals; ///< unit, of the surfaces there
};
std::optional<EdgePlace> FindEdge(const FeatureModel& model, const Vector3& y);

/// Where three surfaces meet, within 4 cells of y.
struct CornerPlace
{
  Vector3 Point;
  double Distance;  ///< from y
  double Bluntness; ///< of its sharpest edge
};
std::optional<CornerPlace> FindCorner(const FeatureModel& model, const Vector3& y);

} // namespace vfm
