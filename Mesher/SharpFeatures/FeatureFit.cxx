#include "SharpFeatures/FeatureFit.h"

#include "SharpFeatures/CellLanes.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int MaximumCoefficients = 6 * FeatureModel::MaximumSurfaces;
// Shift of surfaces that lie between cells, so that they cut cells too.
constexpr double Hair = 1e-5;
constexpr double LongestStep = 0.5; // change of a coefficient per iteration
constexpr double FirstDamping = 1e-3, LeastDamping = 1e-6;
constexpr int Trials = 4; // dampings per iteration
constexpr double LeastGain = 1e-2, ShortestStep = 1e-4, LeastCost = 1e-6;

/// Returns the weight of the square of a coefficient in the cost. It fixes coefficients that the
/// data leave open: planes stay nearly free, curvatures small.
double RidgeOf(int coefficient)
{
  return coefficient < 3 ? 1e-8 : 0.02;
}

/// Sums of the normal equations, one per lane. Only the lower half of the Hessian is set.
struct NormalSums
{
  Lanes Cost;
  std::array<Lanes, MaximumCoefficients> Gradient;
  std::array<std::array<Lanes, MaximumCoefficients>, MaximumCoefficients> Hessian;
};

/// Adds the products of the rows of a surface with rows of the same or an earlier surface.
VFM_INLINE void AddProducts(NormalSums& sums, const std::array<Lanes, MaximumCoefficients>& rows,
  const Lanes& weight, int firstRow, int firstColumn, int coefficients)
{
  for (int i = firstRow; i < firstRow + coefficients; ++i)
  {
    const Lanes weighted = weight * rows[i];
    const int end = std::min(firstColumn + coefficients, i + 1);
    for (int j = firstColumn; j < end; ++j)
    {
      sums.Hessian[i][j] += weighted * rows[j];
    }
  }
}

VFM_CLONES
void SumCells(NormalSums& sums, const FeatureModel& model, const PackedCells& cells,
  int coefficients, SharedCells how)
{
  const int size = coefficients * model.Count;
  sums.Cost = Lanes{};
  for (int i = 0; i < size; ++i)
  {
    sums.Gradient[i] = Lanes{};
    std::fill_n(sums.Hessian[i].begin(), i + 1, Lanes{});
  }
  ModelLanes at;
  std::array<Lanes, MaximumCoefficients> rows;
  for (const FourCells& packed : cells)
  {
    const CellLanes four = Load(packed);
    SetFractions(at, model, four, how);
    const Lanes error = at.Fraction - four.Fraction, weighted = four.Weight * error;
    sums.Cost += weighted * error;
    for (int k = 0; at.IsCut && k < model.Count; ++k)
    {
      const std::array<Lanes, 6> by = DerivativesBy(at.Surfaces[k], model.Surfaces[k], four.Width);
      const int first = k * coefficients;
      for (int i = 0; i < coefficients; ++i)
      {
        rows[first + i] = by[i];
        sums.Gradient[first + i] += weighted * by[i];
      }
      for (int other = at.IsShared ? 0 : k; other <= k; ++other)
      {
        AddProducts(sums, rows, four.Weight, first, other * coefficients, coefficients);
      }
    }
  }
}

/// Weighted sum of squares at a model, with half its gradient and Gauss-Newton Hessian, by the
/// first coefficients of each surface.
class NormalEquations
{
public:
  NormalEquations(
    const FeatureModel& model, const PackedCells& cells, int coefficients, SharedCells how) :
    Size(coefficients * model.Count)
  {
    NormalSums sums;
    SumCells(sums, model, cells, coefficients, how);
    this->Cost = Sum(sums.Cost);
    for (int i = 0; i < this->Size; ++i)
    {
      const double ridge = RidgeOf(i % coefficients);
      const double c = model.Surfaces[i / coefficients].C[i % coefficients];
      this->Cost += ridge * c * c;
      this->Gradient[i] = Sum(sums.Gradient[i]) + ridge * c;
      for (int j = 0; j <= i; ++j)
      {
        this->Hessian[i][j] = Sum(sums.Hessian[i][j]);
      }
      this->Hessian[i][i] += ridge;
    }
  }

  double Cost;

