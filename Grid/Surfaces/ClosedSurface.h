/**
 * ClosedSurface: makes the boundary of a solid from a triangle surface of a file, in which corners
 * are repeated and triangles face both ways.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Base/Vector3.h"

#include <string>
#include <vector>

namespace vfm
{

/// Triangle given by the numbers of its points.
using PointTriangle = std::array<Index, 3>;

/// Closed, consistently oriented surface. Its triangles face outwards; walls of cavities
/// face into the cavities.
struct ClosedSurface
{
  std::vector<Vector3> Points; ///< in ascending order; each is a corner of a triangle
  /// The first corner has the lowest number. Sorted by the numbers of their points.
  std::vector<PointTriangle> Triangles;
};

/// Triangle given by its corners.
using Triangle = std::array<Vector3, 3>;

/// Returns the corners of all triangles.
std::vector<Triangle> PlaceTriangles(const ClosedSurface& surface);

/// Returns the volume inside a closed surface; negative if its triangles face inwards.
double MeasureVolume(const ClosedSurface& surface);

/// Makes a closed surface. The result does not depend on the order of the points, of the triangles
/// and of their corners. Each repair is reported in the note:
/// - Points of open edges that are within 1e-6 of the diagonal are merged.
/// - Triangles with two equal corners, and repeated triangles, are dropped; pairs of triangles back
///   to back too, because they are a wall inside of the solid.
/// - An open edge with corners of other triangles on it is divided there.
/// - Triangles are turned so that the components of the surface, without others around them, face
///   outwards. Components inside an odd number of others are the walls of cavities, and face
///   inwards, whatever their turn in the input. Around an edge of 4, 6 or more triangles, inside
///   and outside alternate.
/// @param points  coordinates
/// @param triangles  points of each triangle, from 0
/// @param patches  patch of each triangle; receives the patches of the result; or null
/// @param note  receives a text about the repairs, empty if there are none; or null
/// @throws InputError  if a triangle refers to a point that does not exist, the magnitude of a
///   coordinate is not finite or above 1e60, or the surface is empty, open, not manifold, or has
///   only one side; the message names the first place
ClosedSurface CloseSurface(std::vector<Vector3> points, std::vector<PointTriangle> triangles,
  std::vector<int>* patches = nullptr, std::string* note = nullptr);

} // namespace vfm
