/**
 * SurfaceSheets: the parts of a closed surface between its sharp edges, and these edges.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

#include <array>
#include <vector>

namespace vfm
{

/// Edge of a surface across which the normals differ by more than an angle.
struct SharpEdge
{
  std::array<Index, 2> Points;    ///< the lower number first
  std::array<Index, 2> Triangles; ///< the first one runs from Points[0] to Points[1]
  bool IsConvex;                  ///< the solid fills less than 180 degrees around the edge
};

/// Point where sharp edges of three or more sheets meet.
struct SharpCorner
{
  Index Point;
  std::vector<int> Sheets; ///< ascending
};

/// Parts of a surface between its sharp edges.
struct SurfaceSheets
{
  std::vector<Vector3> Normals;     ///< unit normal of each triangle
  std::vector<int> SheetOf;         ///< sheet of each triangle, from 0 by the lowest triangle
  std::vector<SharpEdge> Edges;     ///< ascending by points
  std::vector<SharpCorner> Corners; ///< ascending by points
};

/// Finds the sharp edges of a surface, and the sheets: the components of triangles joined across
/// all other edges. An edge that ends inside a sheet has that sheet on both sides.
///
/// Needles, triangles whose height is below 1e-5 of the size of the surface, have no normal of
/// their own. They get that of a triangle beyond their longest edges, and belong to its sheet.
/// Around an edge of four or more triangles, those that bound the same part of the solid are
/// neighbours.
/// @param angleDegrees  least angle between the normals of both triangles at a sharp edge
SurfaceSheets FindSheets(const ClosedSurface& surface, double angleDegrees);

} // namespace vfm
