#include "Fractions/LayerFit.h"

#include "Base/Vector3.h"
#include "Fractions/GradientFit.h"
#include "Fractions/Plic.h"

#include <Eigen/Eigenvalues>

#include <limits>

namespace vfm
{
namespace
{

constexpr int LargestSteps = 12;
constexpr int LargestBisections = 100;
constexpr double ThicknessTolerance = 1e-13; // of half thicknesses
constexpr double Difference = 1e-5;          // change of the unknowns for numerical derivatives
constexpr double LongestStep = 0.5;          // largest change of the unknowns per step
constexpr double SmallestStep = 1e-9;        // after a smaller step, the next would be rounding
constexpr double SmallestGain = 0.01;   // relative gain in squared error below which steps stop
constexpr double SmallestSlope = 1e-12; // smaller gradients count as 0
constexpr double Damping = 1e-9;
constexpr double CloseFit = 0.01;   // error above which films at other places are tried too
constexpr double OtherPlace = 0.25; // shift of the middle to these places
// Moments of inertia of a thread have a smaller ratio; the extent of the cells is 1 along each
// axis.
constexpr double LineRatio = 1.0 / 3.0;

/// Returns the half thickness of the layer around the plane n.x = middle that fills a fraction of
/// the cell: Newton steps, or bisection where these leave the bounds.
double ThicknessOfVolume(const CellBelowPlanes& cell, double middle, double fraction)
{
  double low = 0.0, high = std::fabs(middle) + cell.Reach();
  double half = std::min(0.5 * fraction, high);
  for (int step = 0; step < LargestBisections && high - low > ThicknessTolerance; ++step)
  {
    const double excess = cell.Volume(middle + half) - cell.Volume(middle - half) - fraction;
    (excess < 0.0 ? low : high) = half;
    const double slope = cell.Slope(middle + half) + cell.Slope(middle - half);
    const double next = half - excess / slope;
    if (std::fabs(next - half) < ThicknessTolerance)
    {
      return half;
    }
    half = next > low && next < high ? next : 0.5 * (low + high);
  }
  return half;
}

struct Trial
{
  Layer Region;
  double Middle = 0.0;
  std::vector<double> Errors; // one per sample
  double SquaredError = 0.0;  // weighted sum
};

using Samples = std::vector<FractionSample>;

/// Unknowns of a layer: two angles of the normal and, for films, the position of the middle.
struct Unknowns
{
  bool IsFilm;
  // Axes along which the normal may change: there are other cells along them.
  std::array<bool, 3> Turns{ { false, false, false } };

  int Count() const { return this->IsFilm ? 3 : 2; }
};

/// Returns the fraction of a box inside a layer.
/// @param box  the box scaled to the unit cell
/// @param centre  distance of the centre of the box along the normal
double FractionOfBox(const Layer& layer, const CellBelowPlanes& box, double centre)
{
  const double beyond = std::isinf(layer.Lower) ? 0.0 : box.Volume(layer.Lower - centre);
  return box.Volume(layer.Upper - centre) - beyond;
}

/// Returns the layer that keeps the volume in the cell.
Trial Try(const Samples& samples, bool isFilm, const Vector3& normal, double middle)
{
  Trial trial;
  trial.Middle = middle;
  const double inside = samples[0].Value;
  CellBelowPlanes box(normal);
  if (isFilm)
  {
    const double half = ThicknessOfVolume(box, middle, inside);
    trial.Region = { normal, middle - half, middle + half };
  }
  else
  {
    trial.Region = { normal, -std::numeric_limits<double>::infinity(), box.PlaneOf(inside) };
  }
  trial.Errors.reserve(samples.size());
  Vector3 size{ { 1.0, 1.0, 1.0 } };
  for (const FractionSample& sample : samples)
  {
    if (sample.Size != size)
    {
      size = sample.Size;
      box = CellBelowPlanes(Scaled(normal, size));
    }
    const double error =
      FractionOfBox(trial.Region, box, Dot(normal, sample.Centre)) - sample.Value;
    trial.Errors.push_back(error);
    trial.SquaredError += sample.Weight * error * error;
  }
  return trial;
}

/// Returns a trial whose unknowns differ from another by a step: two rotations and a shift.
Trial TryAdjacent(
  const Samples& samples, const Unknowns& unknowns, const Trial& from, const Vector3& step)
{
  const Vector3& n = from.Region.Normal;
  Vector3 u, v;
  MakeTangents(n, u, v);
  Vector3 turned = n + step[0] * u + step[1] * v;
  for (int a = 0; a < 3; ++a)
  {
    turned[a] = unknowns.Turns[a] ? turned[a] : n[a];
  }
  return Try(samples, unknowns.IsFilm, Unit(turned), from.Middle + step[2]);
}

/// Returns a step of the Gauss-Newton method.
Vector3 FindStep(const Samples& samples, const Unknowns& unknowns, const Trial& from)
{
  std::array<Trial, 3> beside;
  for (int a = 0; a < unknowns.Count(); ++a)
  {
    Vector3 step{ { 0.0, 0.0, 0.0 } };
    step[a] = Difference;
    beside[a] = TryAdjacent(samples, unknowns, from, step);
  }
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (int a = 0; a < unknowns.Count(); ++a)
    {
      slope[a] = (beside[a].Errors[i] - from.Errors[i]) / Difference;
    }
    A += samples[i].Weight * slope * slope.transpose();
    b -= samples[i].Weight * from.Errors[i] * slope;
  }
  const double damping = Damping * A.trace() + std::numeric_limits<double>::min();
  for (int a = 0; a < 3; ++a)
  {
    A(a, a) += damping;
  }
  const Eigen::Vector3d step = A.ldlt().solve(b);
  const double length = step.norm();
  const double scale = length > LongestStep ? LongestStep / length : 1.0;
  return { { scale * step[0], scale * step[1], scale * step[2] } };
}

/// Makes one step; returns whether another may help.
bool Improve(const Samples& samples, const Unknowns& unknowns, Trial& best)
{
  Vector3 step = FindStep(samples, unknowns, best);
  for (int halving = 0; halving < 4; ++halving, step = 0.3 * step)
  {
    Trial trial = TryAdjacent(samples, unknowns, best, step);
    if (trial.SquaredError < best.SquaredError)
    {
      const bool helped = trial.SquaredError < (1.0 - SmallestGain) * best.SquaredError;
      best = std::move(trial);
      return helped && Norm(step) > SmallestStep;
    }
  }
  return false;
}

Unknowns FindUnknowns(const Samples& samples, bool isFilm)
{
  Unknowns unknowns{ isFilm };
  for (const FractionSample& sample : samples)
  {
    for (int a = 0; a < 3; ++a)
    {
      unknowns.Turns[a] = unknowns.Turns[a] || sample.Centre[a] != 0.0;
    }
  }
  return unknowns;
}

/// Finds the layer nearest to the samples, from a normal and middle to begin with.
LayerFit Fit(const Samples& samples, bool isFilm, const Vector3& normal, double middle)
{
  const Unknowns unknowns = FindUnknowns(samples, isFilm);
  Trial best = Try(samples, isFilm, normal, middle);
  for (int step = 0; step < LargestSteps && Improve(samples, unknowns, best); ++step)
  {
  }
  double weights = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    weights += samples[i].Weight;
  }
  LayerFit fit;
  fit.IsFound = true;
  fit.Region = best.Region;
  fit.Error = weights > 0.0 ? std::sqrt(best.SquaredError / weights) : 0.0;
  return fit;
}

