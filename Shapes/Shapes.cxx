#include "Shapes/Shapes.h"

#include "Base/PortableMath.h"
#include "Base/Runtime.h"
#include "Base/Vector3.h"

#include <cmath>
#include <string>

namespace vfm
{
namespace
{

void RequirePositive(double value, const char* shape, const char* name)
{
  if (!(value > 0.0 && std::isfinite(value)))
  {
    throw InputError(
      std::string(shape) + ": " + name + " is " + std::to_string(value) + ", it must be above 0.");
  }
}

void RequireFinite(const Vector3& v, const char* shape, const char* name)
{
  if (!(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2])))
  {
    throw InputError(std::string(shape) + ": " + name + " must be finite numbers.");
  }
}

std::array<Vector3, 3> RotateAxes(const Vector3& degrees)
{
  double c[3], s[3];
  for (int a = 0; a < 3; ++a)
  {
    const bool isLarge = std::fabs(degrees[a]) > 1e6; // the sine needs an angle with digits
    const double angle = isLarge ? std::fmod(degrees[a], 360.0) : degrees[a];
    // Quarter turns are exact.
    const double quarters = angle / 90.0;
    const bool exact = quarters == std::floor(quarters);
    c[a] = exact ? std::round(Cosine(quarters * Pi / 2)) : Cosine(angle * Pi / 180);
    s[a] = exact ? std::round(Sine(quarters * Pi / 2)) : Sine(angle * Pi / 180);
  }
  // Columns of Rz Rx Ry.
  return {
    { { { c[2] * c[1] - s[2] * s[0] * s[1], s[2] * c[1] + c[2] * s[0] * s[1], -c[0] * s[1] } },
      { { -s[2] * c[0], c[2] * c[0], s[0] } },
      { { c[2] * s[1] + s[2] * s[0] * c[1], s[2] * s[1] - c[2] * s[0] * c[1], c[0] * c[1] } } }
  };
}

Shape Place(
  ShapeKind kind, const char* name, int material, const Vector3& center, const Vector3& rotation)
{
  if (material < 1)
  {
    throw InputError(std::string(name) + ": material is " + std::to_string(material) +
      ", materials are numbered from 1.");
  }
  RequireFinite(center, name, "center");
  RequireFinite(rotation, name, "rotation");
  Shape shape;
  shape.Kind = kind;
  shape.Material = material;
  shape.Center = center;
  shape.Axes = RotateAxes(rotation);
  return shape;
}

HalfSpace MakePlane(const Vector3& point, const Vector3& normal, const char* shape)
{
  RequireFinite(point, shape, "point");
  RequireFinite(normal, shape, "normal");
  const double length = Norm(normal);
  RequirePositive(length, shape, "length of the normal");
  const Vector3 n = (1.0 / length) * normal;
  return { n, Dot(n, point) };
}

/// Adds the two faces across a local axis.
void AddFaces(Shape& shape, int axis, double halfWidth)
{
  const Vector3& n = shape.Axes[axis];
  const double c = Dot(n, shape.Center);
  shape.Planes.push_back({ -1.0 * n, halfWidth - c });
  shape.Planes.push_back({ n, halfWidth + c });
  shape.OwnPlanes = shape.Planes.size();
}

Vector3 ToLocal(const Shape& shape, const Vector3& point)
{
  const Vector3 p = point - shape.Center;
  return { { Dot(shape.Axes[0], p), Dot(shape.Axes[1], p), Dot(shape.Axes[2], p) } };
}

double GyroidValue(const Vector3& p, double k)
{
  return Sine(k * p[0]) * Cosine(k * p[1]) + Sine(k * p[1]) * Cosine(k * p[2]) +
    Sine(k * p[2]) * Cosine(k * p[0]);
}

double GyroidDistance(const Shape& shape, const Vector3& p)
{
  const double k = shape.Size[0];
  Vector3 gradient;
  for (int a = 0; a < 3; ++a)
  {
    const double x = k * p[a], y = k * p[(a + 1) % 3], z = k * p[(a + 2) % 3];
    gradient[a] = k * (Cosine(x) * Cosine(y) - Sine(z) * Sine(x));
  }
  return (GyroidValue(p, k) - shape.Size[1]) / std::max(Norm(gradient), 1e-3 * k);
}

