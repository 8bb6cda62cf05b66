/**
 * The direction that sees all faces at a node: d with n.d > 0 for all their unit normals n, and the smallest n.d as large as can be.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

struct VisibleDirection
{
  Vector3 Direction; ///< unit
  double Margin;     ///< the smallest n.d; not positive: nothing sees all of them
};

/// normals: unit vectors, at least one. The direction is that of the point of their convex hull nearest to 0 (Gilbert 1966).
VisibleDirection FindVisibleDirection(const std::vector<Vector3>& normals);

} // namespace vfm
