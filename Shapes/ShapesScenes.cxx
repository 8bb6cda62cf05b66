#include "Shapes/ShapesScenes.h"

#include "Base/PortableMath.h"
#include "Base/Runtime.h"
#include "Base/Vector3.h"

#include <random>

namespace vfm
{
namespace
{

constexpr int Trials = 8; // random points per grain; the one farthest from the other seeds is used

constexpr const char* SceneNames[] = { "Sphere", "Two Spheres", "Ellipsoid", "Ball and Plate",
  "Three Sectors", "Torus", "Cylinder", "Half Sphere", "Oblique Plate", "Gyroid", "Polycrystal",
  "Eight Shapes" };
static_assert(
  sizeof(SceneNames) / sizeof(SceneNames[0]) == static_cast<std::size_t>(Scene::NumberOfScenes),
  "one name per scene");

/// Maps the domain [-1,1]^3 to the largest cube at the center of a domain.
struct Frame
{
  Vector3 Center;
  double Half; // half of the shortest edge

  Vector3 At(double x, double y, double z) const
  {
    return this->Center + this->Half * Vector3{ { x, y, z } };
  }
};

/// Makes a box, wedge, sphere, cylinder, pyramid, ellipsoid, torus and cone. The wedge and
/// the pyramid touch the box, the cone touches the cylinder, and the torus surrounds the
/// top of the sphere.
std::vector<Shape> MakeEightShapes(const Frame& f)
{
  const double h = f.Half;
  const Vector3 block{ { 0.8 * h, 0.8 * h, 0.6 * h } };
  const Shape wedge = CutShape(
    MakeBox(2, f.At(0.35, -0.45, -0.5), block), f.At(0.35, -0.45, -0.5), { { 0.6, 0.0, 0.8 } });
  Shape pyramid = MakeBox(5, f.At(-0.45, -0.45, 0.2), { { 0.8 * h, 0.8 * h, 0.8 * h } });
  for (const Vector3& normal : { Vector3{ { 2.0, 0.0, 1.0 } }, Vector3{ { -2.0, 0.0, 1.0 } },
         Vector3{ { 0.0, 2.0, 1.0 } }, Vector3{ { 0.0, -2.0, 1.0 } } })
  {
    pyramid = CutShape(pyramid, f.At(-0.45, -0.45, 0.6), normal);
  }
  return { MakeBox(1, f.At(-0.45, -0.45, -0.5), block), wedge,
    MakeSphere(3, f.At(0.44, 0.44, -0.4), 0.4 * h),
    MakeCylinder(4, f.At(-0.46, 0.44, -0.5), 0.38 * h, 0.6 * h), pyramid,
    MakeEllipsoid(
      6, f.At(0.45, -0.45, 0.4), { { 0.45 * h, 0.25 * h, 0.3 * h } }, { { 20.0, 35.0, 50.0 } }),
    MakeTorus(7, f.At(0.44, 0.44, 0.02), 0.32 * h, 0.16 * h),
    MakeCone(8, f.At(-0.46, 0.44, 0.1), 0.38 * h, 0.12 * h, 0.6 * h) };
}

} // namespace

std::string GetSceneName(Scene scene)
{
  return SceneNames[static_cast<int>(scene)];
}

std::vector<Shape> MakeScene(Scene scene, const Vector3& lower, const Vector3& upper)
{
  const Vector3 edges = upper - lower;
  const Frame f{ 0.5 * (lower + upper), 0.5 * std::min({ edges[0], edges[1], edges[2] }) };
  const double h = f.Half;
  switch (scene)
  {
    case Scene::TwoSpheres:
      return { MakeSphere(1, f.At(-0.45, 0.02, 0.01), 0.4 * h),
        MakeSphere(1, f.At(0.45, 0.02, 0.01), 0.4 * h) };
    case Scene::Ellipsoid:
      return { MakeEllipsoid(
        1, f.Center, { { 0.8 * h, 0.5 * h, 0.35 * h } }, { { 20.0, 35.0, 50.0 } }) };
    case Scene::BallAndPlate:
      return { MakeSphere(1, f.At(0.0, 0.0, 0.15), 0.5 * h),
        MakeBox(2, f.At(0.0, 0.0, -0.55), { { 1.6 * h, 1.6 * h, 0.4 * h } }) };
    case Scene::ThreeSectors:
      return MakeSectors(f.Center, 0.75 * h, 3, 20.0);
    case Scene::Torus:
      return { MakeTorus(1, f.Center, 0.55 * h, 0.25 * h, { { 20.0, 35.0, 50.0 } }) };
    case Scene::Cylinder:
      return { MakeCylinder(1, f.Center, 0.5 * h, 4.0 * Norm(edges), { { 0.0, 20.0, 10.0 } }) };
    case Scene::HalfSphere:
      return { MakeSphere(1, { { f.Center[0], f.Center[1], lower[2] } }, 0.75 * h) };
    case Scene::ObliquePlate:
      return { MakePlate(1, f.Center, { { 1.0, 0.7, 0.4 } }, 0.3 * h) };
    case Scene::Gyroid:
      return { MakeGyroid(1, f.Center, 1.25 * h) };
    case Scene::Polycrystal:
      return MakePolycrystal(1, lower, upper, 20);
    case Scene::EightShapes:
      return MakeEightShapes(f);
    default:
      return { MakeSphere(1, f.Center, 0.75 * h) };
  }
}

Shape MakePlate(int material, const Vector3& center, const Vector3& normal, double thickness)
{
  if (!(thickness > 0.0))
  {
    throw InputError("plate: thickness must be above 0.");
  }
  const Vector3 half = 0.5 * thickness * Unit(normal);
  return CutShape(MakeHalfSpace(material, center + half, normal), center - half, -1.0 * normal);
}

std::vector<Shape> MakeSectors(const Vector3& center, double radius, int sectors, double startAngle)
{
  if (sectors < 2)
  {
    throw InputError("sectors: number must be at least 2.");
  }
  std::vector<Shape> shapes;
  const Shape ball = MakeSphere(1, center, radius);
  for (int s = 0; s < sectors; ++s)
  {
    const double begin = (startAngle + 360.0 * s / sectors) * Pi / 180.0;
    const double end = (startAngle + 360.0 * (s + 1) / sectors) * Pi / 180.0;
    Shape sector = CutShape(ball, center, { { Sine(begin), -Cosine(begin), 0.0 } });
    sector = CutShape(sector, center, { { -Sine(end), Cosine(end), 0.0 } });
    sector.Material = s + 1;
    shapes.push_back(sector);
  }
  return shapes;
}

std::vector<Shape> MakePolycrystal(int firstMaterial, const Vector3& lower, const Vector3& upper,
  int grains, unsigned int randomSeed)
{
  if (grains < 1)
  {
    throw InputError("polycrystal: number of grains must be at least 1.");
  }
  std::mt19937_64 random(randomSeed);
  const auto seeds = std::make_shared<std::vector<Vector3>>();
  for (int g = 0; g < grains; ++g)
  {
    Vector3 best{ { 0, 0, 0 } };
    double farthest = -1.0;
    for (int trial = 0; trial < Trials; ++trial)
    {
      Vector3 point;
      for (int a = 0; a < 3; ++a)
      {
        // std::uniform_real_distribution is not used, because it differs between libraries.
        const double t = static_cast<double>(random() >> 11) * 0x1p-53;
        point[a] = lower[a] + t * (upper[a] - lower[a]);
      }
      double nearest = INFINITY;
      for (const Vector3& seed : *seeds)
      {
        nearest = std::min(nearest, Norm(point - seed));
      }
      if (nearest > farthest)
      {
        farthest = nearest;
        best = point;
      }
    }
    seeds->push_back(best);
  }
  std::vector<Shape> shapes;
  for (int g = 0; g < grains; ++g)
  {
    shapes.push_back(MakeVoronoiCell(firstMaterial + g, seeds, g));
  }
  return shapes;
}

} // namespace vfm
