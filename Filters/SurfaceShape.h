/**
 * A closed triangle surface as a shape of Grid.
 */
#pragma once

#include "Shapes/Shapes.h"

class vtkPolyData;

namespace vfm
{

/// The solid inside the polygons of a surface, made closed by CloseSurface, whose errors it throws.
Shape MakeSurfaceShape(int material, vtkPolyData* polygons);

} // namespace vfm
