#include "TetGen/TetGenSurface.h"

#include "TetGen/TetGenFaces.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

namespace vfm
{
namespace tetfill
{

std::string Text(const char* format, double a, double b, double c)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, a, b, c);
  return text;
}

namespace
{

/// A triangle is flat if its height is at most this factor times its longest edge. At 1e-6,
/// TetGen's flips were seen to repeat forever.
const double FlatTriangle = 1e-4;

/// Checks the numbers and coordinates of points, and the points of triangles.
std::string CheckNumbers(const TetGenPart& part)
{
  const std::size_t limit = std::numeric_limits<int>::max() / 64;
  if (part.Points.empty() || part.Triangles.empty())
  {
    return "the surface is empty";
  }
  if (part.Points.size() > limit || part.Triangles.size() > limit)
  {
    return "the surface has too many points or triangles";
  }
  for (const Vector3& p : part.Points)
  {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return "a point of the surface is not finite";
    }
  }
  const int n = static_cast<int>(part.Points.size());
  for (const Triangle& t : part.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (t[k] < 0 || t[k] >= n)
      {
        return Text("a triangle refers to point %.0f of %.0f", t[k], n);
      }
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      return Text("a triangle has point %.0f twice", t[0] == t[1] ? t[0] : t[2]);
    }
  }
  return "";
}

/// Fills all members except Volume and Area.
std::string MakeLocal(const TetGenPart& part, LocalPart& local)
{
  std::vector<int> localPoint(part.Points.size(), -1);
  for (const Triangle& t : part.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      localPoint[t[k]] = 0;
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  Vector3 lower{ { infinity, infinity, infinity } }, upper{ { -infinity, -infinity, -infinity } };
  for (std::size_t i = 0; i < part.Points.size(); ++i)
  {
    if (localPoint[i] == 0)
    {
      localPoint[i] = static_cast<int>(local.PartPoint.size());
      local.PartPoint.push_back(static_cast<int>(i));
      for (int a = 0; a < 3; ++a)
      {
        lower[a] = std::min(lower[a], part.Points[i][a]);
        upper[a] = std::max(upper[a], part.Points[i][a]);
      }
    }
  }
  const Vector3 extent = upper - lower;
  const double longest = std::max({ extent[0], extent[1], extent[2] });
  if (!std::isfinite(longest) || !std::isnormal(longest))
  {
    return "the surface is too small or too large";
  }
  if (std::min({ extent[0], extent[1], extent[2] }) < 1e-9 * longest)
  {
    return "the surface is flat";
  }
  local.Origin = lower;
  local.Exponent = std::ilogb(longest);
  for (const int i : local.PartPoint)
  {
    local.Points.push_back(local.ToLocal(part.Points[i]));
  }
  for (const Triangle& t : part.Triangles)
  {
    local.Triangles.push_back({ { localPoint[t[0]], localPoint[t[1]], localPoint[t[2]] } });
  }
  return "";
}

/// Returns the signed volume between a triangle and the origin.
double VolumeUnder(const LocalPart& local, const Triangle& t)
{
  return Dot(local.Points[t[0]], Cross(local.Points[t[1]], local.Points[t[2]])) / 6.0;
}

/// Checks that all points and all triangles differ and that no triangle is flat.
std::string CheckTriangles(const LocalPart& local)
{
  std::vector<Vector3> points = local.Points;
  std::sort(points.begin(), points.end());
  const auto twice = std::adjacent_find(points.begin(), points.end());
  if (twice != points.end())
  {
    const Vector3 p = local.ToWorld(*twice);
    return Text("two points of the surface are at the same place (%g, %g, %g)", p[0], p[1], p[2]);
  }
  std::vector<Triangle> sorted;
  for (const Triangle& t : local.Triangles)
  {
    const Vector3 a = local.Points[t[0]], ab = local.Points[t[1]] - a, ac = local.Points[t[2]] - a,
                  bc = ac - ab;
    const double longest = std::max({ Dot(ab, ab), Dot(ac, ac), Dot(bc, bc) });
    if (!(Norm(Cross(ab, ac)) > FlatTriangle * longest))
    {
      const Vector3 p = local.ToWorld(a);
      return Text("a triangle at (%g, %g, %g) is flat", p[0], p[1], p[2]);
    }
    sorted.push_back(t);
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
  {
    return "two triangles have the same corners";
  }
  return "";
}

/// Checks that each directed edge is matched by its opposite, and that the volume inside is
/// positive. Sets Area and Volume.
std::string CheckClosed(LocalPart& local)
{
  std::vector<std::pair<int, int>> forward, backward;
  for (const Triangle& t : local.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      forward.emplace_back(t[k], t[(k + 1) % 3]);
      backward.emplace_back(t[(k + 1) % 3], t[k]);
    }
    const Vector3& a = local.Points[t[0]];
    local.Area += 0.5 * Norm(Cross(local.Points[t[1]] - a, local.Points[t[2]] - a));
    local.Volume += VolumeUnder(local, t);
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  const auto open = std::mismatch(forward.begin(), forward.end(), backward.begin());
  if (open.first != forward.end())
  {
    const Vector3 p = local.ToWorld(local.Points[std::min(*open.first, *open.second).first]);
    return Text("the surface is not closed at (%g, %g, %g)", p[0], p[1], p[2]);
  }
  if (!(std::abs(local.Volume) > 1e-12 * local.Area))
  {
    return "the surface encloses no volume";
  }
  return local.Volume > 0.0 ? "" : "the normals of the surface point inward";
}

/// Returns the distance, in units of d, at which the ray from p along d first meets a triangle;
/// infinity if there is none.
double FirstHit(const LocalPart& local, const Vector3& p, const Vector3& d, std::size_t except)
{
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < local.Triangles.size(); ++i)
  {
    const Triangle& t = local.Triangles[i];
    const Vector3 &a = local.Points[t[0]], ab = local.Points[t[1]] - a, ac = local.Points[t[2]] - a,
                  h = Cross(d, ac), q = Cross(p - a, ab);
    const double det = Dot(ab, h);
    if (i != except && det != 0.0)
    {
      const double u = Dot(p - a, h) / det, v = Dot(d, q) / det, w = Dot(ac, q) / det;
      const double slack = 1e-6;
      if (u >= -slack && v >= -slack && u + v <= 1.0 + slack && w >= 0.0)
      {
        first = std::min(first, w);
      }
    }
  }
  return first;
}

} // namespace

