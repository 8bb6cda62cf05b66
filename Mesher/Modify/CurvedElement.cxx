#include "Modify/CurvedElement.h"

#include "Elements/GaussRule.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace vfm
{
namespace
{

using Matrix = Eigen::MatrixXd;

constexpr int HexDegree = 5, TetDegree = 3;
constexpr int HexPoints = HexDegree + 1; // along an axis
// Corners of the unit cube in VTK's order.
constexpr int CubeCorners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

/// A function along an axis and its derivative.
struct Factor
{
  double Value, Slope;
};

/// Returns the derivative along an axis of a product of functions of x, y and z.
double SlopeOf(const Factor (&f)[3], int axis)
{
  double slope = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    slope *= a == axis ? f[a].Slope : f[a].Value;
  }
  return slope;
}

/// The function that is 1 at one end of [0, 1] and 0 at the other.
Factor LinearAt(double x, int end)
{
  return end == 1 ? Factor{ x, 1.0 } : Factor{ 1.0 - x, -1.0 };
}

/// The function that is 1 in the middle of [0, 1] and 0 at both ends.
Factor BubbleAt(double x)
{
  return { 4.0 * x * (1.0 - x), 4.0 - 8.0 * x };
}

/// Fills the derivatives of the shape functions of a hex at a point. The shape function of a corner
/// is the trilinear one minus half those of the three edges at the corner.
void FillHex(const double (&x)[3], int row, Matrix (&along)[3])
{
  const MidNodes mids(8, 12);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int c = 0; c < 8; ++c)
    {
      Factor f[3];
      for (int a = 0; a < 3; ++a)
      {
        f[a] = LinearAt(x[a], CubeCorners[c][a]);
      }
      along[axis](row, c) = SlopeOf(f, axis);
    }
    for (int e = 0; e < mids.Edges; ++e)
    {
      const int(&ends)[2] = mids.EdgeCorners[e];
      Factor f[3];
      for (int a = 0; a < 3; ++a)
      {
        const int low = CubeCorners[ends[0]][a], high = CubeCorners[ends[1]][a];
        f[a] = low == high ? LinearAt(x[a], low) : BubbleAt(x[a]);
      }
      const double slope = SlopeOf(f, axis);
      along[axis](row, 8 + e) = slope;
      along[axis](row, ends[0]) -= 0.5 * slope;
      along[axis](row, ends[1]) -= 0.5 * slope;
    }
  }
}

/// Fills the derivatives of the shape functions of a tet at a point.
/// @param at  barycentric coordinates; x, y, z are those of corners 1 to 3
void FillTet(const double (&at)[4], int row, Matrix (&along)[3])
{
  const MidNodes mids(4, 6);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto slopeOf = [axis](int c) { return c == 0 ? -1.0 : (c == axis + 1 ? 1.0 : 0.0); };
    for (int c = 0; c < 4; ++c)
    {
      along[axis](row, c) = (4.0 * at[c] - 1.0) * slopeOf(c);
    }
    for (int e = 0; e < mids.Edges; ++e)
    {
      const int(&ends)[2] = mids.EdgeCorners[e];
      along[axis](row, 4 + e) =
        4.0 * (slopeOf(ends[0]) * at[ends[1]] + at[ends[0]] * slopeOf(ends[1]));
    }
  }
}

double Power(double base, int exponent)
{
  return exponent == 0 ? 1.0 : base * Power(base, exponent - 1);
}

double Factorial(int n)
{
  return n < 2 ? 1.0 : n * Factorial(n - 1);
}

/// Returns the Bernstein polynomial with the given exponents of barycentric coordinates.
template <std::size_t Count>
double Bernstein(const int (&exponents)[Count], const double (&at)[Count])
{
  int degree = 0;
  double value = 1.0;
  for (std::size_t i = 0; i < Count; ++i)
  {
    degree += exponents[i];
    value *= Power(at[i], exponents[i]) / Factorial(exponents[i]);
  }
  return value * Factorial(degree);
}

/// Returns the matrix from values at the lattice of a cube to coefficients, x fastest.
Matrix HexToBernstein()
{
  Matrix values(HexPoints, HexPoints);
  for (int p = 0; p < HexPoints; ++p)
  {
    for (int c = 0; c < HexPoints; ++c)
    {
      const double x = static_cast<double>(p) / HexDegree;
      values(p, c) = Bernstein({ HexDegree - c, c }, { 1.0 - x, x });
    }
  }
  const Matrix along = values.inverse();
  const int count = HexPoints * HexPoints * HexPoints;
  const auto split = [](int n, int axis) {
    return n / (axis == 0 ? 1 : axis == 1 ? HexPoints : HexPoints * HexPoints) % HexPoints;
  };
  Matrix all(count, count);
  for (int c = 0; c < count; ++c)
  {
    for (int p = 0; p < count; ++p)
    {
      all(c, p) = along(split(c, 0), split(p, 0)) * along(split(c, 1), split(p, 1)) *
        along(split(c, 2), split(p, 2));
    }
  }
  return all;
}

