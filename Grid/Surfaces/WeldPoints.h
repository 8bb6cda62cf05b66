/**
 * WeldPoints: merges points that are close to each other.
 */
#pragma once

#include "Surfaces/SurfaceEdges.h"

#include <functional>

namespace vfm
{

/// Returns the diagonal of the box around points.
double FindDiagonal(const std::vector<Vector3>& points);

/// Returns the points at the ends of edges, ascending.
std::vector<Index> EndsOf(const std::vector<TriangleSide>& edges);

/// Calls visit(a, b) for pairs of some points that are at most `distance` apart, with a before b.
/// Among more than 256 points close together, not all pairs are visited.
/// @param chosen  numbers of points, ascending
void ForClosePairs(const std::vector<Vector3>& points, const std::vector<Index>& chosen,
  double distance, const std::function<void(Index, Index)>& visit);

/// Merges the points of open edges that are at most `distance` apart, also by way of other points.
/// The lowest one remains. The order of the triangles is not kept.
/// @return number of points that were merged into others
Index WeldPoints(double distance, const std::vector<TriangleSide>& open, PatchTriangles& surface);

} // namespace vfm
