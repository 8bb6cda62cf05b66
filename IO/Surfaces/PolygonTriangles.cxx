#include "Surfaces/PolygonTriangles.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr std::size_t MostSearched = 500; // corners of a polygon whose cuts are searched

/// Returns the normal of a polygon, twice its area long.
Vector3 NormalOf(const std::vector<Vector3>& points, const std::vector<Index>& corners)
{
  Vector3 normal{};
  const Vector3& origin = points[corners[0]];
  for (std::size_t c = 1; c + 1 < corners.size(); ++c)
  {
    normal = normal + Cross(points[corners[c]] - origin, points[corners[c + 1]] - origin);
  }
  return normal;
}

/// Returns whether a triangle faces as the normal does, or not at all.
bool FacesAs(const Vector3& normal, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return Dot(normal, Cross(b - a, c - a)) >= 0.0;
}

/// Returns whether a corner can be cut off: the triangle with its neighbours faces as the polygon,
/// and contains no other corner.
bool IsEar(const std::vector<Vector3>& points, const std::vector<Index>& corners, std::size_t at,
  const Vector3& normal)
{
  const std::size_t count = corners.size();
  const Vector3 &a = points[corners[(at + count - 1) % count]], &b = points[corners[at]],
                &c = points[corners[(at + 1) % count]];
  if (!(Dot(normal, Cross(b - a, c - a)) > 0.0))
  {
    return false;
  }
  for (std::size_t o = 2; o + 1 < count; ++o)
  {
    const Vector3& x = points[corners[(at + o) % count]];
    if (FacesAs(normal, a, b, x) && FacesAs(normal, b, c, x) && FacesAs(normal, c, a, x))
    {
      return false;
    }
  }
  return true;
}

/// Returns the corner to cut off with the shortest cut; 1 if none can be.
std::size_t FindEar(
  const std::vector<Vector3>& points, const std::vector<Index>& corners, const Vector3& normal)
{
  std::size_t best = 1;
  double shortest = 1e300;
  for (std::size_t at = 0; at < corners.size(); ++at)
  {
    const std::size_t count = corners.size();
    const Vector3 cut =
      points[corners[(at + 1) % count]] - points[corners[(at + count - 1) % count]];
    const double length = Dot(cut, cut);
    if (length < shortest && IsEar(points, corners, at, normal))
    {
      shortest = length;
      best = at;
    }
  }
  return best;
}

} // namespace

void AddPolygon(const std::vector<Index>& corners, int patch, SurfaceFile& file)
{
  std::vector<Index> left = corners;
  const Vector3 normal = left.size() > 3 ? NormalOf(file.Points, left) : Vector3{};
  while (left.size() >= 3)
  {
    const std::size_t count = left.size();
    const std::size_t ear =
      count == 3 || corners.size() > MostSearched ? 1 : FindEar(file.Points, left, normal);
    file.Triangles.push_back(
      { { left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count] } });
    file.Patches.push_back(patch);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
}

} // namespace vfm
