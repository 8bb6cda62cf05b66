#include "State/Transfer/Slopes.h"

#include "Base/Lanes.h"

#include <Eigen/Eigenvalues>

namespace vfm
{
namespace
{

// Fraction of a donor's volume below which neighbours are ignored. Values in such small volumes may
// be so large that slopes from them would leave only rounding errors.
constexpr double Little = 1e-4;
// Fraction of the largest eigenvalue below which neighbours are in a plane or on a line.
constexpr double Flat = 1e-6;

constexpr int LaneCount = ElementLanes<double>::Count;

/// Neighbour of a donor.
struct Neighbour
{
  const double* Values;
  Vector3 Weighted; // position relative to the centroid, divided by the squared distance
};

/// Symmetric matrix: xx yy zz xy xz yz.
using Matrix = std::array<double, 6>;

Vector3 Product(const Matrix& m, const Vector3& x)
{
  return { { m[0] * x[0] + m[3] * x[1] + m[4] * x[2], m[3] * x[0] + m[1] * x[1] + m[5] * x[2],
    m[4] * x[0] + m[5] * x[1] + m[2] * x[2] } };
}

/// Donor whose slopes are found.
struct SlopeInput
{
  const std::vector<Neighbour>& Around;
  const double* Own;
  const DonorShape& Shape;
  Matrix Inverse; // inverse of the least-squares matrix
  double Mass;
};

/// Kinds of the columns, one number per column: -1 if it applies, else 0.
struct ColumnKinds
{
  explicit ColumnKinds(const StateColumns& columns) :
    Width(columns.Width()),
    Density(columns.Density()),
    IsPerMass(columns.Width(), 0),
    IsSloping(columns.Width(), 0)
  {
    for (int c = 0; c < columns.Count(); ++c)
    {
      this->IsPerMass[c] = columns.Base(c) < 0 ? 0 : -1;
      this->IsSloping[c] = columns.IsConstant(c) ? 0 : -1;
    }
  }
  const int Width, Density;
  std::vector<double> IsPerMass, IsSloping;
};

VFM_INLINE Lanes LesserOf(const Lanes& a, const Lanes& b)
{
  return a < b ? a : b;
}
VFM_INLINE Lanes GreaterOf(const Lanes& a, const Lanes& b)
{
  return a > b ? a : b;
}
VFM_INLINE bool IsAny(const Mask& mask)
{
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

/// Slopes of some columns before they are limited, and the range of the differences to neighbours,
/// which includes 0.
struct Fit
{
  Lanes X, Y, Z, Least, Most;
};

/// Slopes along x, y, z and the shift of some columns.
using LineLanes = std::array<Lanes, 4>;

VFM_INLINE Fit FitLines(const SlopeInput& input, int column)
{
  const Lanes own = LoadLanes(input.Own + column);
  Lanes x{}, y{}, z{}, least{}, most{};
  for (const Neighbour& other : input.Around)
  {
    const Lanes difference = LoadLanes(other.Values + column) - own;
    x += other.Weighted[0] * difference;
    y += other.Weighted[1] * difference;
    z += other.Weighted[2] * difference;
    least = LesserOf(difference, least);
    most = GreaterOf(difference, most);
  }
  const Matrix& m = input.Inverse;
  return { m[0] * x + m[3] * y + m[4] * z, m[3] * x + m[1] * y + m[5] * z,
    m[4] * x + m[5] * y + m[2] * z, least, most };
}

/// Limits slopes, so that in the bounding box of the parts, values stay within the range of
/// neighbours.
VFM_INLINE LineLanes LimitLines(const Fit& fit, const Lanes& shift, const DonorShape& shape)
{
  const Lanes zero{};
  LineLanes line{ { fit.X, fit.Y, fit.Z, shift } };
  Lanes low = shift, high = shift;
  for (int a = 0; a < 3; ++a)
  {
    const Lanes atLower = line[a] * shape.Lower[a], atUpper = line[a] * shape.Upper[a];
    low += LesserOf(atLower, atUpper);
    high += GreaterOf(atLower, atUpper);
  }
  Lanes part = Fill(1.0);
  if (IsAny((low < fit.Least) | (high > fit.Most)))
  {
    part = low < fit.Least ? LesserOf(fit.Least / low, part) : part;
    part = high > fit.Most ? LesserOf(fit.Most / high, part) : part;
  }
  for (Lanes& number : line)
  {
    const Lanes limited = part * number;
    // A number is finite if its difference to itself is 0.
    number = ((part > zero) & (number - number == zero)) ? limited : zero;
  }
  return line;
}

/// Finds the slopes of a donor: 4 lists of columns. The density's slope comes first, because the
/// shifts of values per mass compensate its product with their slopes.
VFM_CLONES
void FindLines(const SlopeInput& input, const ColumnKinds& kinds, double* lines)
{
  const int first = kinds.Density / LaneCount * LaneCount;
  Vector3 weights{};
  for (int i = 0; i < kinds.Width; i += LaneCount)
  {
    const int c = (first + i) % kinds.Width;
    const Fit fit = FitLines(input, c);
    if (i == 0 && input.Mass > 0.0)
    {
      const LineLanes line = LimitLines(fit, Lanes{}, input.Shape);
      const int density = kinds.Density - first;
      weights = (-1.0 / input.Mass) *
        Product(input.Shape.Second, { { line[0][density], line[1][density], line[2][density] } });
    }
    const Lanes shift = weights[0] * fit.X + weights[1] * fit.Y + weights[2] * fit.Z;
    const LineLanes line =
      LimitLines(fit, LoadLanes(kinds.IsPerMass.data() + c) < 0.0 ? shift : Lanes{}, input.Shape);
    const Mask isSloping = LoadLanes(kinds.IsSloping.data() + c) < 0.0;
    for (int k = 0; k < 4; ++k)
    {
      StoreLanes(isSloping ? line[k] : Lanes{}, lines + k * kinds.Width + c);
    }
  }
}

/// Finds the slopes of donors, one after another.
class SlopeFinder
{
public:
  SlopeFinder(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
    const DonorValues& values, const DonorShapes& shapes) :
    Kinds(columns), Donors(donors), Values(values), Shapes(shapes), Steps(StepsAround(grid))
  {
  }

  /// Finds the slopes of donor s. lines: gets 4 lists of columns.
  void Find(int s, double* lines)
  {
    const double* own = this->Values.Of(s);
    const Matrix matrix = this->FindAround(s);
    const SlopeInput input{ this->Around, own, this->Shapes[s], Inverse(matrix),
      own[this->Kinds.Density] * this->Donors[s].Overlap };
    FindLines(input, this->Kinds, lines);
  }

private:
  /// Lists the neighbours of a donor. Returns the least-squares matrix.
  Matrix FindAround(int s)
  {
    const Donor& donor = this->Donors[s];
    Matrix m{};
    this->Around.clear();
    for (int row = 0; row < 27; row += 3)
    {
      const std::array<int, 3> three =
        this->Donors.FindThree(donor.Cell + this->Steps[row + 1], donor.Fragment);
      for (int n = 0; n < 3; ++n)
      {
        if (three[n] < 0 || three[n] == s ||
          !(this->Donors[three[n]].Volume > Little * donor.Volume))
        {
          continue;
        }
        const Vector3 x = this->Donors[three[n]].Centroid - donor.Centroid;
        const double square = Dot(x, x);
        if (square > 0.0)
        {
          const Vector3 w = (1.0 / square) * x;
          this->Around.push_back({ this->Values.Of(three[n]), w });
          m[0] += w[0] * x[0];
          m[1] += w[1] * x[1];
          m[2] += w[2] * x[2];
          m[3] += w[0] * x[1];
          m[4] += w[0] * x[2];
          m[5] += w[1] * x[2];
        }
      }
    }
    return m;
  }

  /// Returns the inverse of a matrix. It is zero across a plane or a line in which all neighbours
  /// are.
  static Matrix Inverse(const Matrix& m)
  {
    const double scale = (m[0] + m[1] + m[2]) / 3.0;
    if (!(scale > 0.0))
    {
      return {};
    }
    const Matrix minors{ { m[1] * m[2] - m[5] * m[5], m[0] * m[2] - m[4] * m[4],
      m[0] * m[1] - m[3] * m[3], m[4] * m[5] - m[3] * m[2], m[3] * m[5] - m[4] * m[1],
      m[3] * m[4] - m[5] * m[0] } };
    const double determinant = m[0] * minors[0] + m[3] * minors[3] + m[4] * minors[4];
    if (determinant > 0.01 * scale * scale * scale)
    {
      Matrix inverse;
      std::transform(minors.begin(), minors.end(), inverse.begin(),
        [determinant](double minor) { return minor / determinant; });
      return inverse;
    }
    return PseudoInverse(m);
  }
  static Matrix PseudoInverse(const Matrix& m)
  {
    Eigen::Matrix3d a;
    a << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
    Eigen::Vector3d inverse = solver.eigenvalues();
    const double least = Flat * inverse[2];
    for (int i = 0; i < 3; ++i)
    {
      inverse[i] = inverse[i] > least ? 1.0 / inverse[i] : 0.0;
    }
    a = solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
    return { { a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(0, 2), a(1, 2) } };
  }

  const ColumnKinds Kinds;
  const DonorTable& Donors;
  const DonorValues& Values;
  const DonorShapes& Shapes;
  const std::array<Index, 27> Steps; // offsets of the cells around
  std::vector<Neighbour> Around;
};

/// Returns whether all parts of a donor are at one position.
bool IsPoint(const DonorShape& shape)
{
  return !(shape.Lower[0] < shape.Upper[0] || shape.Lower[1] < shape.Upper[1] ||
    shape.Lower[2] < shape.Upper[2]);
}

} // namespace

Slopes::Slopes(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
  const DonorValues& values, const DonorShapes& shapes, const DonorLinks& links, Runtime& runtime) :
  Width(4 * columns.Width()), Zeros(this->Width, 0.0), Places(donors.Count(), -1)
{
  const int width = this->Width;
  std::vector<int> sloping;
  int places = 0;
  for (int s = 0; s < donors.Count(); ++s)
  {
    if (donors[s].IsOwned && !IsPoint(shapes[s]) && donors[s].Volume > 0.0)
    {
      sloping.push_back(s);
      this->Places[s] = places++;
    }
  }
  this->Lines.resize(static_cast<std::size_t>(places) * width);
  runtime.For(0, places,
    [&](Index begin, Index end)
    {
      SlopeFinder finder(columns, grid, donors, values, shapes);
      for (Index i = begin; i < end; ++i)
      {
        finder.Find(sloping[i], this->Lines.data() + i * width);
      }
    });
  links.Exchange(
    width,
    [&](int s, double* numbers)
    {
      if (this->Places[s] < 0)
      {
        std::fill_n(numbers, width, 0.0);
        return;
      }
      std::copy_n(
        this->Lines.data() + static_cast<std::size_t>(this->Places[s]) * width, width, numbers);
    },
    [&](int s, const double* numbers)
    {
      this->Places[s] = places++;
      this->Lines.insert(this->Lines.end(), numbers, numbers + width);
    });
}

} // namespace vfm
