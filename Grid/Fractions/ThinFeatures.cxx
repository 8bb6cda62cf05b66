#include "Fractions/ThinFeatures.h"

#include "Base/Vector3.h"

#include <Eigen/Eigenvalues>

namespace vfm
{
namespace
{

constexpr double Step = 0.25;       // distance of samples on the line, in cells
constexpr double Climb = 1.5;       // distance within which the largest fraction is sought
constexpr double Drop = 0.1;        // a smaller decrease of fractions is unevenness of cells
constexpr double Nothing = 0.02;    // a region ends at this fraction
constexpr double SmallSlope = 1e-9; // squared gradients with a smaller trace have no direction

/// Fractions of one material around a cell.
class Surroundings
{
public:
  Surroundings(
    const CartesianGrid& grid, const FractionField& fractions, const Index3& cell, int material) :
    Grid(grid), Fractions(fractions), Cell(cell), Material(material)
  {
  }

  double At(const Index3& d) const
  {
    Index3 q;
    for (int a = 0; a < 3; ++a)
    {
      q[a] = this->Mirrored(this->Cell[a] + d[a], this->Grid.Global().Upper[a]);
    }
    return this->Fractions.Fraction(this->Grid.Linear(q), this->Material);
  }

  /// Interpolates linearly along each axis between cell centres; x: position relative to the centre
  /// of the cell.
  double At(const Vector3& x) const
  {
    Index3 lower;
    Vector3 part;
    for (int a = 0; a < 3; ++a)
    {
      const double low = std::floor(x[a]);
      lower[a] = static_cast<Index>(low);
      part[a] = x[a] - low;
    }
    double value = 0.0;
    for (int c = 0; c < 8; ++c)
    {
      double weight = 1.0;
      Index3 d = lower;
      for (int a = 0; a < 3; ++a)
      {
        const bool isUpper = c >> a & 1;
        weight *= isUpper ? part[a] : 1.0 - part[a];
        d[a] += isUpper;
      }
      value += weight > 0.0 ? weight * this->At(d) : 0.0;
    }
    return value;
  }

  Vector3 GradientAt(const Index3& d) const
  {
    Vector3 gradient;
    for (int a = 0; a < 3; ++a)
    {
      Index3 low = d, high = d;
      --low[a];
      ++high[a];
      gradient[a] = 0.5 * (this->At(high) - this->At(low));
    }
    return gradient;
  }

private:
  static Index Mirrored(Index i, Index count)
  {
    while (i < 0 || i >= count)
    {
      i = i < 0 ? -1 - i : 2 * count - 1 - i;
    }
    return i;
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const Index3 Cell;
  const int Material;
};

/// Returns the direction in which fractions change most around the cell, or 0 if they do not. The
/// squares of the gradients give the direction of films, where gradients of both sides cancel.
/// Their mean gives the inward direction at edges.
Vector3 FindDirection(const Surroundings& around)
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  for (int c = 0; c < 27; ++c)
  {
    const Index3 d = StepAround(c);
    const double weight = 1.0 / static_cast<double>(1 + d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const Vector3 gradient = around.GradientAt(d);
    const Eigen::Vector3d g(gradient[0], gradient[1], gradient[2]);
    squares += weight * g * g.transpose();
    sum += weight * g;
    weights += weight;
  }
  squares += sum * sum.transpose() / weights;
  if (!(squares.trace() > SmallSlope))
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  const Eigen::Vector3d n = solver.eigenvectors().col(2);
  return Unit({ { n[0], n[1], n[2] } });
}

/// Fractions along a line through the cell.
class Line
{
public:
  Line(const Surroundings& around, const Vector3& direction) : Around(around), Direction(direction)
  {
    double most = 0.0;
    for (double n : direction)
    {
      most = std::max(most, std::fabs(n));
    }
    this->Last = static_cast<int>((ThicknessReach - 2) / most / Step);
  }

  /// Returns the step with the largest fraction that is reached without a drop.
  int FindPeak() const
  {
    int peak = 0;
    double largest = this->At(0);
    for (int sign : { 1, -1 })
    {
      double top = this->At(0);
      for (int s = sign; std::abs(s) * Step <= Climb; s += sign)
      {
        const double value = this->At(s);
        if (value < top - Drop)
        {
          break;
        }
        top = std::max(top, value);
        if (value > largest)
        {
          largest = value;
          peak = s;
        }
      }
    }
    return peak;
  }

  /// Returns the sum from a step to the end of the region, with half weight at that step, or
  /// `enough` if it is not smaller.
  double SumFrom(int first, int sign, double enough) const
  {
    double low = this->At(first), sum = 0.5 * Step * low, sumAtLow = sum;
    for (int s = first + sign; std::abs(s) <= this->Last && sum < enough; s += sign)
    {
      const double value = this->At(s);
      if (value > low + Drop)
      {
        return sumAtLow;
      }
      sum += Step * value;
      if (value <= low)
      {
        low = value;
        sumAtLow = sum - 0.5 * Step * value;
      }
      if (value < Nothing)
      {
        break;
      }
    }
    return std::min(sum, enough);
  }

private:
  double At(int step) const { return this->Around.At((Step * step) * this->Direction); }

  const Surroundings& Around;
  const Vector3 Direction;
  int Last; // last step within reach
};

/// Returns the thickness along the line through one cell.
double MeasureLine(const Surroundings& around, double enough)
{
  const Vector3 direction = FindDirection(around);
  if (Norm(direction) == 0.0)
  {
    return enough;
  }
  const Line line(around, direction);
  const int peak = line.FindPeak();
  const double forward = line.SumFrom(peak, 1, enough);
  return forward < enough ? std::min(forward + line.SumFrom(peak, -1, enough), enough) : enough;
}

/// Returns the cell with the largest fraction among a cell and the 26 around it. On a tie it is the
/// cell itself, then the first.
Index3 FindFullest(const CartesianGrid& grid, const Surroundings& around, const Index3& cell)
{
  double largest = around.At(Index3{ { 0, 0, 0 } });
  Index3 fullest = cell;
  for (int c = 0; c < 27; ++c)
  {
    const Index3 d = StepAround(c);
    const Index3 q = CellAround(cell, c);
    if (grid.InDomain(q) && around.At(d) > largest)
    {
      largest = around.At(d);
      fullest = q;
    }
  }
  return fullest;
}

} // namespace

double FindThickness(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell,
  int material, double enough)
{
  const Surroundings around(grid, fractions, cell, material);
  const double thickness = MeasureLine(around, enough);
  if (!(thickness < enough))
  {
    return enough;
  }
  const Index3 fullest = FindFullest(grid, around, cell);
  return fullest == cell
    ? thickness
    : std::max(thickness, MeasureLine(Surroundings(grid, fractions, fullest, material), enough));
}

} // namespace vfm