double ConeRadius(const Shape& shape, double z)
{
  return 0.5 * (shape.Size[0] + shape.Size[1]) +
    0.5 * (shape.Size[1] - shape.Size[0]) * z / shape.Size[2];
}

/// Returns the exact distance to a box.
/// @param q  offsets |p| - half edge along the axes of the box
double BoxDistance(const double* q, int dimension)
{
  double largest = q[0], outside = 0.0;
  for (int a = 0; a < dimension; ++a)
  {
    largest = std::max(largest, q[a]);
    outside += std::max(q[a], 0.0) * std::max(q[a], 0.0);
  }
  return largest > 0.0 ? std::sqrt(outside) : largest;
}

/// Returns the exact distance to a frustum, which is the distance to the outline
/// of its half section.
double ConeDistance(const Shape& shape, const Vector3& p)
{
  const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1]), h = shape.Size[2];
  const Vector3 corners[4] = { { { 0, -h, 0 } }, { { shape.Size[0], -h, 0 } },
    { { shape.Size[1], h, 0 } }, { { 0, h, 0 } } };
  double nearest = INFINITY;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 edge = corners[i + 1] - corners[i];
    const Vector3 q = Vector3{ { radius, p[2], 0 } } - corners[i];
    const double length2 = Dot(edge, edge);
    const double t = length2 > 0.0 ? std::min(std::max(Dot(q, edge) / length2, 0.0), 1.0) : 0.0;
    nearest = std::min(nearest, Norm(q - t * edge));
  }
  const bool inside = std::abs(p[2]) < h && radius < ConeRadius(shape, p[2]);
  return inside ? -nearest : nearest;
}

/// Returns the exact distance to an ellipsoid, by bisection for the root of eq. (19) of D. Eberly,
/// Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid (2013).
double EllipsoidDistance(const Shape& shape, const Vector3& p)
{
  const Vector3& e = shape.Size;
  const double smallest = std::min({ e[0], e[1], e[2] });
  double y[3], low = -INFINITY, scale2 = 0.0, value = -1.0;
  for (int a = 0; a < 3; ++a)
  {
    // The distance is symmetric. The limit keeps the point off the degenerate planes.
    y[a] = std::max(std::abs(p[a]), 1e-12 * smallest);
    low = std::max(low, e[a] * y[a] - e[a] * e[a]);
    scale2 += e[a] * e[a] * y[a] * y[a];
    value += y[a] * y[a] / (e[a] * e[a]);
  }
  low = std::max(low, -smallest * smallest);
  double high = std::max(low, std::sqrt(scale2));
  double t = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    t = 0.5 * (low + high);
    if (t == low || t == high)
    {
      break;
    }
    double g = -1.0;
    for (int a = 0; a < 3; ++a)
    {
      const double r = e[a] * y[a] / (t + e[a] * e[a]);
      g += r * r;
    }
    (g > 0.0 ? low : high) = t;
  }
  double distance2 = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const double d = t * y[a] / (t + e[a] * e[a]);
    distance2 += d * d;
  }
  return value < 0.0 ? -std::sqrt(distance2) : std::sqrt(distance2);
}

double LargestPlane(const Shape& shape, std::size_t first, const Vector3& point)
{
  double largest = -INFINITY;
  HalfSpace plane;
  for (std::size_t i = first; i < CountPlanes(shape); ++i)
  {
    if (GetPlane(shape, i, plane))
    {
      largest = std::max(largest, Dot(plane.Normal, point) - plane.Offset);
    }
  }
  return largest;
}

} // namespace

Shape MakeSphere(int material, const Vector3& center, double radius)
{
  RequirePositive(radius, "sphere", "radius");
  Shape shape = Place(ShapeKind::Sphere, "sphere", material, center, { { 0, 0, 0 } });
  shape.Size[0] = radius;
  return shape;
}

