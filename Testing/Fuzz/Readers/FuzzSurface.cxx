/**
 * Makes a solid from a triangle surface, and measures it in boxes. The input is the number of
 * points (a byte), three doubles per point, and three numbers of points (a byte each) per triangle.
 */
#include "Harness.h"

#include "Ranks/Errors.h"
#include "Shapes/ShapesTriangles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <tuple>

namespace vfm
{
namespace testing
{
namespace
{

constexpr std::size_t Most = 5; // corners of boxes

unsigned char ByteAt(const std::string& bytes, std::size_t at)
{
  return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

std::vector<Vector3> ReadPoints(const std::string& bytes)
{
  std::vector<Vector3> points(ByteAt(bytes, 0));
  const std::size_t size = std::min(points.size() * sizeof(Vector3), bytes.size() - 1);
  if (size > 0)
  {
    std::memcpy(points.data(), bytes.data() + 1, size);
  }
  return points;
}

std::vector<PointTriangle> ReadTriangles(const std::string& bytes, std::size_t begin)
{
  std::vector<PointTriangle> triangles;
  for (std::size_t at = begin; at + 3 <= bytes.size(); at += 3)
  {
    triangles.push_back({ { ByteAt(bytes, at), ByteAt(bytes, at + 1), ByteAt(bytes, at + 2) } });
  }
  return triangles;
}

/// Measures in the boxes between each pair of some corners of triangles.
void MeasureBoxes(const Shape& solid, const ClosedSurface& surface)
{
  std::vector<Vector3> points;
  for (const PointTriangle& triangle : surface.Triangles)
  {
    points.push_back(surface.Points[triangle[0]]);
  }
  const std::size_t count = std::min(points.size(), Most);
  for (std::size_t i = 0; i < count * count; ++i)
  {
    const Vector3 &a = points[i / count], &b = points[i % count];
    Vector3 lower, upper;
    for (int axis = 0; axis < 3; ++axis)
    {
      std::tie(lower[axis], upper[axis]) = std::minmax(a[axis], b[axis]);
    }
    HalfSpace plane;
    solid.Boxes.Meets(lower, upper);
    if (!std::isfinite(solid.Boxes.Volume(lower, upper)))
    {
      throw std::logic_error("a volume that is not finite");
    }
    solid.Boxes.FitPlane(lower, upper, plane);
  }
}

} // namespace

void ReadBytes(const std::string& bytes)
{
  if (bytes.empty())
  {
    return;
  }
  const std::vector<Vector3> points = ReadPoints(bytes);
  const ClosedSurface surface =
    CloseSurface(points, ReadTriangles(bytes, 1 + points.size() * sizeof(Vector3)));
  MeasureBoxes(MakeSolid(1, surface, [](const Vector3&) { return 0.0; }), surface);
}

} // namespace testing
} // namespace vfm
