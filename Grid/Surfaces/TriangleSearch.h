/**
 * TriangleSearch: finds the nearest of many triangles.
 */
#pragma once

#include "Base/BoxTree.h"
#include "Base/Vector3.h"
#include "Surfaces/ClosedSurface.h"

#include <cmath>

namespace vfm
{

/// Returns the point of a triangle that is nearest to x.
Vector3 NearestPoint(const Triangle& triangle, const Vector3& x);

/// Returns the way along a ray from x to a triangle or to a box, 0 inside the box; below 0 if it
/// does not meet the triangle, 1e301 if it does not meet the box.
double WayTo(const Triangle& triangle, const Vector3& x, const Vector3& direction);
double WayTo(const Bounds& box, const Vector3& x, const Vector3& direction);

/// The triangles of a surface in a search tree. The object is constant, so threads may use it at
/// the same time.
class TriangleSearch
{
public:
  TriangleSearch(std::vector<Triangle> triangles, Runtime& runtime);

  struct Nearest
  {
    int Triangle = -1; ///< -1: there is none within the limit
    Vector3 Point{};
    double Square = 0.0; ///< square of the distance; FindOnRay: of the way along the ray
  };
  /// Returns the nearest triangle at a distance of at most `limit`, of equally near ones the first.
  /// @param accepts  accepts(triangle) returns whether a triangle counts
  template <class Accepts>
  Nearest Find(const Vector3& x, double limit, const Accepts& accepts) const;
  Nearest Find(const Vector3& x, double limit) const
  {
    return this->Find(x, limit, [](int) { return true; });
  }

  /// A triangle with its rating, a distance with a penalty; smaller is better.
  struct Rated
  {
    int Triangle = -1; ///< -1: no rating is below Rating
    double Rating;
  };
  /// Returns the triangle with the smallest sum of its distance and penalty(triangle), which must
  /// not be negative; of equal ones the first. Returns `best` if no triangle is better.
  template <class Penalty>
  Rated FindBest(const Vector3& x, const Penalty& penalty, Rated best) const;

  /// Returns the nearest triangle that the ray x + t * direction meets; of equally near ones the
  /// first.
  /// @param direction  unit vector
  template <class Accepts>
  Nearest FindOnRay(const Vector3& x, const Vector3& direction, const Accepts& accepts) const;

  const Triangle& Corners(int triangle) const { return this->Triangles[triangle]; }
  /// Returns the unit normal of a triangle; 0 if it is a line or a point.
  const Vector3& Normal(int triangle) const { return this->Normals[triangle]; }
  double Diagonal() const { return this->Length; } ///< of the box around all triangles

private:
  std::vector<Triangle> Triangles;
  std::vector<Vector3> Normals;
  double Length = 0.0;
  BoxTree Tree;
};

template <class Accepts>
TriangleSearch::Nearest TriangleSearch::Find(
  const Vector3& x, double limit, const Accepts& accepts) const
{
  Nearest best{ -1, {}, limit * limit };
  this->Tree.ForNear([&x](const Bounds& box) { return box.SquareTo(x); }, best.Square,
    [&](int t)
    {
      if (!accepts(t))
      {
        return;
      }
      const Vector3 point = NearestPoint(this->Triangles[t], x);
      const double square = Dot(point - x, point - x);
      if (square < best.Square ||
        (square == best.Square && (best.Triangle < 0 || t < best.Triangle)))
      {
        best = { t, point, square };
      }
    });
  return best;
}

template <class Penalty>
TriangleSearch::Rated TriangleSearch::FindBest(
  const Vector3& x, const Penalty& penalty, Rated best) const
{
  this->Tree.ForNear([&x](const Bounds& box) { return std::sqrt(box.SquareTo(x)); }, best.Rating,
    [&](int t)
    {
      const double extra = penalty(t);
      if (extra > best.Rating)
      {
        return;
      }
      const double rating = Norm(NearestPoint(this->Triangles[t], x) - x) + extra;
      if (rating < best.Rating || (rating == best.Rating && t < best.Triangle))
      {
        best = { t, rating };
      }
    });
  return best;
}

template <class Accepts>
TriangleSearch::Nearest TriangleSearch::FindOnRay(
  const Vector3& x, const Vector3& direction, const Accepts& accepts) const
{
  int best = -1;
  double way = 1e300;
  this->Tree.ForNear([&](const Bounds& box) { return WayTo(box, x, direction); }, way,
    [&](int t)
    {
      const double to = accepts(t) ? WayTo(this->Triangles[t], x, direction) : -1.0;
      if (to >= 0.0 && (to < way || (to == way && t < best)))
      {
        best = t;
        way = to;
      }
    });
  return best < 0 ? Nearest() : Nearest{ best, x + way * direction, way * way };
}

} // namespace vfm
