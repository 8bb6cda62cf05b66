/**
 * ShapesText: shapes from text, with one shape per line or separated by semicolons:
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
 * Each shape may have material=1 and any number of cut=x,y,z,nx,ny,nz. A cut keeps the part of the
 * shape behind the plane through (x,y,z), opposite to its normal. Defaults: center and rotation 0,
 * material 1, level 0, grains 20, seed 1. Sizes and normals are required. Each grain of a
 * polycrystal has its own material, starting with the material of the polycrystal. Text after # is
 * a comment. Shapes.h explains rotations.
 */
#pragma once

#include "Shapes/Shapes.h"

#include <string>

namespace vfm
{

/// Makes shapes from text.
/// @param lower,upper  domain, which contains the seeds of polycrystals
/// @throws InputError  names the line and the wrong parameter
std::vector<Shape> ParseShapes(const std::string& text, const Vector3& lower, const Vector3& upper);

} // namespace vfm
