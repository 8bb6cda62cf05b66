#include "SharpFeatures/FeaturePlaces.h"

#include <Eigen/LU>

#include <limits>

namespace vfm
{
namespace
{

constexpr int SideSteps = 4, EdgeSteps = 4, CornerSteps = 8; // Newton iterations
constexpr double Hair = 1e-6;             // largest distance of a point on a surface, in cells
constexpr double SmallestEdgeSine = 0.02; // square of the sine, between the normals of two surfaces
// Determinant of three unit normals; flatter corners are parts of curved sides.
constexpr double SmallestCornerVolume = 0.5;
constexpr double FarthestCorner = 4.0;        // distance in cells
constexpr double Lost = 2.0 * FarthestCorner; // distance at which Newton iterations stop

/// Moves y to the line where surfaces i and j meet.
std::optional<EdgePlace> PointOfEdge(const FeatureModel& model, int i, int j, const Vector3& y)
{
  EdgePlace edge{ { { i, j } }, y, 0.0, {} };
  for (int step = 0; step < EdgeSteps; ++step)
  {
    Vector3 &ni = edge.Normals[0], &nj = edge.Normals[1];
    const double di = DistanceTo(model.Surfaces[i], edge.Point, ni);
    const double dj = DistanceTo(model.Surfaces[j], edge.Point, nj);
    const double cosine = Dot(ni, nj), sine = 1.0 - cosine * cosine;
    if (sine < SmallestEdgeSine)
    {
      return std::nullopt;
    }
    edge.Point = edge.Point + ((cosine * dj - di) / sine) * ni + ((cosine * di - dj) / sine) * nj;
  }
  edge.Distance = Norm(edge.Point - y);
  return edge;
}

/// Returns whether the second label ends at surface k, for a point inside the surfaces `others` and
/// inside some of the surfaces of the mask.
bool Counts(const FeatureModel& model, int k, int mask, int others)
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

bool IsBoundary(const FeatureModel& model, int mask, const Vector3& y)
{
  int others = 0, unsure = 0; // surfaces outside the mask that y is inside, or on
  for (int k = 0; k < model.Count; ++k)
  {
    Vector3 normal;
    const double distance = mask >> k & 1 ? -1.0 : DistanceTo(model.Surfaces[k], y, normal);
    others |= (distance > Hair) << k;
    unsure |= (std::fabs(distance) <= Hair) << k;
  }
  for (int some = unsure;; some = (some - 1) & unsure)
  {
    bool counts = true;
    for (int k = 0; k < model.Count; ++k)
    {
      counts = counts && (!(mask >> k & 1) || Counts(model, k, mask, others | some));
    }
    if (counts || some == 0)
    {
      return counts;
    }
  }
}

SidePlace FindSide(const FeatureModel& model, const Vector3& y)
{
  SidePlace best{};
  double nearest = std::numeric_limits<double>::max();
  bool isBoundary = false;
  for (int k = 0; k < model.Count; ++k)
  {
    Vector3 normal;
    const Vector3 foot = FootOn(model.Surfaces[k], y, SideSteps, normal);
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

std::optional<EdgePlace> FindEdge(const FeatureModel& model, const Vector3& y)
{
  std::optional<EdgePlace> best;
  for (int i = 0; i < model.Count; ++i)
  {
    for (int j = i + 1; j < model.Count; ++j)
    {
      const std::optional<EdgePlace> edge = PointOfEdge(model, i, j, y);
      if (edge && (!best || edge->Distance < best->Distance) &&
        IsBoundary(model, 1 << i | 1 << j, edge->Point))
      {
        best = edge;
      }
    }
  }
  return best;
}

std::optional<CornerPlace> FindCorner(const FeatureModel& model, const Vector3& y)
{
  if (model.Count < 3)
  {
    return std::nullopt;
  }
  CornerPlace corner{ y, 0.0, 1.0 };
  std::array<Vector3, 3> normals;
  for (int step = 0; step < CornerSteps; ++step)
  {
    Eigen::Matrix3d rows;
    Eigen::Vector3d distances;
    for (int k = 0; k < 3; ++k)
    {
      distances[k] = DistanceTo(model.Surfaces[k], corner.Point, normals[k]);
      rows.row(k) << normals[k][0], normals[k][1], normals[k][2];
    }
    if (std::fabs(rows.determinant()) < SmallestCornerVolume)
    {
      return std::nullopt;
    }
    const Eigen::Vector3d move = rows.partialPivLu().solve(distances);
    corner.Point = corner.Point - Vector3{ { move[0], move[1], move[2] } };
    corner.Distance = Norm(corner.Point - y);
    if (!(corner.Distance < Lost))
    {
      return std::nullopt;
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    corner.Bluntness = std::min(corner.Bluntness, BluntnessOf(normals[k], normals[(k + 1) % 3]));
  }
  return corner.Distance < FarthestCorner ? std::optional<CornerPlace>(corner) : std::nullopt;
}

} // namespace vfm
