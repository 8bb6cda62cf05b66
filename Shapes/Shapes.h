/**
 * Solid shapes as implicit functions: what is inserted into a grid to get exact volume fractions.
 *
 * A shape is the intersection of at most one curved body with any number of half-spaces. Functions
 * are negative inside; that of the body changes by no more than the distance walked (Lipschitz
 * constant 1), so one value tells whether a whole box lies on one side.
 *
 * Lengths are those of the grid. Rotations are Euler angles in degrees about x, y, z, in the order
 * of vtkProp3D: matrix Rz Rx Ry, applied before the translation to the center. Cylinder, cone and
 * torus have the local z axis. The makers throw InputError when a size is not positive or a number
 * not finite, or a material is below 1.
 */
#pragma once

#include "Base/ConvexClip.h"

#include <functional>
#include <memory>
#include <vector>

namespace vfm
{

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

/// What a shape given by a function may know of a box from lower to upper.
struct BoxQueries
{
  /// Whether the surface may meet the box; false for every box inside a box for which it is false.
  std::function<bool(const Vector3& lower, const Vector3& upper)> Meets;
  /// Exact volume inside the shape.
  std::function<double(const Vector3& lower, const Vector3& upper)> Volume;
  /// The plane nearest to the surface in the box; returns about the volume between the two, 0 when
  /// the half-space is the shape there, infinity when the surface is not near any plane.
  std::function<double(const Vector3& lower, const Vector3& upper, HalfSpace& plane)> FitPlane;
};

/// Made by the functions below.
struct Shape
{
  ShapeKind Kind = ShapeKind::Sphere;
  int Material = 1;
  Vector3 Center{ { 0, 0, 0 } };
  std::array<Vector3, 3> Axes{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  Vector3 Size{ { 0, 0, 0 } };
  std::vector<HalfSpace> Planes; ///< the shape's own faces, then the cuts
  std::size_t OwnPlanes = 0;
  std::shared_ptr<const std::vector<Vector3>> Seeds; ///< of the Voronoi diagram
  std::size_t Seed = 0;                              ///< of this cell
  std::function<double(const Vector3&)> Distance;    ///< of ShapeKind::Function
  BoxQueries Boxes;                                  ///< of ShapeKind::Function, or none
};

Shape MakeSphere(int material, const Vector3& center, double radius);
Shape MakeEllipsoid(int material, const Vector3& center, const Vector3& radii,
  const Vector3& rotation = { { 0, 0, 0 } });
Shape MakeBox(int material, const Vector3& center, const Vector3& edges,
  const Vector3& rotation = { { 0, 0, 0 } });
Shape MakeCylinder(int material, const Vector3& center, double radius, double height,
  const Vector3& rotation = { { 0, 0, 0 } });
/// A cone or frustum; one of the radii may be 0. The center is half way between bottom and top.
Shape MakeCone(int material, const Vector3& center, double bottomRadius, double topRadius,
  double height, const Vector3& rotation = { { 0, 0, 0 } });
/// tubeRadius <= ringRadius.
Shape MakeTorus(int material, const Vector3& center, double ringRadius, double tubeRadius,
  const Vector3& rotation = { { 0, 0, 0 } });
/// The side of a plane that its normal (any length) points away from.
Shape MakeHalfSpace(int material, const Vector3& point, const Vector3& normal);
/// sin x cos y + sin y cos z + sin z cos x < level, with 2 pi scaled to period; |level| < 1.5.
Shape MakeGyroid(int material, const Vector3& center, double period, double level = 0.0,
  const Vector3& rotation = { { 0, 0, 0 } });
/// The points nearer to seeds[seed] than to any other seed.
Shape MakeVoronoiCell(
  int material, std::shared_ptr<const std::vector<Vector3>> seeds, std::size_t seed);
/// distance: signed, negative inside, Lipschitz constant 1. boxes, all or none: spare the
/// approximation where nothing else cuts a box. All callable by several threads at once.
Shape MakeFunctionShape(
  int material, std::function<double(const Vector3&)> distance, BoxQueries boxes = BoxQueries());
/// The part of the shape on the side of a plane that its normal points away from.
Shape CutShape(Shape shape, const Vector3& point, const Vector3& normal);

/// Signed distance to the surface, negative inside. Exact; but to first order for the gyroid, and a
/// lower bound outside near the edges of Voronoi cells and of shapes that were cut.
double SignedDistance(const Shape& shape, const Vector3& point);

/// Whether the shape has a curved body beside its planes.
bool HasBody(const Shape& shape);
/// The body's function: negative inside, Lipschitz constant 1.
double EvaluateBody(const Shape& shape, const Vector3& point);
std::size_t CountPlanes(const Shape& shape);
/// Plane i of the shape; false when there is none (a Voronoi cell against itself).
bool GetPlane(const Shape& shape, std::size_t i, HalfSpace& plane);

/// The largest material number, 0 without shapes.
int CountMaterials(const std::vector<Shape>& shapes);

} // namespace vfm