/// Moments of the filled volume of samples.
struct Moments
{
  Vector3 Centre;         // of the filled volume
  Eigen::Vector3d Scale;  // inverse extent of the cells along each axis
  Eigen::Matrix3d Spread; // inertia of the filled volume, relative to the extent of the cells
};

Moments FindMoments(const Samples& samples)
{
  double mass = 0.0, weights = 0.0;
  Vector3 centre{ { 0.0, 0.0, 0.0 } }, centreOfCells{ { 0.0, 0.0, 0.0 } };
  for (const FractionSample& s : samples)
  {
    mass += s.Weight * s.Value;
    weights += s.Weight;
    centre = centre + (s.Weight * s.Value) * s.Centre;
    centreOfCells = centreOfCells + s.Weight * s.Centre;
  }
  centre = (1.0 / mass) * centre;
  centreOfCells = (1.0 / weights) * centreOfCells;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d spread = Eigen::Vector3d::Zero();
  for (const FractionSample& s : samples)
  {
    const Vector3 r = s.Centre - centre, q = s.Centre - centreOfCells;
    const Eigen::Vector3d x(r[0], r[1], r[2]), y(q[0], q[1], q[2]);
    inertia += s.Weight * s.Value / mass * x * x.transpose();
    spread += s.Weight / weights * y.cwiseAbs2();
  }
  for (int a = 0; a < 3; ++a)
  {
    if (spread[a] <= 0.0) // the grid is one cell thick: no film lies across it
    {
      spread[a] = inertia(a, a) = 1.0;
    }
  }
  const Eigen::Vector3d scale = spread.cwiseSqrt().cwiseInverse();
  return { centre, scale, scale.asDiagonal() * inertia * scale.asDiagonal() };
}

/// Finds the centre of the filled volume and the direction of its least extent, relative to the
/// extent of the cells.
void FindFilm(const Samples& samples, Vector3& normal, double& middle)
{
  const Moments moments = FindMoments(samples);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.Spread);
  const Eigen::Vector3d n = moments.Scale.asDiagonal() * solver.eigenvectors().col(0);
  normal = Unit({ { n[0], n[1], n[2] } });
  middle = Dot(normal, moments.Centre);
}

} // namespace

double FractionInLayer(const Layer& layer, const Vector3& centre, const Vector3& size)
{
  return FractionOfBox(
    layer, CellBelowPlanes(Scaled(layer.Normal, size)), Dot(layer.Normal, centre));
}

LayerFit FitHalfSpace(const std::vector<FractionSample>& samples)
{
  GradientFit gradient;
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    gradient.Add(samples[i].Centre, samples[i].Value - samples[0].Value, samples[i].Weight);
  }
  const Vector3 slope = gradient.Solve();
  if (!(Norm(slope) > SmallestSlope))
  {
    return LayerFit();
  }
  return Fit(samples, false, Unit(-1.0 * slope), 0.0);
}

LayerFit FitFilm(const std::vector<FractionSample>& samples)
{
  Vector3 normal;
  double middle = 0.0;
  FindFilm(samples, normal, middle);
  LayerFit best = Fit(samples, true, normal, middle);
  // A film inside this cell only looks the same anywhere in it, so steps stop.
  for (double shift : { -OtherPlace, OtherPlace })
  {
    if (best.Error > CloseFit)
    {
      const LayerFit other = Fit(samples, true, normal, middle + shift);
      best = other.Error < best.Error ? other : best;
    }
  }
  return best;
}

bool IsAlongLine(const std::vector<FractionSample>& samples)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
    FindMoments(samples).Spread, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[1] < LineRatio * solver.eigenvalues()[2];
}

} // namespace vfm
