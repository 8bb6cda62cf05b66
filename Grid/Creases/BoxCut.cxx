#include "Creases/BoxCut.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Area and first moments of a part of a square.
struct SquarePart
{
  double Area, X, Y;
};

/// Of the unit square [0,1]^2 where p x + q y < beta <= (p + q) / 2; 0 <= p <= q.
SquarePart UnderLowLine(double p, double q, double beta)
{
  const double left = beta / q;
  if (beta < p)
  {
    const double x = beta / p, area = 0.5 * x * left;
    return { area, area * x / 3.0, area * left / 3.0 };
  }
  const double right = (beta - p) / q;
  return { 0.5 * (left + right), left / 6.0 + right / 3.0,
    (left * left + left * right + right * right) / 6.0 };
}

SquarePart UnderLine(double p, double q, double beta)
{
  const double size = p + q;
  if (beta <= 0.0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  if (beta >= size)
  {
    return { 1.0, 0.5, 0.5 };
  }
  const bool low = beta <= 0.5 * size;
  SquarePart part = UnderLowLine(std::min(p, q), std::max(p, q), low ? beta : size - beta);
  if (p > q)
  {
    std::swap(part.X, part.Y);
  }
  if (!low)
  {
    part = { 1.0 - part.Area, 0.5 - part.Area + part.X, 0.5 - part.Area + part.Y };
  }
  return part;
}

int LargestOf(const Vector3& n)
{
  const double x = std::fabs(n[0]), y = std::fabs(n[1]), z = std::fabs(n[2]);
  return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}

/// a x + b y + c >= 0.
struct Line
{
  double A, B, C;
};

/// A convex polygon: what up to four lines leave of the square [-1/2,1/2]^2.
class SquarePolygon
{
public:
  SquarePolygon()
  {
    this->Add(-0.5, -0.5);
    this->Add(0.5, -0.5);
    this->Add(0.5, 0.5);
    this->Add(-0.5, 0.5);
  }

  void Clip(const Line& line)
  {
    const double reach = 0.5 * (std::fabs(line.A) + std::fabs(line.B));
    if (line.C >= reach || this->Count == 0)
    {
      return;
    }
    if (line.C <= -reach)
    {
      this->Count = 0;
      return;
    }
    std::array<double, Most> height, x, y;
    const int n = this->Count;
    for (int i = 0; i < n; ++i)
    {
      x[i] = this->X[i];
      y[i] = this->Y[i];
      height[i] = line.A * x[i] + line.B * y[i] + line.C;
    }
    this->Count = 0;
    for (int i = n - 1, j = 0; j < n; i = j++)
    {
      if ((height[i] >= 0.0) != (height[j] >= 0.0))
      {
        const double t = height[i] / (height[i] - height[j]);
        this->Add(x[i] + t * (x[j] - x[i]), y[i] + t * (y[j] - y[i]));
      }
      if (height[j] >= 0.0)
      {
        this->Add(x[j], y[j]);
      }
    }
  }

  SquarePart Measure() const
  {
    SquarePart sum{ 0.0, 0.0, 0.0 };
    for (int i = this->Count - 1, j = 0; j < this->Count; i = j++)
    {
      const double cross = this->X[i] * this->Y[j] - this->X[j] * this->Y[i];
      sum.Area += cross;
      sum.X += cross * (this->X[i] + this->X[j]);
      sum.Y += cross * (this->Y[i] + this->Y[j]);
    }
    return { 0.5 * sum.Area, sum.X / 6.0, sum.Y / 6.0 };
  }

private:
  /// A line adds one corner; one more for every two, where rounding bends sides: 4, 6, 9, 13, 19.
  static constexpr int Most = 19;

  void Add(double x, double y)
  {
    this->X[this->Count] = x;
    this->Y[this->Count++] = y;
  }

  int Count = 0;
  std::array<double, Most> X, Y;
};

/// Where a plane is inside on the face of the cube at x[axis] = value.
Line OnFace(const BoxPlane& plane, int axis, double value)
{
  return { plane.Normal[(axis + 1) % 3], plane.Normal[(axis + 2) % 3],
    plane.Height + plane.Normal[axis] * value };
}

/// The part of plane k that bounds what is inside of all planes of the mask.
PlaneRates SectionOf(const std::array<BoxPlane, 3>& planes, int mask, int k)
{
  const BoxPlane& plane = planes[k];
  const int axis = LargestOf(plane.Normal), b = (axis + 1) % 3, c = (axis + 2) % 3;
  const double inverse = 1.0 / plane.Normal[axis];
  // x[axis] on the plane
  const Line z{ -plane.Normal[b] * inverse, -plane.Normal[c] * inverse, -plane.Height * inverse };
  SquarePolygon polygon;
  polygon.Clip({ z.A, z.B, 0.5 + z.C });
  polygon.Clip({ -z.A, -z.B, 0.5 - z.C });
  for (int other = 0; other < 3; ++other)
  {
    if (other != k && (mask >> other & 1))
    {
      const Line line = OnFace(planes[other], axis, 0.0);
      const double n = planes[other].Normal[axis];
      polygon.Clip({ line.A + n * z.A, line.B + n * z.B, line.C + n * z.C });
    }
  }
  const SquarePart part = polygon.Measure();
  const double scale = std::fabs(inverse);
  PlaneRates rates{ scale * part.Area, {} };
  rates.ByNormal[b] = scale * part.X;
  rates.ByNormal[c] = scale * part.Y;
  rates.ByNormal[axis] = scale * (z.A * part.X + z.B * part.Y + z.C * part.Area);
  return rates;
}

} // namespace

