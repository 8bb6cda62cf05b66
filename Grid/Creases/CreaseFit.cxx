#include "Creases/CreaseFit.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int MostCoefficients = 6 * CreaseModel::MostSurfaces;
constexpr double FullCell = 1e-6;   // fractions nearer to 0 or 1 are of full cells
constexpr double NoResidual = 1e30; // of no cells
constexpr double LongestStep = 0.5; // of a coefficient in an iteration
constexpr double FirstDamping = 1e-3, LeastDamping = 1e-6;
constexpr int Trials = 4; // dampings in an iteration
constexpr double LeastGain = 1e-2, ShortestStep = 1e-4, LeastCost = 1e-6;

/// Keeps what the data leave open where it is: planes nearly free, curvatures small.
double RidgeOf(int coefficient)
{
  return coefficient < 3 ? 1e-8 : 0.02;
}

bool IsCut(double fraction)
{
  return fraction > FullCell && fraction < 1.0 - FullCell;
}

/// The weighted sum of squares at a model with half its gradient and Hessian (Gauss-Newton), over the first coefficients of each surface.
class NormalEquations
{
public:
  NormalEquations(
    const CreaseModel& model, const std::vector<SampleCell>& cells, int coefficients) :
    Size(coefficients * model.Count)
  {
    for (const SampleCell& cell : cells)
    {
      std::array<double, MostCoefficients> derivatives;
      const double error = FractionIn(model, cell, derivatives.data(), nullptr) - cell.Fraction;
      for (int k = 1; k < model.Count; ++k)
      {
        std::copy_n(&derivatives[6 * k], coefficients, &derivatives[coefficients * k]);
      }
      this->Add(cell.Weight, error, derivatives);
    }
    for (int i = 0; i < this->Size; ++i)
    {
      const double ridge = RidgeOf(i % coefficients);
      const double c = model.Surfaces[i / coefficients].C[i % coefficients];
      this->Cost += ridge * c * c;
      this->Gradient[i] += ridge * c;
      this->Hessian[i][i] += ridge;
    }
  }

  double Cost = 0.0;

  /// The step down at a damping, by Cholesky's factors.
  std::array<double, MostCoefficients> Solve(double damping) const
  {
    std::array<std::array<double, MostCoefficients>, MostCoefficients> lower;
    std::array<double, MostCoefficients> x;
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
  void Add(double weight, double error, const std::array<double, MostCoefficients>& derivatives)
  {
    this->Cost += weight * error * error;
    for (int i = 0; i < this->Size; ++i)
    {
      const double w = weight * derivatives[i];
      if (w != 0.0)
      {
        this->Gradient[i] += w * error;
        for (int j = 0; j <= i; ++j)
        {
          this->Hessian[i][j] += w * derivatives[j];
        }
      }
    }
  }

  int Size;
  std::array<double, MostCoefficients> Gradient{};
  std::array<std::array<double, MostCoefficients>, MostCoefficients> Hessian{}; ///< lower half
};

/// Moves a model by a step, clamped; returns the longest component of the step.
double MoveBy(
  CreaseModel& model, int coefficients, const std::array<double, MostCoefficients>& step)
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

double ResidualOf(const CreaseModel& model, const std::vector<SampleCell>& cells)
{
  double sum = 0.0, weights = 0.0;
  for (const SampleCell& cell : cells)
  {
    const double fraction = FractionIn(model, cell), error = fraction - cell.Fraction;
    if (IsCut(cell.Fraction) || IsCut(fraction) || std::fabs(error) > FullCell)
    {
      sum += cell.Weight * error * error;
      weights += cell.Weight;
    }
  }
  return weights > 0.0 ? std::sqrt(sum / weights) : NoResidual;
}

std::array<double, CreaseModel::MostSurfaces> AreasOf(
  const CreaseModel& model, const std::vector<SampleCell>& cells)
{
  std::array<double, CreaseModel::MostSurfaces> areas{};
  for (const SampleCell& cell : cells)
  {
    FractionIn(model, cell, nullptr, areas.data());
  }
  return areas;
}

void FitModel(
  CreaseModel& model, const std::vector<SampleCell>& cells, int coefficients, int iterations)
{
  NormalEquations at(model, cells, coefficients);
  double damping = FirstDamping;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    bool goOn = false;
    for (int trial = 0; trial < Trials; ++trial)
    {
      CreaseModel next = model;
      const double step = MoveBy(next, coefficients, at.Solve(damping));
      const NormalEquations there(next, cells, coefficients);
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
