/**
 * SurfaceEdges: the edges of triangles, with all triangles at each edge.
 */
#pragma once

#include "Base/Sorted.h"
#include "Surfaces/PatchTriangles.h"

namespace vfm
{

/// Side of a triangle.
struct TriangleSide
{
  Index Low, High; ///< points
  Index Triangle;
  bool IsForward; ///< the triangle turns from Low to High

  bool Meets(const TriangleSide& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

/// Returns the sides of all triangles. The sides of an edge follow each other, ascending by
/// triangle.
std::vector<TriangleSide> SortSides(const PatchTriangles& surface);

/// Calls visit(first, last) with the range of the sides of each edge.
template <class Visitor>
void ForEdges(const std::vector<TriangleSide>& sides, const Visitor& visit)
{
  ForRuns(
    sides.begin(), sides.end(),
    [](const TriangleSide& a, const TriangleSide& b) { return a.Meets(b); }, visit);
}

/// Returns the sides of edges with an odd number of triangles, each edge once.
std::vector<TriangleSide> FindOddEdges(const std::vector<TriangleSide>& sides);

/// Checks that each edge has an even number of triangles.
/// @throws InputError  if not: with the number and the first place, and a hint if points are close
void CheckEdges(const PatchTriangles& surface, const std::vector<TriangleSide>& sides);

} // namespace vfm