  /// Returns the descent step for a damping, by Cholesky factorisation.
  std::array<double, MaximumCoefficients> Solve(double damping) const
  {
    std::array<std::array<double, MaximumCoefficients>, MaximumCoefficients> lower;
    std::array<double, MaximumCoefficients> x;
    for (int i = 0; i < this->Size; ++i)
    {
      x[i] = -this->Gradient[i];
      for (int j = 0; j <= i; ++j)
      {
        double sum = this->Hessian[i][j];
        sum += i == j ? damping * (sum + 1e-4) : 0.0;
        for (int m = 0; m < j; ++m)
        {
          sum -= lower[i][m] * lower[j][m];
        }
        lower[i][j] = i == j ? std::sqrt(sum) : sum / lower[j][j];
        x[i] -= j < i ? lower[i][j] * x[j] : 0.0;
      }
      x[i] /= lower[i][i];
    }
    for (int i = this->Size - 1; i >= 0; --i)
    {
      for (int j = i + 1; j < this->Size; ++j)
      {
        x[i] -= lower[j][i] * x[j];
      }
      x[i] /= lower[i][i];
    }
    return x;
  }

private:
  int Size;
  std::array<double, MaximumCoefficients> Gradient;
  std::array<std::array<double, MaximumCoefficients>, MaximumCoefficients> Hessian; ///< lower half
};

/// Moves a model by a step with clamped components; returns the largest one before clamping.
double MoveBy(
  FeatureModel& model, int coefficients, const std::array<double, MaximumCoefficients>& step)
{
  double longest = 0.0;
  for (int i = 0; i < coefficients * model.Count; ++i)
  {
    longest = std::max(longest, std::fabs(step[i]));
    model.Surfaces[i / coefficients].C[i % coefficients] +=
      std::clamp(step[i], -LongestStep, LongestStep);
  }
  return longest;
}

} // namespace

VFM_CLONES
double ResidualOf(const FeatureModel& model, const PackedCells& cells, SharedCells how)
{
  ResidualSums sums{};
  ModelLanes at;
  for (const FourCells& packed : cells)
  {
    const CellLanes four = Load(packed);
    SetFractions(at, model, four, how);
    AddErrors(sums, at.Fraction, four.Fraction, four.Weight);
  }
  return RootMeanSquare(sums);
}

VFM_CLONES
std::array<double, FeatureModel::MaximumSurfaces> AreasOf(
  const FeatureModel& model, const PackedCells& cells)
{
  FeatureModel moved = model;
  for (LocalQuadric& surface : moved.Surfaces)
  {
    surface.C[0] += Hair;
  }
  std::array<Lanes, FeatureModel::MaximumSurfaces> sums{};
  ModelLanes at;
  for (const FourCells& packed : cells)
  {
    const CellLanes four = Load(packed);
    SetFractions(at, moved, four, SharedCells::Exact);
    const Lanes volume = four.Width.X * four.Width.Y * four.Width.Z;
    for (int k = 0; at.IsCut && k < model.Count; ++k)
    {
      const SurfaceLanes& surface = at.Surfaces[k];
      const Lanes square = 1.0 + surface.AlongU * surface.AlongU + surface.AlongV * surface.AlongV;
      sums[k] += volume * surface.Rates.ByHeight * SquareRoot(square);
    }
  }
  return { { Sum(sums[0]), Sum(sums[1]), Sum(sums[2]) } };
}

void FitModel(
  FeatureModel& model, const PackedCells& cells, int coefficients, int iterations, SharedCells how)
{
  NormalEquations at(model, cells, coefficients, how);
  double damping = FirstDamping;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    bool goOn = false;
    for (int trial = 0; trial < Trials; ++trial)
    {
      FeatureModel next = model;
      const double step = MoveBy(next, coefficients, at.Solve(damping));
      const NormalEquations there(next, cells, coefficients, how);
      if (there.Cost < at.Cost)
      {
        const double gain = at.Cost - there.Cost;
        goOn = step >= ShortestStep && gain >= LeastGain * there.Cost && there.Cost >= LeastCost;
        model = next;
        at = there;
        damping = std::max(0.2 * damping, LeastDamping);
        break;
      }
      damping *= 8.0;
    }
    if (!goOn)
    {
      return;
    }
  }
}

} // namespace vfm
