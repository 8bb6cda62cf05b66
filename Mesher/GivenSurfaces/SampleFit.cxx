#include "GivenSurfaces/SampleFit.h"

#include "Base/PortableMath.h"

#include <Eigen/Cholesky>

namespace vfm
{
namespace
{

constexpr double LeastCosine = 0.4;    // between the normals of a sample and of the part
constexpr double SmallError = 0.02;    // fits of smaller ranges are not tried below it
constexpr double SteepestSlope = 1.5;  // over the base plane
constexpr double LargestBend = 0.6;    // of the quadratic coefficients
constexpr std::size_t FewestBent = 12; // samples of a quadric; fewer define a plane
constexpr std::size_t FewestFlat = 3;  // samples of a plane
constexpr double SlopeRidge = 1e-6, BendRidge = 1e-4; // times the sum of weights
constexpr std::array<double, 4> Shrinks{ 1.0, 0.7, 0.5, 0.35 };

struct Weighted
{
  const NearSample* Sample;
  double Weight;
};

/// Returns the samples of the part within a range.
std::vector<Weighted> Select(
  const std::vector<NearSample>& samples, const SurfacePart& part, const FitRange& range)
{
  std::vector<Weighted> selected;
  const bool hasOther = part.Other != Vector3{};
  for (const NearSample& sample : samples)
  {
    const Vector3 from = sample.At - part.Centre;
    const double squared = Dot(from, from), cosine = Dot(sample.Normal, part.Normal);
    if (squared <= range.Radius * range.Radius && cosine >= LeastCosine &&
      (part.Sheet == SurfacePart::AnySheet || sample.Sheet == part.Sheet) &&
      !(hasOther && Dot(sample.Normal, part.Other) > cosine))
    {
      selected.push_back(
        { &sample, sample.Weight * Exp(-squared / (2.0 * range.Sigma * range.Sigma)) });
    }
  }
  return selected;
}

/// Returns the plane through a point whose normal is the mean normal of the samples.
LocalQuadric MeanPlane(const std::vector<Weighted>& samples, const Vector3& point)
{
  Vector3 normal{};
  for (const Weighted& each : samples)
  {
    normal = normal + each.Weight * each.Sample->Normal;
  }
  return MakeLocalPlane(point, Unit(normal));
}

/// Sets the first coefficients of a quadric by least squares of the heights.
template <int Terms>
void FitHeights(const std::vector<Weighted>& samples, double sum, LocalQuadric& surface)
{
  using Row = Eigen::Matrix<double, Terms, 1>;
  Eigen::Matrix<double, Terms, Terms> matrix = Eigen::Matrix<double, Terms, Terms>::Zero();
  Row right = Row::Zero();
  for (const Weighted& each : samples)
  {
    const Vector3 r = each.Sample->At - surface.Base;
    const double u = Dot(r, surface.U), v = Dot(r, surface.V), w = Dot(r, surface.N);
    const std::array<double, 6> all{ { 1.0, u, v, u * u, u * v, v * v } };
    for (int i = 0; i < Terms; ++i)
    {
      right[i] += each.Weight * w * all[i];
      for (int j = 0; j <= i; ++j)
      {
        matrix(i, j) += each.Weight * all[i] * all[j];
      }
    }
  }
  for (int i = 1; i < Terms; ++i)
  {
    matrix(i, i) += (i < 3 ? SlopeRidge : BendRidge) * sum;
  }
  const Row c = matrix.ldlt().solve(right);
  for (int i = 0; i < Terms; ++i)
  {
    surface.C[i] = i < 3 ? c[i] : std::clamp(c[i], -LargestBend, LargestBend);
  }
}

double ErrorOf(const LocalQuadric& surface, const std::vector<Weighted>& samples, double sum)
{
  double squares = 0.0;
  for (const Weighted& each : samples)
  {
    Vector3 normal;
    const double distance = DistanceTo(surface, each.Sample->At, normal);
    squares += each.Weight * distance * distance;
  }
  return std::sqrt(squares / sum);
}

std::optional<SampleFit> FitOnce(
  const std::vector<NearSample>& samples, const SurfacePart& part, const FitRange& range)
{
  const std::vector<Weighted> selected = Select(samples, part, range);
  double sum = 0.0;
  for (const Weighted& each : selected)
  {
    sum += each.Weight;
  }
  if (selected.size() < FewestFlat || !(sum > 0.0))
  {
    return std::nullopt;
  }
  SampleFit fit{ MeanPlane(selected, part.Centre), 0.0 };
  if (selected.size() < FewestBent)
  {
    FitHeights<3>(selected, sum, fit.Surface);
  }
  else
  {
    FitHeights<6>(selected, sum, fit.Surface);
  }
  const std::array<double, 6>& c = fit.Surface.C;
  if (!(c[1] * c[1] + c[2] * c[2] <= SteepestSlope * SteepestSlope))
  {
    return std::nullopt;
  }
  fit.Error = ErrorOf(fit.Surface, selected, sum);
  return fit;
}

} // namespace

std::optional<SampleFit> FitSamples(
  const std::vector<NearSample>& samples, const SurfacePart& part, const FitRange& range)
{
  std::optional<SampleFit> best;
  for (double shrink : Shrinks)
  {
    const std::optional<SampleFit> fit =
      FitOnce(samples, part, { shrink * range.Radius, shrink * range.Sigma });
    if (fit && (!best || fit->Error < best->Error))
    {
      best = fit;
    }
    if (best && best->Error < SmallError)
    {
      break;
    }
  }
  return best;
}

} // namespace vfm
