#include "Cells/ThinShapes.h"

#include "Base/Vector3.h"
#include "RandomDraw.h"

namespace vfm
{
namespace testing
{

Shape MakeFilm(const Vector3& point, const Vector3& normal, double thickness)
{
  const Vector3 half = 0.5 * thickness * Unit(normal);
  return CutShape(MakeHalfSpace(1, point + half, normal), point - half, -1.0 * normal);
}

Shape MakeShell(const Vector3& center, double radius, double thickness)
{
  return MakeFunctionShape(
    1, [=](const Vector3& p) { return std::abs(Norm(p - center) - radius) - 0.5 * thickness; });
}

Shape MakeThread(const Vector3& point, const Vector3& direction, double diameter)
{
  const Vector3 axis = Unit(direction);
  return MakeFunctionShape(1,
    [=](const Vector3& p)
    {
      const Vector3 d = p - point;
      return Norm(d - Dot(d, axis) * axis) - 0.5 * diameter;
    });
}

std::vector<Shape> MakeDrops(double volume, unsigned seed)
{
  constexpr double Pi = 3.14159265358979323846;
  RandomDraw draw(seed);
  const double radius = std::cbrt(0.75 * volume / Pi);
  std::vector<Shape> drops;
  ForCells({ {}, { { 3, 3, 3 } } },
    [&](const Index3& at)
    {
      Vector3 center = draw.Vector(2.5, 3.5);
      for (int a = 0; a < 3; ++a)
      {
        center[a] += 6.0 * static_cast<double>(at[a]);
      }
      drops.push_back(MakeSphere(1, center, radius));
    });
  return drops;
}

std::vector<Vector3> ListDirections(int count)
{
  std::vector<Vector3> directions{ { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 1, 1, 1 } },
    { { 3, 2, 1 } } };
  RandomDraw draw(1);
  while (static_cast<int>(directions.size()) < count)
  {
    directions.push_back(draw.Vector(0.0, 1.0));
  }
  for (Vector3& direction : directions)
  {
    direction = Unit(direction);
  }
  return directions;
}

} // namespace testing
} // namespace vfm
