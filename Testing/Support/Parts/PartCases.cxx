#include "Parts/PartCases.h"

#include "Base/PortableMath.h"
#include "Base/Vector3.h"

namespace vfm
{
namespace testing
{
namespace
{

/// Triangles with patches; points may be repeated.
struct PatchedTriangles
{
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  std::vector<int> Patches;

  void Add(const Vector3& a, const Vector3& b, const Vector3& c, int patch)
  {
    const Index first = static_cast<Index>(this->Points.size());
    this->Points.insert(this->Points.end(), { a, b, c });
    this->Triangles.push_back({ { first, first + 1, first + 2 } });
    this->Patches.push_back(patch);
  }
  void Add(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, int patch)
  {
    this->Add(a, b, c, patch);
    this->Add(a, c, d, patch);
  }
  BodySurface Make(const std::string& name, std::vector<std::string> patches) const
  {
    return MakeBody(name, this->Points, this->Triangles, this->Patches, std::move(patches));
  }
};

using Outline = std::vector<Vector3>; // counterclockwise, at z = 0

Vector3 Raised(const Vector3& x, double height)
{
  return { { x[0], x[1], height } };
}

/// Adds the walls above an outline; the first has patch `first`.
/// @param step  difference of the patches of one wall and the next
void AddWalls(const Outline& outline, double height, int first, int step, PatchedTriangles& to)
{
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Vector3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    to.Add(a, b, Raised(b, height), Raised(a, height), first + static_cast<int>(i) * step);
  }
}

/// Adds the lower and upper sides of a prism whose outline is visible from its first point.
void AddEnds(const Outline& outline, double height, int low, int high, PatchedTriangles& to)
{
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
  {
    const Vector3 &a = outline[0], &b = outline[i], &c = outline[i + 1];
    to.Add(a, c, b, low);
    to.Add(Raised(a, height), Raised(b, height), Raised(c, height), high);
  }
}

/// Returns point i of a square of half width 1 around the origin, at the angle of point i of a
/// regular polygon.
Vector3 OnSquare(int i, int segments)
{
  const int side = (8 * i / segments + 1) % 8 / 2; // 0: x = 1, then counterclockwise
  const int from = i - side * segments / 4;        // from the middle of the side
  const int part = from > segments / 2 ? from - segments : from;
  const double along = 8.0 * part / segments;
  const double points[4][2] = { { 1, along }, { -along, 1 }, { -1, -along }, { along, -1 } };
  return { { points[side][0], points[side][1], 0.0 } };
}

} // namespace

BodySurface Turned(BodySurface body, const Vector3& shift)
{
  for (Vector3& x : body.Boundary.Points)
  {
    const Vector3 y{ { 0.8 * x[0] - 0.6 * x[1], 0.6 * x[0] + 0.8 * x[1], x[2] } };
    x = shift +
      Vector3{ { y[0], (12.0 * y[1] - 5.0 * y[2]) / 13.0, (5.0 * y[1] + 12.0 * y[2]) / 13.0 } };
  }
  return body;
}

BodySurface WithoutPatches(BodySurface body)
{
  body.Patches.assign(body.Patches.size(), 0);
  body.PatchNames = { "" };
  return body;
}

BodySurface BracketBody(const std::string& name, double length, double thickness, double width)
{
  const double l = length, t = thickness;
  // From the inner corner, from which all others are visible.
  const Outline outline{ { { t, t, 0 } }, { { t, l, 0 } }, { { 0, l, 0 } }, { { 0, 0, 0 } },
    { { l, 0, 0 } }, { { l, t, 0 } } };
  PatchedTriangles part;
  AddWalls(outline, width, 0, 1, part);
  AddEnds(outline, width, 6, 7, part);
  return part.Make(name, { "inside", "top", "back", "base", "end", "step", "low", "high" });
}

BodySurface PlateBody(const std::string& name, Index tilesX, Index tilesY, double tile,
  double radius, double thickness, int segments)
{
  PatchedTriangles part;
  std::vector<std::string> names{ "bottom", "top", "outside" };
  for (Index n = 0; n < tilesX * tilesY; ++n)
  {
    names.push_back("hole_" + std::to_string(n + 1));
    const Index column = n % tilesX, row = n / tilesX;
    const Vector3 centre{ { tile * (0.5 + static_cast<double>(column)),
      tile * (0.5 + static_cast<double>(row)), 0 } };
    for (int i = 0; i < segments; ++i)
    {
      std::array<Vector3, 2> hole, square;
      for (int e = 0; e < 2; ++e)
      {
        const double angle = 2.0 * Pi * ((i + e) % segments) / segments;
        hole[e] = centre + radius * Vector3{ { Cosine(angle), Sine(angle), 0 } };
        square[e] = centre + 0.5 * tile * OnSquare((i + e) % segments, segments);
      }
      const auto up = [thickness](const Vector3& x) { return Raised(x, thickness); };
      part.Add(hole[0], hole[1], square[1], square[0], 0);
      part.Add(up(hole[0]), up(square[0]), up(square[1]), up(hole[1]), 1);
      part.Add(hole[1], hole[0], up(hole[0]), up(hole[1]), 3 + static_cast<int>(n));
      const int side = (8 * i / segments + 1) % 8 / 2;
      const bool isOuter[4] = { column + 1 == tilesX, row + 1 == tilesY, column == 0, row == 0 };
      if (isOuter[side])
      {
        part.Add(square[0], square[1], up(square[1]), up(square[0]), 2);
      }
    }
  }
  return part.Make(name, names);
}

BodySurface SliceBody(const std::string& name, double radius, double height, int segments)
{
  Outline outline{ { { 0, 0, 0 } } };
  for (int s = 0; s <= segments; ++s)
  {
    const double angle = 2.0 * Pi / 3.0 * s / segments;
    outline.push_back({ { radius * Cosine(angle), radius * Sine(angle), 0 } });
  }
  PatchedTriangles part;
  AddWalls(outline, height, 2, 0, part); // all walls are the arc, except the first and the last
  for (std::size_t t = 0; t < part.Patches.size(); ++t)
  {
    part.Patches[t] = t < 2 ? 3 : t + 2 < part.Patches.size() ? 2 : 4;
  }
  AddEnds(outline, height, 0, 1, part);
  return part.Make(name, { "low", "high", "arc", "first", "last" });
}

std::vector<double> AreasOfPatches(const BodySurface& body)
{
  std::vector<double> areas(body.PatchNames.size(), 0.0);
  const std::vector<Triangle> triangles = PlaceTriangles(body.Boundary);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& x = triangles[t];
    areas[body.Patches[t]] += 0.5 * Norm(Cross(x[1] - x[0], x[2] - x[0]));
  }
  return areas;
}

} // namespace testing
} // namespace vfm
