/**
 * PolygonTriangles: cuts the polygons of a file into triangles.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

namespace vfm
{

/// Appends the triangles of a polygon, which may be concave. Polygons of fewer than three corners
/// have none.
/// @param corners  numbers of points of the file, checked
void AddPolygon(const std::vector<Index>& corners, int patch, SurfaceFile& file);

} // namespace vfm
