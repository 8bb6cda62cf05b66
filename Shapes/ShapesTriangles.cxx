#include "Shapes/ShapesTriangles.h"

#include "Base/Vector3.h"

namespace vfm
{
namespace
{

constexpr int MaximumBins = 1024;       // maximum number of bins along an axis
constexpr double SamePlane = 1e-10;     // deviation from a plane over the diagonal of the box
constexpr double LeastMeanNormal = 0.5; // minimum length of the mean normal for a plane

/// Triangle clipped by up to six planes, which has at most nine corners, or more if rounding moves
/// corners across a plane: then each plane adds up to half the number, 3, 4, 6, 9, 13, 19, 28.
struct Polygon
{
  int Size = 0;
  std::array<Vector3, 28> Corners;
};

/// Returns the part of a polygon below a value along an axis for sign 1, above it for sign -1.
/// Points at the value count as below.
Polygon ClipPolygon(const Polygon& polygon, int axis, double value, double sign)
{
  Polygon part;
  for (int i = 0; i < polygon.Size; ++i)
  {
    const Vector3& a = polygon.Corners[i];
    const Vector3& b = polygon.Corners[i + 1 < polygon.Size ? i + 1 : 0];
    const double heightA = sign * (a[axis] - value), heightB = sign * (b[axis] - value);
    const bool keepA = sign > 0.0 ? heightA <= 0.0 : heightA < 0.0;
    const bool keepB = sign > 0.0 ? heightB <= 0.0 : heightB < 0.0;
    if (keepA)
    {
      part.Corners[part.Size++] = a;
    }
    if (keepA != keepB)
    {
      part.Corners[part.Size++] = a + heightA / (heightA - heightB) * (b - a);
    }
  }
  return part;
}

/// Returns the integral, over the projection of a polygon to the yz plane, of x - start, or of the
/// width if it is not negative. The integral is negative if the polygon faces -x.
double IntegrateShadow(const Polygon& polygon, double start, double width)
{
  double sum = 0.0;
  for (int i = 1; i + 1 < polygon.Size; ++i)
  {
    const Vector3 &a = polygon.Corners[0], &b = polygon.Corners[i], &c = polygon.Corners[i + 1];
    const double area = 0.5 * Cross(b - a, c - a)[0];
    sum += area * (width >= 0.0 ? width : (a[0] + b[0] + c[0]) / 3.0 - start);
  }
  return sum;
}

Polygon MakePolygon(const Triangle& triangle)
{
  Polygon polygon;
  polygon.Size = 3;
  std::copy(triangle.begin(), triangle.end(), polygon.Corners.begin());
  return polygon;
}

/// Returns the volume of the points of the box whose ray to +x hits the triangle; negative if
/// the triangle faces -x.
double MeasureShadow(const Triangle& triangle, const Vector3& lower, const Vector3& upper)
{
  Polygon part = MakePolygon(triangle);
  for (int axis = 1; axis < 3; ++axis)
  {
    part = ClipPolygon(ClipPolygon(part, axis, lower[axis], -1.0), axis, upper[axis], 1.0);
  }
  const Polygon within = ClipPolygon(ClipPolygon(part, 0, lower[0], -1.0), 0, upper[0], 1.0);
  const Polygon beyond = ClipPolygon(part, 0, upper[0], -1.0);
  return IntegrateShadow(within, lower[0], -1.0) +
    IntegrateShadow(beyond, 0.0, upper[0] - lower[0]);
}

/// Returns the part of the triangle in the box.
Polygon ClipToBox(const Triangle& triangle, const Vector3& lower, const Vector3& upper)
{
  Polygon part = MakePolygon(triangle);
  for (int axis = 0; axis < 3; ++axis)
  {
    part = ClipPolygon(ClipPolygon(part, axis, lower[axis], -1.0), axis, upper[axis], 1.0);
  }
  return part;
}

/// Sums over polygons from which the mean plane is computed.
struct SurfaceMoments
{
  Vector3 Normal{ { 0, 0, 0 } }, Center{ { 0, 0, 0 } }; // mean values times the area
  double Area = 0.0;

  void Add(const Polygon& polygon)
  {
    for (int i = 1; i + 1 < polygon.Size; ++i)
    {
      const Vector3 &a = polygon.Corners[0], &b = polygon.Corners[i], &c = polygon.Corners[i + 1];
      const Vector3 normal = 0.5 * Cross(b - a, c - a);
      const double area = Norm(normal);
      this->Normal = this->Normal + normal;
      this->Center = this->Center + area / 3.0 * (a + b + c);
      this->Area += area;
    }
  }
};

void Extend(Vector3& lower, Vector3& upper, const Vector3& point)
{
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = std::min(lower[a], point[a]);
    upper[a] = std::max(upper[a], point[a]);
  }
}

} // namespace

TriangleSolid::TriangleSolid(std::vector<Triangle> triangles) : Triangles(std::move(triangles))
{
  const Bounds empty{ { { INFINITY, INFINITY, INFINITY } },
    { { -INFINITY, -INFINITY, -INFINITY } } };
  this->All = empty;
  this->Boxes.assign(this->Triangles.size(), empty);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (const Vector3& corner : this->Triangles[t])
    {
      Extend(this->Boxes[t].Lower, this->Boxes[t].Upper, corner);
      Extend(this->All.Lower, this->All.Upper, corner);
    }
  }
  const double count = static_cast<double>(this->Triangles.size());
  this->Bins = std::min(1 + static_cast<int>(std::sqrt(count)), MaximumBins);

  this->Members = MakeGroups<int>(static_cast<std::size_t>(this->Bins) * this->Bins,
    [this](const auto& visit)
    {
      for (std::size_t t = 0; t < this->Triangles.size(); ++t)
      {
        this->ForBins(this->Boxes[t], [&](int bin) { visit(bin, static_cast<int>(t)); });
      }
    });
}

