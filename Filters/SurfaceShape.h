/**
 * A closed triangle surface as a shape of Grid.
 */
#pragma once

#include "Shapes/Shapes.h"

class vtkPolyData;

namespace vfm
{

/// The solid inside the surface. Coincident points are merged first, and the polygons of each piece
/// made to face one way; when the volume inside is negative then, all are turned. The wall of a
/// cavity must face the other way than the outer wall. Throws InputError when the surface is empty,
/// open or not manifold.
Shape MakeSurfaceShape(int material, vtkPolyData* surface);

} // namespace vfm
