/**
 * Places on a crease model: feet on its surfaces, points of its edges, its corner.
 */
#pragma once

#include "Creases/CreaseModel.h"

#include <optional>

namespace vfm
{

/// Whether the second label ends at y, which lies on the surfaces of a mask, at all of these.
bool IsBoundary(const CreaseModel& model, int mask, const Vector3& y);

/// The nearest surface whose foot from y bounds the second label; where none does, the nearest of all.
struct SidePlace
{
  int Surface;
  Vector3 Foot;
  Vector3 Normal;  ///< unit, there
  double Distance; ///< from y
};
SidePlace FindSide(const CreaseModel& model, const Vector3& y);

/// The point nearest to y of an edge that bounds the second label.
struct EdgePlace
{
  std::array<int, 2> Surfaces;
  Vector3 Point;
  double Distance; ///< from y
};
std::optional<EdgePlace> FindEdge(const CreaseModel& model, const Vector3& y);

/// Where three surfaces meet, within 3 cells of y.
std::optional<Vector3> FindCorner(const CreaseModel& model, const Vector3& y);

} // namespace vfm