/// Calls visit(bin) for the bins that overlap a box.
template <class Visitor>
void TriangleSolid::ForBins(const Bounds& box, const Visitor& visit) const
{
  const std::array<int, 2> y = this->FindBins(0, box.Lower[1], box.Upper[1]);
  const std::array<int, 2> z = this->FindBins(1, box.Lower[2], box.Upper[2]);
  for (int k = z[0]; k <= z[1]; ++k)
  {
    for (int j = y[0]; j <= y[1]; ++j)
    {
      visit(k * this->Bins + j);
    }
  }
}

std::array<int, 2> TriangleSolid::FindBins(int axis, double low, double high) const
{
  const double start = this->All.Lower[axis + 1];
  const double width = this->All.Upper[axis + 1] - start;
  const double perLength = this->Bins / width; // infinite if the width is 0 or nearly
  const double scale = std::isfinite(perLength) ? perLength : 0.0;
  const auto find = [&](double x)
  {
    const double bin = std::floor((x - start) * scale);
    return static_cast<int>(std::min(std::max(bin, 0.0), this->Bins - 1.0));
  };
  return { { find(low), find(high) } };
}

template <class Visit>
void TriangleSolid::VisitColumn(
  const Vector3& lower, const Vector3& upper, const Visit& visit) const
{
  for (int a = 0; a < 3; ++a)
  {
    if (lower[a] > this->All.Upper[a] || (a > 0 && upper[a] < this->All.Lower[a]))
    {
      return;
    }
  }
  const std::array<int, 2> y = this->FindBins(0, lower[1], upper[1]);
  const std::array<int, 2> z = this->FindBins(1, lower[2], upper[2]);
  for (int k = z[0]; k <= z[1]; ++k)
  {
    for (int j = y[0]; j <= y[1]; ++j)
    {
      const int bin = k * this->Bins + j;
      for (Index m = this->Members.Begin[bin]; m < this->Members.Begin[bin + 1]; ++m)
      {
        const Bounds& box = this->Boxes[this->Members.Items[m]];
        if (box.Upper[0] < lower[0] || box.Lower[1] > upper[1] || box.Upper[1] < lower[1] ||
          box.Lower[2] > upper[2] || box.Upper[2] < lower[2])
        {
          continue;
        }
        // A triangle in several bins is visited in the first of them in the column.
        if (j == std::max(y[0], this->FindBins(0, box.Lower[1], box.Lower[1])[0]) &&
          k == std::max(z[0], this->FindBins(1, box.Lower[2], box.Lower[2])[0]) &&
          visit(this->Members.Items[m]))
        {
          return;
        }
      }
    }
  }
}

bool TriangleSolid::Meets(const Vector3& lower, const Vector3& upper) const
{
  bool meets = false;
  this->VisitColumn(lower, upper,
    [&](int t)
    {
      meets = this->Boxes[t].Lower[0] <= upper[0];
      return meets;
    });
  return meets;
}

double TriangleSolid::MeasureVolume(const Vector3& lower, const Vector3& upper) const
{
  double sum = 0.0;
  this->VisitColumn(lower, upper,
    [&](int t)
    {
      sum += MeasureShadow(this->Triangles[t], lower, upper);
      return false;
    });
  return sum;
}

double TriangleSolid::FitPlane(const Vector3& lower, const Vector3& upper, HalfSpace& plane) const
{
  const Vector3 edges = upper - lower;
  std::vector<Polygon> polygons;
  SurfaceMoments moments;
  this->VisitColumn(lower, upper,
    [&](int t)
    {
      if (this->Boxes[t].Lower[0] <= upper[0])
      {
        polygons.push_back(ClipToBox(this->Triangles[t], lower, upper));
        moments.Add(polygons.back());
      }
      return false;
    });
  const double length = Norm(moments.Normal);
  if (!(length > 0.0))
  {
    const bool inside = this->MeasureVolume(lower, upper) > 0.5 * edges[0] * edges[1] * edges[2];
    plane = { { { 0, 0, 1 } }, inside ? INFINITY : -INFINITY };
    return moments.Area > 0.0 ? INFINITY : 0.0;
  }
  plane.Normal = (1.0 / length) * moments.Normal;
  plane.Offset = Dot(plane.Normal, moments.Center) / moments.Area;
  if (length < LeastMeanNormal * moments.Area)
  {
    return INFINITY;
  }
  double deviation = 0.0;
  for (const Polygon& polygon : polygons)
  {
    for (int i = 0; i < polygon.Size; ++i)
    {
      deviation =
        std::max(deviation, std::abs(Dot(plane.Normal, polygon.Corners[i]) - plane.Offset));
    }
  }
  return deviation > SamePlane * Norm(edges) ? deviation * moments.Area : 0.0;
}

BoxQueries QueriesOf(std::shared_ptr<const TriangleSolid> solid)
{
  BoxQueries boxes;
  boxes.Meets = [solid](const Vector3& lower, const Vector3& upper)
  { return solid->Meets(lower, upper); };
  boxes.Volume = [solid](const Vector3& lower, const Vector3& upper)
  { return solid->MeasureVolume(lower, upper); };
  boxes.FitPlane = [solid](const Vector3& lower, const Vector3& upper, HalfSpace& plane)
  { return solid->FitPlane(lower, upper, plane); };
  return boxes;
}

Shape MakeSolid(
  int material, const ClosedSurface& surface, std::function<double(const Vector3&)> distance)
{
  return MakeFunctionShape(material, std::move(distance),
    QueriesOf(std::make_shared<const TriangleSolid>(PlaceTriangles(surface))));
}

} // namespace vfm