double CutBox(const BoxPlane& plane, PlaneRates& rates)
{
  const Vector3& n = plane.Normal;
  const int axis = LargestOf(n), b = (axis + 1) % 3, c = (axis + 2) % 3;
  // Reflected into [0,1]^3 where p . s < alpha, p >= 0.
  const double p = std::fabs(n[axis]), pb = std::fabs(n[b]), pc = std::fabs(n[c]);
  const double alpha = plane.Height + 0.5 * (p + pb + pc), inverse = 1.0 / p;
  const SquarePart below = UnderLine(pb, pc, alpha), above = UnderLine(pb, pc, alpha - p);
  const double area = below.Area - above.Area, x = below.X - above.X, y = below.Y - above.Y;
  const double height = (alpha * area - pb * x - pc * y) * inverse;
  rates.ByHeight = area * inverse;
  rates.ByNormal[b] = (n[b] < 0.0 ? -1.0 : 1.0) * (0.5 * area - x) * inverse;
  rates.ByNormal[c] = (n[c] < 0.0 ? -1.0 : 1.0) * (0.5 * area - y) * inverse;
  rates.ByNormal[axis] = (n[axis] < 0.0 ? -1.0 : 1.0) * (0.5 * area - height) * inverse;
  return height + above.Area;
}

double CutBox(const std::array<BoxPlane, 3>& planes, int mask, std::array<PlaneRates, 3>& rates)
{
  // By the divergence of x - corner: the faces at the corner, the most inner one, add nothing.
  Vector3 inner{};
  for (int k = 0; k < 3; ++k)
  {
    inner = mask >> k & 1 ? inner + planes[k].Normal : inner;
  }
  Vector3 corner;
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = inner[axis] < 0.0 ? -0.5 : 0.5;
    SquarePolygon face;
    for (int k = 0; k < 3; ++k)
    {
      if (mask >> k & 1)
      {
        face.Clip(OnFace(planes[k], axis, -corner[axis]));
      }
    }
    sum += face.Measure().Area;
  }
  for (int k = 0; k < 3; ++k)
  {
    if (mask >> k & 1)
    {
      rates[k] = SectionOf(planes, mask, k);
      sum += (planes[k].Height + Dot(planes[k].Normal, corner)) * rates[k].ByHeight;
    }
  }
  return sum / 3.0;
}

} // namespace vfm
