#include "Surfaces/SharedCells.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

// Rays lie on a lattice of Fibonacci numbers, which is even in all directions.
constexpr int RayCount = 55, RayStep = 34;
constexpr double NegligiblePart = 1e-9; // of a cell; rounding of surfaces in contact

/// Point where the edge of a triangle crosses a plane normal to y.
struct EdgePoint
{
  double X, Z;
};

EdgePoint CutEdge(const Vector3& a, const Vector3& b, double y)
{
  const Vector3 &low = a[1] < b[1] ? a : b, &high = a[1] < b[1] ? b : a;
  const double part = (y - low[1]) / (high[1] - low[1]);
  return { low[0] + part * (high[0] - low[0]), low[2] + part * (high[2] - low[2]) };
}

/// Winding number of a body at a place of a ray; not 0.
struct Inside
{
  int Body, Winding;
};

void Count(int body, int sign, std::vector<Inside>& insides)
{
  const auto found = std::find_if(
    insides.begin(), insides.end(), [body](const Inside& inside) { return inside.Body == body; });
  if (found == insides.end())
  {
    insides.push_back({ body, sign });
  }
  else if ((found->Winding += sign) == 0)
  {
    *found = insides.back();
    insides.pop_back();
  }
}

/// Adds a piece of a ray to the parts of a cell.
/// @param first,last  shared cells of the cell
void AddPiece(
  double length, const std::vector<Inside>& insides, SharedCell* first, const SharedCell* last)
{
  for (SharedCell* cell = first; cell != last; ++cell)
  {
    bool isInEarlier = false, isIn = false;
    for (const Inside& inside : insides)
    {
      isInEarlier = isInEarlier || (inside.Body < cell->Body && inside.Winding > 0);
      isIn = isIn || (inside.Body == cell->Body && inside.Winding > 0);
    }
    cell->Parts[(isIn ? 2 : 0) + (isInEarlier ? 1 : 0)] += length;
  }
}

/// Returns the common part x of two events with the probabilities a and b, a + b <= 1, for which
/// both * neither' / (only' * other') has the given ratio product / cross.
double CommonPart(double a, double b, double product, double cross)
{
  const double sum = cross + (a + b) * (product - cross);
  const double root = std::max(0.0, sum * sum - 4.0 * product * (product - cross) * a * b);
  const double divisor = sum + std::sqrt(root);
  return divisor > 0.0 ? std::min(2.0 * product * a * b / divisor, std::min(a, b)) : 0.0;
}

} // namespace

RowRays::RowRays() : Rays(RayCount) {}

void RowRays::Begin(const Interval& y, const Interval& z)
{
  for (int r = 0; r < RayCount; ++r)
  {
    Ray& ray = this->Rays[r];
    ray.Y = y.Low + (r + 0.5) / RayCount * (y.High - y.Low);
    ray.Z = z.Low + (r * RayStep % RayCount + 0.5) / RayCount * (z.High - z.Low);
    ray.Crossings.clear();
  }
}

void RowRays::Add(const CutPolygon& triangle, int body)
{
  const Interval extent = triangle.Extent(1);
  const auto first = std::lower_bound(this->Rays.begin(), this->Rays.end(), extent.Low,
    [](const Ray& ray, double y) { return ray.Y < y; });
  for (auto ray = first; ray != this->Rays.end() && ray->Y < extent.High; ++ray)
  {
    EdgePoint rising{}, falling{};
    for (int i = 0; i < 3; ++i)
    {
      const Vector3 &a = triangle.Corners[i], &b = triangle.Corners[i < 2 ? i + 1 : 0];
      if ((a[1] > ray->Y) != (b[1] > ray->Y))
      {
        (a[1] < b[1] ? rising : falling) = CutEdge(a, b, ray->Y);
      }
    }
    if ((rising.Z > ray->Z) != (falling.Z > ray->Z))
    {
      const double part = (ray->Z - rising.Z) / (falling.Z - rising.Z);
      const double x = rising.X + part * (falling.X - rising.X);
      ray->Crossings.push_back({ x, body, rising.Z > ray->Z ? 1 : -1 });
    }
  }
}

void RowRays::Measure(const std::vector<double>& nodes, std::vector<SharedCell>& cells)
{
  for (Ray& ray : this->Rays)
  {
    std::sort(ray.Crossings.begin(), ray.Crossings.end(),
      [](const Crossing& a, const Crossing& b) { return a.X < b.X; });
    MeasureRay(ray, nodes, cells);
  }
}

void RowRays::MeasureRay(
  const Ray& ray, const std::vector<double>& nodes, std::vector<SharedCell>& cells)
{
  std::vector<Inside> insides;
  auto crossing = ray.Crossings.begin();
  SharedCell* const end = cells.data() + cells.size();
  for (SharedCell *first = cells.data(), *last = first; first != end; first = last)
  {
    const Index cell = first->Cell;
    last = std::find_if(first, end, [cell](const SharedCell& other) { return other.Cell != cell; });
    const double high = nodes[cell + 1], length = (high - nodes[cell]) * RayCount;
    double x = nodes[cell];
    for (; crossing != ray.Crossings.end() && crossing->X < high; ++crossing)
    {
      if (crossing->X > x)
      {
        AddPiece((crossing->X - x) / length, insides, first, last);
        x = crossing->X;
      }
      Count(crossing->Body, crossing->Sign, insides);
    }
    AddPiece((high - x) / length, insides, first, last);
  }
}

double FractionBesideEarlier(double earlier, double own, const std::array<double, 4>& parts)
{
  const auto part = [&parts](int i) { return parts[i] < NegligiblePart ? 0.0 : parts[i]; };
  if (part(1) + part(2) + part(3) == 0.0)
  {
    return own - std::min(earlier, own); // no ray meets them: the smaller may be inside the other
  }
  if (part(3) == 0.0)
  {
    return own;
  }
  const double product = part(0) * part(3), cross = part(1) * part(2);
  if (cross == 0.0)
  {
    return own - std::min(earlier, own); // one is inside the other
  }
  return earlier + own <= 1.0
    ? own - CommonPart(earlier, own, product, cross)
    : 1.0 - earlier - CommonPart(1.0 - earlier, 1.0 - own, product, cross);
}

} // namespace vfm
