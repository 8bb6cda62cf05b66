/**
 * BodyOfPolyData: the polygons of a VTK surface as the surface of a body.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"

class vtkPolyData;

namespace vfm
{

/// Returns the body inside the polygons of a surface. Its patches are the values of the first of
/// the cell arrays STLSolidLabeling (STL reader), MaterialIds and GroupIds (OBJ reader) that is
/// there; names of MaterialIds are those in the field array MaterialNames.
/// @throws InputError if MakeBody does: the surface is empty or open
BodySurface MakeBodyOfPolyData(const std::string& name, vtkPolyData* polygons);

} // namespace vfm