/// Exponents of the Bernstein polynomials of a tet, and points of its lattice.
struct TetLattice
{
  TetLattice()
  {
    for (int i = 0; i <= TetDegree; ++i)
    {
      for (int j = 0; i + j <= TetDegree; ++j)
      {
        for (int k = 0; i + j + k <= TetDegree; ++k)
        {
          this->Items.push_back({ { TetDegree - i - j - k, i, j, k } });
        }
      }
    }
  }
  int Count() const { return static_cast<int>(this->Items.size()); }
  void PointOf(int item, double (&at)[4]) const
  {
    for (int c = 0; c < 4; ++c)
    {
      at[c] = static_cast<double>(this->Items[item][c]) / TetDegree;
    }
  }

  std::vector<std::array<int, 4>> Items;
};

Matrix TetToBernstein(const TetLattice& lattice)
{
  Matrix values(lattice.Count(), lattice.Count());
  for (int p = 0; p < lattice.Count(); ++p)
  {
    double at[4];
    lattice.PointOf(p, at);
    for (int c = 0; c < lattice.Count(); ++c)
    {
      const std::array<int, 4>& e = lattice.Items[c];
      values(p, c) = Bernstein({ e[0], e[1], e[2], e[3] }, at);
    }
  }
  return values.inverse();
}

} // namespace

CurvedElement::CurvedElement(int corners)
{
  const TetLattice lattice;
  const int points = corners == 8 ? HexPoints * HexPoints * HexPoints : lattice.Count();
  const int nodes = corners + MidNodes::CountOf(InterpolationOrder::Quadratic, corners);
  for (Matrix& along : this->Along)
  {
    along = Matrix::Zero(points, nodes);
  }
  for (int p = 0; p < points; ++p)
  {
    if (corners == 8)
    {
      const double step = 1.0 / HexDegree;
      FillHex({ step * (p % HexPoints), step * (p / HexPoints % HexPoints),
                step * (p / (HexPoints * HexPoints)) },
        p, this->Along);
    }
    else
    {
      double at[4];
      lattice.PointOf(p, at);
      FillTet(at, p, this->Along);
    }
  }
  this->ToBernstein = corners == 8 ? HexToBernstein() : TetToBernstein(lattice);
  this->SetRule(corners);
}

void CurvedElement::SetRule(int corners)
{
  if (corners == 4)
  {
    std::copy(std::begin(this->Along), std::end(this->Along), std::begin(this->AlongRule));
    // Bernstein polynomials have equal integrals.
    this->Weights = this->ToBernstein.colwise().mean().transpose() / 6.0;
    return;
  }
  constexpr int count = 27; // of Gauss points
  this->Weights.resize(count);
  for (Matrix& along : this->AlongRule)
  {
    along = Matrix::Zero(count, this->NodeCount());
  }
  for (int p = 0; p < count; ++p)
  {
    const int at[3] = { p % 3, p / 3 % 3, p / 9 };
    FillHex({ GaussPoints[at[0]], GaussPoints[at[1]], GaussPoints[at[2]] }, p, this->AlongRule);
    this->Weights[p] = GaussWeights[at[0]] * GaussWeights[at[1]] * GaussWeights[at[2]];
  }
}

double CurvedElement::SmallestCoefficient(const Nodes& nodes) const
{
  return (this->ToBernstein * this->JacobianAt(this->Along, nodes)).minCoeff();
}

double CurvedElement::Volume(const Nodes& nodes) const
{
  return this->Weights.dot(this->JacobianAt(this->AlongRule, nodes));
}

Eigen::VectorXd CurvedElement::JacobianAt(const Slopes& along, const Nodes& nodes) const
{
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const Eigen::Map<const Rows> x(nodes[0].data(), this->NodeCount(), 3);
  const Rows u = along[0] * x, v = along[1] * x, w = along[2] * x;
  Eigen::VectorXd jacobian(u.rows());
  for (Eigen::Index p = 0; p < u.rows(); ++p)
  {
    jacobian[p] = u.row(p).dot(v.row(p).cross(w.row(p)));
  }
  return jacobian;
}

const CurvedElement& GetCurvedElement(int corners)
{
  static const CurvedElement hex(8), tet(4);
  return corners == 8 ? hex : tet;
}

} // namespace vfm
