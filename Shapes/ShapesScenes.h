/**
 * Ready scenes of shapes, and shapes that are made of several.
 */
#pragma once

#include "Shapes/Shapes.h"

#include <string>

namespace vfm
{

enum class Scene
{
  Sphere,
  TwoSpheres, ///< with a gap of a twentieth of the domain
  Ellipsoid,
  BallAndPlate, ///< 2 materials
  ThreeSectors, ///< a ball of 3 materials that meet along a line
  Torus,
  Cylinder,   ///< cut by the domain
  HalfSphere, ///< on a side of the domain
  ObliquePlate,
  Gyroid,
  Polycrystal, ///< 20 grains that fill the domain
  EightShapes, ///< 8 materials: one of each of CTH's bodies, some of which touch
  NumberOfScenes
};

/// As people read it, for menus.
std::string GetSceneName(Scene scene);

/// The scene in a domain; sizes follow its shortest edge.
std::vector<Shape> MakeScene(Scene scene, const Vector3& lower, const Vector3& upper);

/// What lies between two parallel planes, half the thickness to either side of the center.
Shape MakePlate(int material, const Vector3& center, const Vector3& normal, double thickness);

/// A ball in equal sectors about the z axis through its center, materials 1..sectors; the first
/// sector begins at an angle (degrees from the x axis). sectors >= 2.
std::vector<Shape> MakeSectors(
  const Vector3& center, double radius, int sectors, double startAngle = 0.0);

/// Voronoi cells of points spread at random, but not too near to each other: materials from
/// firstMaterial on, one a grain. They fill all space; the points lie in the box. The same random
/// seed gives the same grains everywhere. grains >= 1.
std::vector<Shape> MakePolycrystal(int firstMaterial, const Vector3& lower, const Vector3& upper,
  int grains, unsigned int randomSeed = 1);

} // namespace vfm