Shape MakeEllipsoid(
  int material, const Vector3& center, const Vector3& radii, const Vector3& rotation)
{
  for (double radius : radii)
  {
    RequirePositive(radius, "ellipsoid", "radius");
  }
  Shape shape = Place(ShapeKind::Ellipsoid, "ellipsoid", material, center, rotation);
  shape.Size = radii;
  return shape;
}

Shape MakeBox(int material, const Vector3& center, const Vector3& edges, const Vector3& rotation)
{
  Shape shape = Place(ShapeKind::Box, "box", material, center, rotation);
  for (int a = 0; a < 3; ++a)
  {
    RequirePositive(edges[a], "box", "size");
    shape.Size[a] = 0.5 * edges[a];
    AddFaces(shape, a, shape.Size[a]);
  }
  return shape;
}

Shape MakeCylinder(
  int material, const Vector3& center, double radius, double height, const Vector3& rotation)
{
  RequirePositive(radius, "cylinder", "radius");
  RequirePositive(height, "cylinder", "height");
  Shape shape = Place(ShapeKind::Cylinder, "cylinder", material, center, rotation);
  shape.Size = { { radius, 0.5 * height, 0.0 } };
  AddFaces(shape, 2, 0.5 * height);
  return shape;
}

Shape MakeCone(int material, const Vector3& center, double bottomRadius, double topRadius,
  double height, const Vector3& rotation)
{
  RequirePositive(std::max(bottomRadius, topRadius), "cone", "larger radius");
  RequirePositive(height, "cone", "height");
  if (!(std::min(bottomRadius, topRadius) >= 0.0))
  {
    throw InputError("cone: a radius is below 0.");
  }
  Shape shape = Place(ShapeKind::Cone, "cone", material, center, rotation);
  shape.Size = { { bottomRadius, topRadius, 0.5 * height } };
  AddFaces(shape, 2, 0.5 * height);
  return shape;
}

Shape MakeTorus(int material, const Vector3& center, double ringRadius, double tubeRadius,
  const Vector3& rotation)
{
  RequirePositive(ringRadius, "torus", "radius of the ring");
  RequirePositive(tubeRadius, "torus", "radius of the tube");
  if (tubeRadius > ringRadius)
  {
    throw InputError("torus: the radius of the tube is larger than the radius of the ring.");
  }
  Shape shape = Place(ShapeKind::Torus, "torus", material, center, rotation);
  shape.Size = { { ringRadius, tubeRadius, 0.0 } };
  return shape;
}

Shape MakeHalfSpace(int material, const Vector3& point, const Vector3& normal)
{
  Shape shape = Place(ShapeKind::HalfSpace, "halfspace", material, point, { { 0, 0, 0 } });
  shape.Planes.push_back(MakePlane(point, normal, "halfspace"));
  shape.OwnPlanes = 1;
  return shape;
}

Shape MakeGyroid(
  int material, const Vector3& center, double period, double level, const Vector3& rotation)
{
  RequirePositive(period, "gyroid", "period");
  if (!(std::abs(level) < 1.5))
  {
    throw InputError("gyroid: level must be above -1.5 and below 1.5.");
  }
  Shape shape = Place(ShapeKind::Gyroid, "gyroid", material, center, rotation);
  shape.Size = { { 2.0 * Pi / period, level, 0.0 } };
  return shape;
}

Shape MakeVoronoiCell(
  int material, std::shared_ptr<const std::vector<Vector3>> seeds, std::size_t seed)
{
  Shape shape =
    Place(ShapeKind::VoronoiCell, "Voronoi cell", material, seeds->at(seed), { { 0, 0, 0 } });
  shape.Seeds = std::move(seeds);
  shape.Seed = seed;
  return shape;
}

Shape MakeFunctionShape(int material, std::function<double(const Vector3&)> distance)
{
  Shape shape = Place(ShapeKind::Function, "function", material, { { 0, 0, 0 } }, { { 0, 0, 0 } });
  shape.Distance = std::move(distance);
  return shape;
}

Shape CutShape(Shape shape, const Vector3& point, const Vector3& normal)
{
  shape.Planes.push_back(MakePlane(point, normal, "cut"));
  return shape;
}

