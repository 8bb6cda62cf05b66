/**
 * Triangles of boxes for tests of surfaces.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

#include <algorithm>

namespace vfm
{
namespace testing
{

/// Triangles as in a file.
struct LooseTriangles
{
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;

  void Add(const LooseTriangles& other)
  {
    const Index first = static_cast<Index>(this->Points.size());
    this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
    for (const PointTriangle& t : other.Triangles)
    {
      this->Triangles.push_back({ { first + t[0], first + t[1], first + t[2] } });
    }
  }
};

/// Returns a box; if it is turned, its triangles face inwards.
inline LooseTriangles MakeBox(const Vector3& lower, const Vector3& upper, bool isTurned = false)
{
  LooseTriangles box;
  for (int p = 0; p < 8; ++p)
  {
    box.Points.push_back({ { p & 1 ? upper[0] : lower[0], p & 2 ? upper[1] : lower[1],
      p & 4 ? upper[2] : lower[2] } });
  }
  const std::array<std::array<Index, 4>, 6> sides{ { { { 0, 4, 6, 2 } }, { { 1, 3, 7, 5 } },
    { { 0, 1, 5, 4 } }, { { 2, 6, 7, 3 } }, { { 0, 2, 3, 1 } }, { { 4, 5, 7, 6 } } } };
  for (const auto& s : sides)
  {
    box.Triangles.push_back({ { s[0], s[1], s[2] } });
    box.Triangles.push_back({ { s[0], s[2], s[3] } });
  }
  for (PointTriangle& t : box.Triangles)
  {
    if (isTurned)
    {
      std::swap(t[1], t[2]);
    }
  }
  return box;
}

inline LooseTriangles Join(LooseTriangles one, const LooseTriangles& other)
{
  one.Add(other);
  return one;
}

/// Returns triangles without common points.
inline LooseTriangles Separate(const LooseTriangles& joined)
{
  LooseTriangles apart;
  for (const PointTriangle& t : joined.Triangles)
  {
    const Index first = static_cast<Index>(apart.Points.size());
    for (Index p : t)
    {
      apart.Points.push_back(joined.Points[p]);
    }
    apart.Triangles.push_back({ { first, first + 1, first + 2 } });
  }
  return apart;
}

} // namespace testing
} // namespace vfm
