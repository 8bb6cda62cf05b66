/**
 * Shapes written as text, one a line (or parted by semicolons):
 *
 *   sphere      radius=0.4 center=0,0,0
 *   ellipsoid   radii=0.4,0.3,0.2 center=0,0,0 rotation=0,0,45
 *   box         size=1,1,0.5 center=0,0,0 rotation=0,0,0
 *   cylinder    radius=0.2 height=1 center=0,0,0 rotation=90,0,0
 *   cone        bottom=0.4 top=0.1 height=1 center=0,0,0 rotation=0,0,0
 *   torus       ring=0.5 tube=0.2 center=0,0,0 rotation=0,0,0
 *   halfspace   point=0,0,0 normal=0,0,1
 *   plate       thickness=0.1 center=0,0,0 normal=1,1,0
 *   gyroid      period=1 level=0 center=0,0,0 rotation=0,0,0
 *   polycrystal grains=20 seed=1
 *
 * Each may have material=1 and any number of cut=x,y,z,nx,ny,nz, which keeps the part of the shape
 * on the side of the plane through (x,y,z) that the normal points away from. Where a center or
 * rotation is left out it is 0, material 1, level 0, seed 1; sizes and normals are needed. A
 * polycrystal takes a material a grain from its material on. What follows # is a comment.
 * Rotations: see Shapes.h.
 */
#pragma once

#include "Shapes/Shapes.h"

#include <string>

namespace vfm
{

/// lower, upper: the domain, where a polycrystal has its seeds. Throws InputError that names line
/// and word.
std::vector<Shape> ParseShapes(const std::string& text, const Vector3& lower, const Vector3& upper);

} // namespace vfm
