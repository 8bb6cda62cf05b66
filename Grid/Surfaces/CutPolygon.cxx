#include "Surfaces/CutPolygon.h"

namespace vfm
{
namespace
{

/// Returns the point of the edge between two corners at a coordinate between theirs.
Vector3 CutEdge(const Vector3& a, const Vector3& b, int axis, double value)
{
  const Vector3 &low = a[axis] < b[axis] ? a : b, &high = a[axis] < b[axis] ? b : a;
  const double part = (value - low[axis]) / (high[axis] - low[axis]);
  Vector3 point;
  for (int i = 0; i < 3; ++i)
  {
    const double x = low[i] + part * (high[i] - low[i]);
    point[i] = std::min(std::max(x, std::min(low[i], high[i])), std::max(low[i], high[i]));
  }
  point[axis] = value;
  return point;
}

} // namespace

Interval CutPolygon::Extent(int axis) const
{
  Interval extent{ this->Corners[0][axis], this->Corners[0][axis] };
  for (int i = 1; i < this->Size; ++i)
  {
    extent.Low = std::min(extent.Low, this->Corners[i][axis]);
    extent.High = std::max(extent.High, this->Corners[i][axis]);
  }
  return extent;
}

CutPolygon CutBetween(const CutPolygon& polygon, int axis, const Interval& range)
{
  const Interval extent = polygon.Extent(axis);
  if (extent.Low >= range.Low && extent.High <= range.High)
  {
    return polygon;
  }
  CutPolygon part;
  for (int i = 0; i < polygon.Size; ++i)
  {
    const Vector3& a = polygon.Corners[i];
    const Vector3& b = polygon.Corners[i + 1 < polygon.Size ? i + 1 : 0];
    if (a[axis] >= range.Low && a[axis] <= range.High)
    {
      part.Corners[part.Size++] = a;
    }
    const bool rises = a[axis] < b[axis];
    for (double plane : { rises ? range.Low : range.High, rises ? range.High : range.Low })
    {
      if ((a[axis] < plane && plane < b[axis]) || (b[axis] < plane && plane < a[axis]))
      {
        part.Corners[part.Size++] = CutEdge(a, b, axis, plane);
      }
    }
  }
  return part;
}

} // namespace vfm