double SignedDistance(const Shape& shape, const Vector3& point)
{
  const Vector3 p = ToLocal(shape, point);
  double distance = 0.0;
  switch (shape.Kind)
  {
    case ShapeKind::Ellipsoid:
      distance = EllipsoidDistance(shape, p);
      break;
    case ShapeKind::Box:
    {
      const double q[3] = { std::abs(p[0]) - shape.Size[0], std::abs(p[1]) - shape.Size[1],
        std::abs(p[2]) - shape.Size[2] };
      distance = BoxDistance(q, 3);
      break;
    }
    case ShapeKind::Cylinder:
    {
      const double q[2] = { std::sqrt(p[0] * p[0] + p[1] * p[1]) - shape.Size[0],
        std::abs(p[2]) - shape.Size[1] };
      distance = BoxDistance(q, 2);
      break;
    }
    case ShapeKind::Cone:
      distance = ConeDistance(shape, p);
      break;
    case ShapeKind::Gyroid:
      distance = GyroidDistance(shape, p);
      break;
    case ShapeKind::HalfSpace:
    case ShapeKind::VoronoiCell:
      return LargestPlane(shape, 0, point);
    default: // the body's function is the distance
      distance = EvaluateBody(shape, point);
  }
  return std::max(distance, LargestPlane(shape, shape.OwnPlanes, point));
}

bool HasBody(const Shape& shape)
{
  return shape.Kind != ShapeKind::Box && shape.Kind != ShapeKind::HalfSpace &&
    shape.Kind != ShapeKind::VoronoiCell;
}

double EvaluateBody(const Shape& shape, const Vector3& point)
{
  if (shape.Kind == ShapeKind::Function)
  {
    return shape.Distance(point);
  }
  const Vector3 p = ToLocal(shape, point);
  const Vector3& size = shape.Size;
  switch (shape.Kind)
  {
    case ShapeKind::Sphere:
      return Norm(p) - size[0];
    case ShapeKind::Ellipsoid:
      return (Norm(Divided(p, size)) - 1.0) * std::min({ size[0], size[1], size[2] });
    case ShapeKind::Cylinder:
      return std::sqrt(p[0] * p[0] + p[1] * p[1]) - size[0];
    case ShapeKind::Cone:
    {
      const double slope = 0.5 * (size[1] - size[0]) / size[2];
      return (std::sqrt(p[0] * p[0] + p[1] * p[1]) - ConeRadius(shape, p[2])) /
        std::sqrt(1.0 + slope * slope);
    }
    case ShapeKind::Torus:
    {
      const double q = std::sqrt(p[0] * p[0] + p[1] * p[1]) - size[0];
      return std::sqrt(q * q + p[2] * p[2]) - size[1];
    }
    case ShapeKind::Gyroid: // the gradient is at most sqrt(3) times the wave number
      return (GyroidValue(p, size[0]) - size[1]) / (std::sqrt(3.0) * size[0]);
    default:
      return -INFINITY; // planes only
  }
}

std::size_t CountPlanes(const Shape& shape)
{
  return shape.Planes.size() + (shape.Seeds ? shape.Seeds->size() : 0);
}

bool GetPlane(const Shape& shape, std::size_t i, HalfSpace& plane)
{
  if (i < shape.Planes.size())
  {
    plane = shape.Planes[i];
    return true;
  }
  const std::size_t other = i - shape.Planes.size();
  const Vector3& a = (*shape.Seeds)[shape.Seed];
  const Vector3& b = (*shape.Seeds)[other];
  const Vector3 d = b - a;
  const double length = Norm(d);
  if (!(length > 0.0))
  {
    return false;
  }
  plane.Normal = (1.0 / length) * d;
  plane.Offset = 0.5 * (Dot(plane.Normal, a) + Dot(plane.Normal, b));
  return true;
}

int CountMaterials(const std::vector<Shape>& shapes)
{
  int materials = 0;
  for (const Shape& shape : shapes)
  {
    materials = std::max(materials, shape.Material);
  }
  return materials;
}

} // namespace vfm
