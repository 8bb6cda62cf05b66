/**
 * Shapes: solids as implicit functions, from which exact volume fractions are computed.
 *
 * Lengths are in length units of the grid. Rotations are Euler angles in degrees about x, y, z, in
 * the order of vtkProp3D: the matrix Rz Rx Ry is applied before the translation to the center. The
 * axis of cylinder, cone and torus is the local z axis. The functions that make shapes throw
 * InputError if a size is not positive, a number is not finite, or a material is below 1.
 */
#pragma once

#include "Base/ConvexClip.h"

#include <functional>
#include <memory>
#include <vector>

namespace vfm
{

/// Kind of a shape, and meaning of Shape::Size.
enum class ShapeKind
{
  Sphere,    ///< Size: radius
  Ellipsoid, ///< Size: three radii
  Box,       ///< Size: half edges
  Cylinder,  ///< Size: radius, half height
  Cone,      ///< Size: radius at the bottom, at the top, half height
  Torus,     ///< Size: radius of the ring, of the tube
  HalfSpace,
  Gyroid, ///< Size: wave number, level
  VoronoiCell,
  Function
};

/// Intersection of at most one curved body with any number of half-spaces. Functions of shapes are
/// negative inside. The function of the body has the Lipschitz constant 1: a single value can show
/// that a whole box is on one side. The functions below make shapes.
struct Shape
{
  ShapeKind Kind = ShapeKind::Sphere;
  int Material = 1;
  Vector3 Center{ { 0, 0, 0 } };
  std::array<Vector3, 3> Axes{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  Vector3 Size{ { 0, 0, 0 } };
  std::vector<HalfSpace> Planes;                     ///< faces of the kind of shape, then the cuts
  std::size_t OwnPlanes = 0;                         ///< number of faces in Planes
  std::shared_ptr<const std::vector<Vector3>> Seeds; ///< seeds of the Voronoi diagram
  std::size_t Seed = 0;                              ///< seed of this Voronoi cell
  std::function<double(const Vector3&)> Distance;    ///< only for ShapeKind::Function
};

/// Makes a sphere.
Shape MakeSphere(int material, const Vector3& center, double radius);
/// Makes an ellipsoid with its radii along the rotated axes.
Shape MakeEllipsoid(int material, const Vector3& center, const Vector3& radii,
  const Vector3& rotation = { { 0, 0, 0 } });
/// Makes a box with full edge lengths along the rotated axes.
Shape MakeBox(int material, const Vector3& center, const Vector3& edges,
  const Vector3& rotation = { { 0, 0, 0 } });
/// Makes a cylinder, centered halfway between bottom and top.
Shape MakeCylinder(int material, const Vector3& center, double radius, double height,
  const Vector3& rotation = { { 0, 0, 0 } });
/// Makes a cone or frustum. One of the radii may be 0. The center is halfway
/// between bottom and top.
Shape MakeCone(int material, const Vector3& center, double bottomRadius, double topRadius,
  double height, const Vector3& rotation = { { 0, 0, 0 } });
/// Makes a torus with tubeRadius <= ringRadius.
Shape MakeTorus(int material, const Vector3& center, double ringRadius, double tubeRadius,
  const Vector3& rotation = { { 0, 0, 0 } });
/// Makes the half-space behind a plane, opposite to its normal. The normal may have any length.
Shape MakeHalfSpace(int material, const Vector3& point, const Vector3& normal);
/// Makes the solid sin x cos y + sin y cos z + sin z cos x < level, with 2 pi scaled to the period.
/// @param level  |level| < 1.5
Shape MakeGyroid(int material, const Vector3& center, double period, double level = 0.0,
  const Vector3& rotation = { { 0, 0, 0 } });
/// Makes the cell of points nearer to seeds[seed] than to any other seed.
Shape MakeVoronoiCell(
  int material, std::shared_ptr<const std::vector<Vector3>> seeds, std::size_t seed);
/// Makes a shape from a function. Several threads may call it at once.
/// @param distance  signed distance, negative inside, with Lipschitz constant 1
Shape MakeFunctionShape(int material, std::function<double(const Vector3&)> distance);
/// Returns the part of a shape behind a plane, opposite to its normal.
Shape CutShape(Shape shape, const Vector3& point, const Vector3& normal);

/// Returns the signed distance to the surface, negative inside. It is exact, except for gyroids,
/// where it is correct to first order. Outside, near edges of Voronoi cells and of cut shapes, it
/// is a lower bound.
double SignedDistance(const Shape& shape, const Vector3& point);

/// Returns whether the shape has a curved body.
bool HasBody(const Shape& shape);
/// Returns the value of the body's function: negative inside, with Lipschitz constant 1.
double EvaluateBody(const Shape& shape, const Vector3& point);
/// Returns the number of planes, including planes between Voronoi cells.
std::size_t CountPlanes(const Shape& shape);
/// Sets `plane` to plane i of the shape. Returns false if it does not exist
/// (a Voronoi cell against itself).
bool GetPlane(const Shape& shape, std::size_t i, HalfSpace& plane);

/// Returns the largest material number; 0 without shapes.
int CountMaterials(const std::vector<Shape>& shapes);

} // namespace vfm
