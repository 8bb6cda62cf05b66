/**
 * BodyOfPolyData: the polygons of a VTK surface as the surface of a body.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"

class vtkPolyData;

namespace vfm
{

/// Returns the body inside the polygons of a surface, as one patch.
/// @throws InputError if MakeBody does: the surface is empty, open or not manifold
BodySurface MakeBodyOfPolyData(const std::string& name, vtkPolyData* polygons);

} // namespace vfm
