/**
 * VisibleDirection: the direction from which all faces at a node are visible.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Result of FindVisibleDirection.
struct VisibleDirection
{
  Vector3 Direction; ///< unit vector
  /// Smallest n.d of all normals n; no direction sees all faces unless it is positive.
  double Margin;
};

/// Finds the direction d that maximises the smallest n.d of all normals n: the direction of the
/// point nearest to 0 in the convex hull of the normals. After E. G. Gilbert, SIAM J. Control 4
/// (1966) 61-80.
/// @param normals  unit vectors, at least one
VisibleDirection FindVisibleDirection(const std::vector<Vector3>& normals);

} // namespace vfm
