#include "SharpFeatures/BoxCut.h"

namespace vfm
{
namespace
{

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

/// Convex polygon: the part of the square [-1/2,1/2]^2 that up to four lines leave.
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
    std::array<double, MaximumCorners> height, x, y;
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
  /// A line adds one corner. Where rounding bends sides, it adds one per two: 4, 6, 9, 13, 19.
  static constexpr int MaximumCorners = 19;

  void Add(double x, double y)
  {
    this->X[this->Count] = x;
    this->Y[this->Count++] = y;
  }

  int Count = 0;
  std::array<double, MaximumCorners> X, Y;
};

/// Returns the line that bounds the inside of a plane on the face of the cube at x[axis] = value.
Line OnFace(const BoxPlane& plane, int axis, double value)
{
  return { plane.Normal[(axis + 1) % 3], plane.Normal[(axis + 2) % 3],
    plane.Height + plane.Normal[axis] * value };
}

/// Measures the part of plane k that bounds the inside of all planes of the mask.
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

double CutBox(const std::array<BoxPlane, 3>& planes, int mask, std::array<PlaneRates, 3>& rates)
{
  // Divergence theorem for x - corner, the innermost corner: the three faces there contribute 0.
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
