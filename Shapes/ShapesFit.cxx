#include "Shapes/ShapesFit.h"

#include "Base/Vector3.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr double LargestResidual = 0.1; // residual of a linear fit over the span of the values

/// Linear function Value + Gradient . (x - center).
struct LinearFit
{
  double Value;
  Vector3 Gradient;
  double Residual; // largest residual at corners and center
  double Span;     // half the difference of largest and smallest value in the box
};

LinearFit FitLinear(const Shape& shape, const BoxGeometry& box)
{
  double value[8], mean = 0.0;
  LinearFit fit{ 0.0, { { 0, 0, 0 } }, 0.0, 0.0 };
  for (int c = 0; c < 8; ++c)
  {
    value[c] = EvaluateBody(shape, box.Corner(c));
    mean += value[c] / 8;
    for (int a = 0; a < 3; ++a)
    {
      fit.Gradient[a] += (c >> a & 1 ? value[c] : -value[c]) / (8 * box.Half[a]);
    }
  }
  const double middle = EvaluateBody(shape, box.Center);
  fit.Value = (2.0 * middle + mean) / 3.0; // exact mean over the box for quadratics
  fit.Residual = std::abs(middle - fit.Value);
  for (int c = 0; c < 8; ++c)
  {
    const double linear = fit.Value + Dot(fit.Gradient, box.Corner(c) - box.Center);
    fit.Residual = std::max(fit.Residual, std::abs(value[c] - linear));
  }
  for (int a = 0; a < 3; ++a)
  {
    fit.Span += std::abs(fit.Gradient[a]) * box.Half[a];
  }
  return fit;
}

/// Returns a bound of the volume between plane and surface that the faces of
/// the box cut differently.
/// @param deviation  largest deviation of the surface from the plane
double EstimateRimError(const BoxGeometry& box, const HalfSpace& plane, double deviation)
{
  double error = 0.0;
  const double center = Dot(plane.Normal, box.Center) - plane.Offset;
  for (int f = 0; f < 6; ++f)
  {
    const int a = f / 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const double middle = center + (f & 1 ? 1 : -1) * plane.Normal[a] * box.Half[a];
    const double span =
      std::abs(plane.Normal[b]) * box.Half[b] + std::abs(plane.Normal[c]) * box.Half[c];
    if (std::abs(middle) > span + deviation)
    {
      continue;
    }
    const double sine = std::sqrt(std::max(1.0 - plane.Normal[a] * plane.Normal[a], 0.0));
    const double length = 2.0 * std::max(box.Half[b], box.Half[c]);
    const double wedge =
      0.5 * deviation * deviation * length * std::abs(plane.Normal[a]) / std::max(sine, 1e-12);
    error += std::min(wedge, deviation * 4.0 * box.Half[b] * box.Half[c]);
  }
  return error;
}

} // namespace

BoxGeometry MakeBoxGeometry(const Vector3& lower, const Vector3& upper)
{
  return { 0.5 * (lower + upper), 0.5 * (upper - lower) };
}

double SurfaceFitter::MeasureHeight(
  const Shape& shape, double slope, double& deviation, double& area) const
{
  // The height is -value / slope. The rule of the midpoints of a triangle's sides
  // is exact for quadratics.
  const std::vector<Vector3>& polygon = this->Section;
  const auto height = [&](const Vector3& p) { return -EvaluateBody(shape, p) / slope; };
  double lowest = INFINITY, highest = -INFINITY, integral = 0.0;
  const auto measure = [&](const Vector3& p)
  {
    const double h = height(p);
    lowest = std::min(lowest, h);
    highest = std::max(highest, h);
    return h;
  };
  area = 0.0;
  measure(polygon[0]);
  double spoke = measure(0.5 * (polygon[0] + polygon[1]));
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    measure(polygon[i]);
    const double side = measure(0.5 * (polygon[i] + polygon[i + 1]));
    const double next = measure(0.5 * (polygon[0] + polygon[i + 1]));
    const double triangle = 0.5 * Norm(Cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]));
    area += triangle;
    integral += triangle * (spoke + side + next) / 3.0;
    spoke = next;
  }
  measure(polygon.back());
  const double mean = area > 0.0 ? integral / area : 0.0;
  deviation = std::max({ highest - mean, mean - lowest, std::abs(mean) });
  return mean;
}

FitError SurfaceFitter::Fit(const Shape& shape, const BoxGeometry& box, HalfSpace& plane)
{
  const LinearFit fit = FitLinear(shape, box);
  const double slope = Norm(fit.Gradient);
  if (!(slope > 0.0))
  {
    plane = { { { 0, 0, 1 } }, fit.Value < 0.0 ? INFINITY : -INFINITY };
    return { INFINITY, INFINITY };
  }
  plane.Normal = (1.0 / slope) * fit.Gradient;
  plane.Offset = Dot(plane.Normal, box.Center) - fit.Value / slope;
  if (fit.Residual > LargestResidual * fit.Span)
  {
    return { INFINITY, INFINITY };
  }
  ClipPiece(MakeBoxPiece(box.Center - box.Half, box.Center + box.Half), plane, this->Inside,
    this->Outside, this->Section);
  FitError error;
  double deviation = fit.Residual / slope;
  if (!this->Section.empty())
  {
    double area = 0.0;
    plane.Offset += this->MeasureHeight(shape, slope, deviation, area);
    error.Sheet = deviation * area;
  }
  error.Rim = EstimateRimError(box, plane, deviation);
  return error;
}

} // namespace vfm
