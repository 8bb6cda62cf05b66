#include "Surfaces/SurfaceThickness.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace vfm
{
namespace
{

constexpr double LargestCosine = -0.5; // between normals of opposed triangles
constexpr int MaximumSteps = 40;       // shrinking usually ends within five
// Depth inside the ball over its radius that counts as outside. With less, the ball in a sphere is
// near to all triangles.
constexpr double Depth = 0.1;

// Balls larger than this over the way across that ThinShare of the area does not exceed stay as
// they are. They would be near to many triangles, and matter to no thin place.
constexpr double LargestBall = 4.0;

/// Finds balls at the samples of a surface.
class Balls
{
public:
  Balls(const std::vector<SurfaceSample>& samples, const TriangleSearch& surface, BallSide side) :
    Samples(samples), Surface(surface), Side(side)
  {
  }
  /// Returns the way from a sample across to the opposed triangle, infinite if there is none.
  double MeasureWay(Index sample) const
  {
    const TriangleSearch::Nearest across = this->Surface.FindOnRay(this->Samples[sample].Point,
      this->NormalAt(sample), [&](int t) { return this->Faces(t, sample); });
    return across.Triangle < 0 ? std::numeric_limits<double>::infinity() : std::sqrt(across.Square);
  }
  /// Returns the diameter of the ball, or the way across if no ball of at most `limit` reaches an
  /// opposed triangle.
  double Shrink(Index sample, double way, double limit) const
  {
    const Vector3& point = this->Samples[sample].Point;
    const Vector3 normal = this->NormalAt(sample);
    double diameter = std::min({ way, limit, this->Surface.Diagonal() });
    bool isEmpty = diameter < way;
    for (int step = 0; step < MaximumSteps; ++step)
    {
      const double radius = 0.5 * diameter;
      const TriangleSearch::Nearest nearest = this->Surface.Find(point + radius * normal,
        radius * (1.0 - Depth), [&](int t) { return this->Faces(t, sample); });
      const Vector3 to = nearest.Point - point;
      const double height = Dot(to, normal);
      if (nearest.Triangle < 0 || height <= 0.0)
      {
        break;
      }
      isEmpty = false;
      diameter = Dot(to, to) / height;
    }
    return isEmpty ? way : diameter;
  }

private:
  /// Returns the normal into the ball.
  Vector3 NormalAt(Index sample) const
  {
    return (this->Side == BallSide::Inner ? -1.0 : 1.0) * this->Samples[sample].Normal;
  }
  bool Faces(int triangle, Index sample) const
  {
    return Dot(this->Surface.Normal(triangle), this->Samples[sample].Normal) < LargestCosine;
  }

  const std::vector<SurfaceSample>& Samples;
  const TriangleSearch& Surface;
  BallSide Side;
};

} // namespace

std::vector<double> MeasureThickness(const std::vector<SurfaceSample>& samples,
  const TriangleSearch& surface, BallSide side, Runtime& runtime)
{
  const Balls balls(samples, surface, side);
  std::vector<double> ways(samples.size());
  ForEach(runtime, samples.size(), [&](Index s) { ways[s] = balls.MeasureWay(s); });
  const double limit = LargestBall * FindQuantile(samples, ways, ThinShare);
  std::vector<double> diameters(samples.size());
  ForEach(
    runtime, samples.size(), [&](Index s) { diameters[s] = balls.Shrink(s, ways[s], limit); });
  return diameters;
}

std::vector<double> MeasureThicknessTo(double limit, const std::vector<SurfaceSample>& samples,
  const TriangleSearch& surface, BallSide side, Runtime& runtime)
{
  const Balls balls(samples, surface, side);
  std::vector<double> diameters(samples.size());
  ForEach(runtime, samples.size(), [&](Index s) { diameters[s] = balls.Shrink(s, limit, limit); });
  return diameters;
}

double FindQuantile(
  const std::vector<SurfaceSample>& samples, const std::vector<double>& values, double share)
{
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  double total = 0.0;
  for (const SurfaceSample& sample : samples)
  {
    total += sample.Area;
  }
  double sum = 0.0;
  for (std::size_t s : order)
  {
    sum += samples[s].Area;
    if (sum >= share * total)
    {
      return values[s];
    }
  }
  return samples.empty() ? std::numeric_limits<double>::infinity() : values[order.back()];
}

} // namespace vfm
