#include "Base/ConvexClip.h"

#include "Base/HexNumbering.h"
#include "Base/PortableMath.h"
#include "Base/Vector3.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

constexpr double OnPlane = 1e-14; // tolerance relative to the lengths that the height is made from

/// Sorts the corners of a convex polygon counter-clockwise about the normal and removes duplicates.
void SortAround(const Vector3& normal, std::vector<Vector3>& points)
{
  Vector3 center{ { 0, 0, 0 } };
  for (const Vector3& p : points)
  {
    center = center + (1.0 / static_cast<double>(points.size())) * p;
  }
  int axis = 0; // axis with the smallest component of the normal
  for (int a = 1; a < 3; ++a)
  {
    axis = std::abs(normal[a]) < std::abs(normal[axis]) ? a : axis;
  }
  Vector3 unit{ { 0, 0, 0 } };
  unit[axis] = 1.0;
  const Vector3 u = Cross(normal, unit), v = Cross(normal, u);
  std::vector<std::pair<double, Vector3>> sorted;
  sorted.reserve(points.size());
  for (const Vector3& p : points)
  {
    const Vector3 d = p - center;
    sorted.emplace_back(ArcTangent(Dot(v, d), Dot(u, d)), p);
  }
  std::sort(sorted.begin(), sorted.end());
  points.clear();
  for (const auto& item : sorted)
  {
    if (points.empty() || points.back() != item.second)
    {
      points.push_back(item.second);
    }
  }
}

/// Ends the face that began at `first`, or removes it if it has fewer than three corners.
void CloseFace(ConvexPiece& piece, std::size_t first)
{
  if (piece.Points.size() - first < 3)
  {
    piece.Points.resize(first);
    return;
  }
  piece.Ends.push_back(piece.Points.size());
}

/// Returns the heights of the corners over the plane and updates the lowest and the
/// highest. Heights within rounding error become 0, so that the plane does not cut again a
/// face that it made before.
std::vector<double> MeasureHeights(
  const ConvexPiece& piece, const HalfSpace& plane, double& lowest, double& highest)
{
  std::vector<double> height(piece.Points.size());
  double size = 0.0;
  for (const Vector3& p : piece.Points)
  {
    const Vector3 d = p - piece.Points[0];
    size = std::max({ size, std::abs(d[0]), std::abs(d[1]), std::abs(d[2]) });
  }
  for (std::size_t i = 0; i < height.size(); ++i)
  {
    const Vector3& p = piece.Points[i];
    height[i] = Dot(plane.Normal, p) - plane.Offset;
    const double rounding =
      OnPlane * (size + std::abs(plane.Offset) + std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]));
    height[i] = std::abs(height[i]) <= rounding && std::isfinite(rounding) ? 0.0 : height[i];
    lowest = std::min(lowest, height[i]);
    highest = std::max(highest, height[i]);
  }
  return height;
}

} // namespace

ConvexPiece MakeBoxPiece(const Vector3& lower, const Vector3& upper)
{
  ConvexPiece piece;
  piece.Points.reserve(24);
  for (const auto& face : FaceCorners)
  {
    for (int c : face)
    {
      piece.Points.push_back({ { c & 1 ? upper[0] : lower[0], c & 2 ? upper[1] : lower[1],
        c & 4 ? upper[2] : lower[2] } });
    }
    piece.Ends.push_back(piece.Points.size());
  }
  return piece;
}

double ComputeVolume(const ConvexPiece& piece)
{
  double sum = 0.0;
  std::size_t first = 0;
  for (std::size_t end : piece.Ends)
  {
    const Vector3 a = piece.Points[first] - piece.Points[0];
    for (std::size_t i = first + 1; i + 1 < end; ++i)
    {
      sum +=
        Dot(a, Cross(piece.Points[i] - piece.Points[0], piece.Points[i + 1] - piece.Points[0]));
    }
    first = end;
  }
  return std::max(sum / 6.0, 0.0);
}

void ClipPiece(const ConvexPiece& piece, const HalfSpace& plane, ConvexPiece& inside,
  ConvexPiece& outside, std::vector<Vector3>& section)
{
  inside.Clear();
  outside.Clear();
  section.clear();
  double lowest = 0.0, highest = 0.0;
  const std::vector<double> height = MeasureHeights(piece, plane, lowest, highest);
  if (highest <= 0.0 || lowest >= 0.0)
  {
    (highest <= 0.0 ? inside : outside) = piece;
    return;
  }
  std::size_t first = 0;
  for (std::size_t end : piece.Ends)
  {
    const std::size_t firstInside = inside.Points.size(), firstOutside = outside.Points.size();
    for (std::size_t i = first; i < end; ++i)
    {
      const std::size_t next = i + 1 < end ? i + 1 : first;
      const bool in = height[i] <= 0.0;
      (in ? inside : outside).Points.push_back(piece.Points[i]);
      if (in != (height[next] <= 0.0))
      {
        // Computed from the inner end: both faces of the edge get the same point.
        const std::size_t a = in ? i : next, b = in ? next : i;
        const Vector3 cut = piece.Points[a] +
          height[a] / (height[a] - height[b]) * (piece.Points[b] - piece.Points[a]);
        inside.Points.push_back(cut);
        outside.Points.push_back(cut);
        section.push_back(cut);
      }
    }
    CloseFace(inside, firstInside);
    CloseFace(outside, firstOutside);
    first = end;
  }
  SortAround(plane.Normal, section);
  if (section.size() < 3)
  {
    section.clear();
    return;
  }
  inside.Points.insert(inside.Points.end(), section.begin(), section.end());
  inside.Ends.push_back(inside.Points.size());
  outside.Points.insert(outside.Points.end(), section.rbegin(), section.rend());
  outside.Ends.push_back(outside.Points.size());
}

} // namespace vfm
