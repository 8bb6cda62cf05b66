#include "Creases/CreasePlaces.h"

#include <Eigen/LU>

#include <limits>

namespace vfm
{
namespace
{

constexpr int SideSteps = 4, EdgeSteps = 4, CornerSteps = 8; // of Newton
constexpr double SmallestEdgeSine = 0.02;     // squared, between the normals of two surfaces
constexpr double SmallestCornerVolume = 0.1;  // of the normals of three
constexpr double FarthestCorner = 3.0;        // in cells
constexpr double Lost = 2.0 * FarthestCorner; // where Newton is not followed

Vector3 FootOn(const LocalQuadric& surface, Vector3 y, Vector3& normal)
{
  for (int step = 0; step < SideSteps; ++step)
  {
    const double distance = DistanceTo(surface, y, normal);
    y = y - distance * normal;
  }
  return y;
}

/// From y to where two surfaces meet.
std::optional<Vector3> PointOfEdge(const LocalQuadric& a, const LocalQuadric& b, Vector3 y)
{
  for (int step = 0; step < EdgeSteps; ++step)
  {
    Vector3 na, nb;
    const double da = DistanceTo(a, y, na), db = DistanceTo(b, y, nb);
    const double cosine = Dot(na, nb), sine = 1.0 - cosine * cosine;
    if (sine < SmallestEdgeSine)
    {
      return std::nullopt;
    }
    y = y + ((cosine * db - da) / sine) * na + ((cosine * da - db) / sine) * nb;
  }
  return y;
}

/// Whether the second label ends at surface k where the point is inside of `others` of the others, or of some of the mask too.
bool Counts(const CreaseModel& model, int k, int mask, int others)
{
  for (int bits = 0; bits < 1 << model.Count; ++bits)
  {
    const bool isState = (bits & ~mask) == 0 && !(bits >> k & 1);
    if (isState && IsInside(model, others | bits) != IsInside(model, others | bits | 1 << k))
    {
      return true;
    }
  }
  return false;
}

} // namespace

bool IsBoundary(const CreaseModel& model, int mask, const Vector3& y)
{
  int others = 0;
  for (int k = 0; k < model.Count; ++k)
  {
    Vector3 normal;
    others |= (!(mask >> k & 1) && DistanceTo(model.Surfaces[k], y, normal) > 0.0) << k;
  }
  for (int k = 0; k < model.Count; ++k)
  {
    if (mask >> k & 1 && !Counts(model, k, mask, others))
    {
      return false;
    }
  }
  return true;
}

SidePlace FindSide(const CreaseModel& model, const Vector3& y)
{
  SidePlace best{};
  double nearest = std::numeric_limits<double>::max();
  bool isBoundary = false;
  for (int k = 0; k < model.Count; ++k)
  {
    Vector3 normal;
    const Vector3 foot = FootOn(model.Surfaces[k], y, normal);
    const double distance = Norm(foot - y);
    const bool bounds = IsBoundary(model, 1 << k, foot);
    if (bounds != isBoundary ? bounds : distance < nearest)
    {
      best = { k, foot, normal, distance };
      nearest = distance;
      isBoundary = bounds;
    }
  }
  return best;
}

std::optional<EdgePlace> FindEdge(const CreaseModel& model, const Vector3& y)
{
  std::optional<EdgePlace> best;
  for (int i = 0; i < model.Count; ++i)
  {
    for (int j = i + 1; j < model.Count; ++j)
    {
      const std::optional<Vector3> point = PointOfEdge(model.Surfaces[i], model.Surfaces[j], y);
      if (point && (!best || Norm(*point - y) < best->Distance) &&
        IsBoundary(model, 1 << i | 1 << j, *point))
      {
        best = { { { i, j } }, *point, Norm(*point - y) };
      }
    }
  }
  return best;
}

std::optional<Vector3> FindCorner(const CreaseModel& model, const Vector3& y)
{
  if (model.Count < 3)
  {
    return std::nullopt;
  }
  Vector3 point = y;
  for (int step = 0; step < CornerSteps; ++step)
  {
    Eigen::Matrix3d normals;
    Eigen::Vector3d distances;
    for (int k = 0; k < 3; ++k)
    {
      Vector3 normal;
      distances[k] = DistanceTo(model.Surfaces[k], point, normal);
      normals.row(k) << normal[0], normal[1], normal[2];
    }
    if (std::fabs(normals.determinant()) < SmallestCornerVolume)
    {
      return std::nullopt;
    }
    const Eigen::Vector3d move = normals.partialPivLu().solve(distances);
    point = point - Vector3{ { move[0], move[1], move[2] } };
    if (!(Norm(point - y) < Lost))
    {
      return std::nullopt;
    }
  }
  return Norm(point - y) < FarthestCorner ? std::optional<Vector3>(point) : std::nullopt;
}

} // namespace vfm