std::string MakeLocalPart(const TetGenPart& part, LocalPart& local)
{
  std::string refusal = CheckNumbers(part);
  refusal = refusal.empty() ? MakeLocal(part, local) : refusal;
  refusal = refusal.empty() ? CheckTriangles(local) : refusal;
  return refusal.empty() ? CheckClosed(local) : refusal;
}

std::vector<Vector3> HoleSeeds(const LocalPart& local)
{
  const std::size_t n = local.Triangles.size();
  std::vector<std::array<int, 3>> edges; // lower point, upper point and triangle of each edge
  for (std::size_t i = 0; i < n; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int p = local.Triangles[i][k], q = local.Triangles[i][(k + 1) % 3];
      edges.push_back({ { std::min(p, q), std::max(p, q), static_cast<int>(i) } });
    }
  }
  std::sort(edges.begin(), edges.end());
  Sets sets(n);
  for (std::size_t e = 1; e < edges.size(); ++e)
  {
    if (edges[e][0] == edges[e - 1][0] && edges[e][1] == edges[e - 1][1])
    {
      sets.Join(edges[e][2], edges[e - 1][2]);
    }
  }
  std::vector<double> volume(n, 0.0), area(n, 0.0);
  std::vector<std::size_t> largest(n, 0);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Triangle& t = local.Triangles[i];
    const int root = sets.Root(static_cast<int>(i));
    volume[root] += VolumeUnder(local, t);
    const Vector3& a = local.Points[t[0]];
    const double doubled = Norm(Cross(local.Points[t[1]] - a, local.Points[t[2]] - a));
    if (doubled > area[root])
    {
      area[root] = doubled;
      largest[root] = i;
    }
  }
  std::vector<Vector3> seeds;
  for (std::size_t root = 0; root < n; ++root)
  {
    if (volume[root] < 0.0)
    {
      const Triangle& t = local.Triangles[largest[root]];
      const Vector3 &a = local.Points[t[0]], &b = local.Points[t[1]], &c = local.Points[t[2]];
      const Vector3 centre = (1.0 / 3.0) * (a + b + c), normal = Unit(Cross(b - a, c - a));
      const double room = FirstHit(local, centre, normal, largest[root]);
      seeds.push_back(centre + std::min(0.5 * room, 0.25 * std::sqrt(area[root])) * normal);
    }
  }
  return seeds;
}

} // namespace tetfill
} // namespace vfm
