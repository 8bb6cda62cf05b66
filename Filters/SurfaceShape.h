/**
 * SurfaceShape: the solid inside a closed surface as a shape.
 */
#pragma once

#include "Shapes/Shapes.h"

class vtkPolyData;

namespace vfm
{

/// Returns the solid inside the polygons of a surface.
/// @throws InputError if CloseSurface does: the surface is empty, open or not manifold
Shape MakeSurfaceShape(int material, vtkPolyData* polygons);

} // namespace vfm
