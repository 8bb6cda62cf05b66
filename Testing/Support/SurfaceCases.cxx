#include "SurfaceCases.h"

#include "Base/PortableMath.h"
#include "Base/Vector3.h"
#include "Surfaces/SurfaceFractions.h"

#include <utility>

namespace vfm
{
namespace testing
{
namespace
{

void AddQuad(Index a, Index b, Index c, Index d, ClosedSurface& surface)
{
  surface.Triangles.push_back({ { a, b, c } });
  surface.Triangles.push_back({ { a, c, d } });
}

} // namespace

ClosedSurface BoxSurface(const Vector3& lower, const Vector3& upper, int parts)
{
  std::vector<Vector3> points;
  std::vector<PointTriangle> triangles;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Index first = static_cast<Index>(points.size());
    for (int j = 0; j <= parts; ++j)
    {
      for (int i = 0; i <= parts; ++i)
      {
        Vector3 x = face % 2 == 0 ? lower : upper;
        x[u] = i < parts ? lower[u] + (upper[u] - lower[u]) * i / parts : upper[u];
        x[v] = j < parts ? lower[v] + (upper[v] - lower[v]) * j / parts : upper[v];
        points.push_back(x);
      }
    }
    for (Index j = 0; j < parts; ++j)
    {
      for (Index i = 0; i < parts; ++i)
      {
        const Index a = first + i + (parts + 1) * j, c = a + parts + 2;
        const Index b = face % 2 == 0 ? a + parts + 1 : a + 1, d = a + c - b;
        triangles.push_back({ { a, b, c } });
        triangles.push_back({ { a, c, d } });
      }
    }
  }
  return CloseSurface(std::move(points), std::move(triangles));
}

ClosedSurface SphereSurface(const Vector3& centre, double radius, int rings)
{
  ClosedSurface surface;
  const int segments = 2 * rings;
  for (int r = 1; r < rings; ++r)
  {
    for (int s = 0; s < segments; ++s)
    {
      const double polar = Pi * r / rings, angle = 2.0 * Pi * s / segments;
      surface.Points.push_back(centre +
        radius *
          Vector3{ { Sine(polar) * Cosine(angle), Sine(polar) * Sine(angle), Cosine(polar) } });
    }
  }
  const Index north = static_cast<Index>(surface.Points.size()), south = north + 1;
  surface.Points.push_back(centre + Vector3{ { 0, 0, radius } });
  surface.Points.push_back(centre - Vector3{ { 0, 0, radius } });
  for (Index s = 0; s < segments; ++s)
  {
    const Index next = (s + 1) % segments, last = north - segments;
    surface.Triangles.push_back({ { north, s, next } });
    surface.Triangles.push_back({ { south, last + next, last + s } });
    for (Index ring = 0; ring < last; ring += segments)
    {
      AddQuad(ring + s, ring + segments + s, ring + segments + next, ring + next, surface);
    }
  }
  return surface;
}

ClosedSurface Reversed(ClosedSurface surface)
{
  for (PointTriangle& triangle : surface.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return surface;
}

ClosedSurface Together(ClosedSurface first, const ClosedSurface& second)
{
  const Index points = static_cast<Index>(first.Points.size());
  first.Points.insert(first.Points.end(), second.Points.begin(), second.Points.end());
  for (const PointTriangle& t : second.Triangles)
  {
    first.Triangles.push_back({ { points + t[0], points + t[1], points + t[2] } });
  }
  return first;
}

ClosedSurface TubeSurface(
  const Vector3& start, double length, double outerRadius, double innerRadius, int segments)
{
  ClosedSurface surface;
  for (int s = 0; s < segments; ++s)
  {
    const double angle = 2.0 * Pi * s / segments;
    const Vector3 out{ { 0.0, Cosine(angle), Sine(angle) } };
    for (double along : { 0.0, length })
    {
      for (double radius : { outerRadius, innerRadius })
      {
        surface.Points.push_back(start + Vector3{ { along, 0.0, 0.0 } } + radius * out);
      }
    }
  }
  for (Index s = 0; s < segments; ++s)
  {
    const Index a = 4 * s, b = 4 * ((s + 1) % segments); // points: start, outer and inner; end
    AddQuad(a, b, b + 2, a + 2, surface);
    AddQuad(a + 1, a + 3, b + 3, b + 1, surface);
    AddQuad(a, a + 1, b + 1, b, surface);
    AddQuad(a + 2, b + 2, b + 3, a + 3, surface);
  }
  return surface;
}

ClosedSurface Turned(ClosedSurface surface, const Vector3& centre, const Vector3& degrees)
{
  for (Vector3& point : surface.Points)
  {
    Vector3 x = point - centre;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double angle = degrees[axis] * Pi / 180.0;
      const double c = Cosine(angle), s = Sine(angle);
      const double u = x[(axis + 1) % 3], v = x[(axis + 2) % 3];
      x[(axis + 1) % 3] = c * u - s * v;
      x[(axis + 2) % 3] = s * u + c * v;
    }
    point = centre + x;
  }
  return surface;
}

InputSurfaces MakeBodies(const std::vector<ClosedSurface>& surfaces)
{
  InputSurfaces bodies;
  for (const ClosedSurface& surface : surfaces)
  {
    bodies.Bodies.push_back(
      MakeBody(std::to_string(bodies.Bodies.size() + 1), surface.Points, surface.Triangles));
  }
  return bodies;
}

FractionField FractionsOfBodies(const CartesianGrid& grid, const InputSurfaces& surfaces)
{
  Runtime runtime;
  const std::vector<Buffer<double>> arrays =
    FractionsOfSurfaces(grid.Coordinates(), grid.Local(), surfaces, runtime);
  FractionField field(grid, static_cast<int>(arrays.size()));
  Index n = 0;
  ForCells(grid.Local(),
    [&](const Index3& cell)
    {
      std::vector<FractionField::Part> parts;
      for (std::size_t m = 0; m < arrays.size(); ++m)
      {
        if (arrays[m][n] > 0.0)
        {
          parts.push_back({ static_cast<int>(m) + 1, arrays[m][n] });
        }
      }
      field.SetParts(grid.Linear(cell), parts);
      ++n;
    });
  return field;
}

} // namespace testing
} // namespace vfm
