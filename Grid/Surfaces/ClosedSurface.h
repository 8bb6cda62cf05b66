/**
 * ClosedSurface: makes the boundary of a solid from a triangle surface of a file, in which corners
 * are repeated and triangles face both ways.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Base/Vector3.h"

#include <vector>

namespace vfm
{

/// Triangle given by the numbers of its points.
using PointTriangle = std::array<Index, 3>;

/// Closed, consistently oriented surface. Its triangles face outwards; walls of cavities
/// face into the cavities.
struct ClosedSurface
{
  /// Points of the input. If several are at one place, only the first is used.
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
};

/// Triangle given by its corners.
using Triangle = std::array<Vector3, 3>;

/// Returns the corners of all triangles.
std::vector<Triangle> PlaceTriangles(const ClosedSurface& surface);

/// Returns the volume inside a closed surface; negative if its triangles face inwards.
double MeasureVolume(const ClosedSurface& surface);

/// Makes a closed surface. Merges points at the same place and removes triangles with two equal
/// corners. Orients the triangles of each connected component like its first one. If the total
/// volume is then negative, reverses all triangles. Therefore the walls of a cavity must face
/// opposite to the outer wall in the input.
/// @param points  coordinates
/// @param triangles  points of each triangle, from 0
/// @throws InputError  if a triangle refers to a point that does not exist, the magnitude of a
///   coordinate is not finite or above 1e60, or the surface is empty, open or not manifold
ClosedSurface CloseSurface(std::vector<Vector3> points, std::vector<PointTriangle> triangles);

} // namespace vfm
