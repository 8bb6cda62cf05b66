/**
 * ShapesScenes: example scenes, and solids that consist of several shapes.
 */
#pragma once

#include "Shapes/Shapes.h"

#include <string>

namespace vfm
{

/// Example scene.
enum class Scene
{
  Sphere,
  TwoSpheres, ///< their gap is a twentieth of the domain
  Ellipsoid,
  BallAndPlate, ///< 2 materials
  ThreeSectors, ///< a ball of 3 materials that meet along a line
  Torus,
  Cylinder,   ///< cut by the domain
  HalfSphere, ///< lies on a side of the domain
  ObliquePlate,
  Gyroid,
  Polycrystal, ///< 20 grains that fill the domain
  EightShapes, ///< 8 materials: each kind of body of CTH once; some bodies touch
  NumberOfScenes
};

/// Returns the name of a scene for menus.
std::string GetSceneName(Scene scene);

/// Makes a scene in a domain. Sizes are proportional to the shortest edge of the domain.
std::vector<Shape> MakeScene(Scene scene, const Vector3& lower, const Vector3& upper);

/// Makes the plate between two parallel planes, each at half the thickness from the center.
Shape MakePlate(int material, const Vector3& center, const Vector3& normal, double thickness);

/// Makes a ball divided into equal sectors about the z axis through its center.
/// @param sectors  number of sectors, at least 2; sector n is material n, from 1
/// @param startAngle  begin of the first sector, degrees from the x axis
std::vector<Shape> MakeSectors(
  const Vector3& center, double radius, int sectors, double startAngle = 0.0);

/// Makes a polycrystal of Voronoi cells, which fill all space. Their seeds are random points of the
/// box that are not too close to each other.
/// @param firstMaterial  material of the first grain; each grain has its own material
/// @param grains  number of grains, at least 1
/// @param randomSeed  equal seeds produce equal grains on every machine
std::vector<Shape> MakePolycrystal(int firstMaterial, const Vector3& lower, const Vector3& upper,
  int grains, unsigned int randomSeed = 1);

} // namespace vfm
