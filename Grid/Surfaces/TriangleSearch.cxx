#include "Surfaces/TriangleSearch.h"

#include <algorithm>

namespace vfm
{
namespace
{

Bounds BoundsOf(const Triangle& triangle)
{
  Bounds box;
  for (const Vector3& corner : triangle)
  {
    box.Add(corner);
  }
  return box;
}

std::vector<Bounds> BoundsOf(const std::vector<Triangle>& triangles)
{
  std::vector<Bounds> boxes;
  for (const Triangle& triangle : triangles)
  {
    boxes.push_back(BoundsOf(triangle));
  }
  return boxes;
}

double MeasureDiagonal(const std::vector<Triangle>& triangles)
{
  Bounds all;
  for (const Triangle& triangle : triangles)
  {
    all.Add(BoundsOf(triangle));
  }
  return triangles.empty() ? 0.0 : Norm(all.Upper - all.Lower);
}

/// Returns the nearest point of the line from a to b.
Vector3 NearestOfLine(const Vector3& a, const Vector3& b, const Vector3& x)
{
  const Vector3 along = b - a;
  const double square = Dot(along, along);
  const double t = square > 0.0 ? Dot(x - a, along) / square : 0.0;
  return t <= 0.0 ? a : t >= 1.0 ? b : a + t * along;
}

} // namespace

Vector3 NearestPoint(const Triangle& t, const Vector3& x)
{
  const Vector3 normal = Cross(t[1] - t[0], t[2] - t[0]);
  const double square = Dot(normal, normal);
  bool isOver = square > 0.0;
  Vector3 nearest = t[0];
  double least = 1e300;
  for (int c = 0; c < 3; ++c)
  {
    const Vector3 &a = t[c], &b = t[(c + 1) % 3];
    if (square > 0.0 && Dot(Cross(b - a, x - a), normal) >= 0.0)
    {
      continue; // on the inner side of this edge
    }
    isOver = false;
    const Vector3 point = NearestOfLine(a, b, x);
    const double distance = Dot(point - x, point - x);
    if (distance < least)
    {
      least = distance;
      nearest = point;
    }
  }
  return isOver ? x - Dot(x - t[0], normal) / square * normal : nearest;
}

double WayTo(const Triangle& t, const Vector3& x, const Vector3& direction)
{
  constexpr double Slack = 1e-9; // at edges, so that no ray passes between two triangles
  const Vector3 u = t[1] - t[0], v = t[2] - t[0], start = x - t[0];
  const Vector3 normal = Cross(u, v);
  const double slope = -Dot(normal, direction);
  if (slope == 0.0)
  {
    return -1.0;
  }
  const Vector3 moment = Cross(start, direction);
  const double a = Dot(v, moment) / slope, b = -Dot(u, moment) / slope;
  const bool isMet = a >= -Slack && b >= -Slack && a + b <= 1.0 + Slack;
  return isMet ? Dot(normal, start) / slope : -1.0;
}

double WayTo(const Bounds& box, const Vector3& x, const Vector3& direction)
{
  constexpr double Never = 1e301;
  double first = 0.0, last = Never;
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] == 0.0)
    {
      last = x[a] < box.Lower[a] || x[a] > box.Upper[a] ? -1.0 : last;
      continue;
    }
    const double low = (box.Lower[a] - x[a]) / direction[a];
    const double high = (box.Upper[a] - x[a]) / direction[a];
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return first <= last * (1.0 + 1e-12) ? first : Never; // boxes can be flat
}

TriangleSearch::TriangleSearch(std::vector<Triangle> triangles, Runtime& runtime) :
  Triangles(std::move(triangles)),
  Normals(this->Triangles.size()),
  Length(MeasureDiagonal(this->Triangles)),
  Tree(BoundsOf(this->Triangles), runtime)
{
  ForEach(runtime, this->Triangles.size(),
    [this](Index i)
    {
      const Triangle& t = this->Triangles[i];
      this->Normals[i] = Unit(Cross(t[1] - t[0], t[2] - t[0]));
    });
}

} // namespace vfm
