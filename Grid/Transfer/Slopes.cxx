#include "Transfer/Slopes.h"

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

/// Finds the slopes of donors, one after another.
class SlopeFinder
{
public:
  SlopeFinder(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
    const DonorValues& values, const std::vector<DonorShape>& shapes) :
    Columns(columns),
    Donors(donors),
    Values(values),
    Shapes(shapes),
    Steps(StepsAround(grid)),
    Sums(5 * columns.Count())
  {
  }

  /// Finds the slopes of donor s. lines: gets 4 numbers per column.
  void Find(int s, double* lines)
  {
    this->FindAround(s);
    this->AddDifferences(s);
    const Eigen::Matrix3d inverse = this->InvertMatrix();
    for (int c : this->Columns.Order())
    {
      double* line = lines + 4 * c;
      std::fill_n(line, 4, 0.0);
      if (!this->Columns.IsConstant(c))
      {
        const int count = this->Columns.Count();
        const double* sums = this->Sums.data() + c;
        const Eigen::Vector3d slope =
          inverse * Eigen::Vector3d(sums[0], sums[count], sums[2 * count]);
        std::copy_n(slope.data(), 3, line);
        this->Limit(
          this->Shapes[s], sums[3 * count], sums[4 * count], this->FindShift(s, c, lines), line);
      }
    }
  }

private:
  struct Neighbour
  {
    int Donor;
    Vector3 Place; // position relative to the centroid
    double Weight;
  };
  /// Lists the neighbours of a donor.
  void FindAround(int s)
  {
    const Donor& donor = this->Donors[s];
    this->Around.clear();
    for (int n = 0; n < 27; ++n)
    {
      const int other =
        n == 13 ? -1 : this->Donors.Find(donor.Cell + this->Steps[n], donor.Fragment);
      if (other >= 0 && this->Donors[other].Volume > Little * donor.Volume)
      {
        const Vector3 x = this->Donors[other].Centroid - donor.Centroid;
        const double square = Dot(x, x);
        if (square > 0.0)
        {
          this->Around.push_back({ other, x, 1.0 / square });
        }
      }
    }
  }

  /// Returns the inverse of the least-squares matrix. It is zero across a plane or a line in which
  /// all neighbours are.
  Eigen::Matrix3d InvertMatrix() const
  {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    for (const Neighbour& other : this->Around)
    {
      const Eigen::Vector3d x(other.Place[0], other.Place[1], other.Place[2]);
      a += other.Weight * x * x.transpose();
    }
    const double scale = a.trace() / 3.0;
    if (!(scale > 0.0))
    {
      return Eigen::Matrix3d::Zero();
    }
    if (a.determinant() > 0.01 * scale * scale * scale)
    {
      return a.inverse();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
    Eigen::Vector3d inverse = solver.eigenvalues();
    const double least = Flat * inverse[2];
    for (int i = 0; i < 3; ++i)
    {
      inverse[i] = inverse[i] > least ? 1.0 / inverse[i] : 0.0;
    }
    return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
  }

  /// Sums the differences to neighbours, for all columns.
  void AddDifferences(int s)
  {
    const int count = this->Columns.Count();
    const double* own = this->Values.Of(s);
    std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
    for (const Neighbour& other : this->Around)
    {
      AddNeighbour(
        this->Values.Of(other.Donor), own, other.Weight * other.Place, count, this->Sums.data());
    }
  }

  /// Adds the differences to a neighbour. The loop is vectorised.
  static void AddNeighbour(const double* __restrict values, const double* __restrict own,
    const Vector3& weights, int count, double* __restrict sums)
  {
    const double x = weights[0], y = weights[1], z = weights[2];
    for (int c = 0; c < count; ++c)
    {
      const double difference = values[c] - own[c];
      double &least = sums[3 * count + c], &most = sums[4 * count + c];
      sums[c] += x * difference;
      sums[count + c] += y * difference;
      sums[2 * count + c] += z * difference;
      least = difference < least ? difference : least;
      most = difference > most ? difference : most;
    }
  }

  /// Returns the shift of a value that compensates the product of the slopes of mass and value.
  double FindShift(int s, int c, const double* lines) const
  {
    int base = this->Columns.Base(c);
    while (base >= 0 && this->Columns.IsConstant(base))
    {
      base = this->Columns.Base(base);
    }
    const double value = base < 0 ? 0.0 : this->Values.Of(s)[base] * this->Donors[s].Overlap;
    if (!(value > 0.0))
    {
      return 0.0;
    }
    const std::array<double, 6>& m = this->Shapes[s].Second;
    const double *g = lines + 4 * base, *h = lines + 4 * c;
    const double sum = g[0] * (m[0] * h[0] + m[3] * h[1] + m[4] * h[2]) +
      g[1] * (m[3] * h[0] + m[1] * h[1] + m[5] * h[2]) +
      g[2] * (m[4] * h[0] + m[5] * h[1] + m[2] * h[2]);
    return -sum / value;
  }

  /// Limits a slope, so that in the bounding box of the parts, values stay
  /// within the range of neighbours.
  /// @param least,most  range of the differences to neighbours, which includes 0
  static void Limit(const DonorShape& shape, double least, double most, double shift, double* line)
  {
    double low = shift, high = shift;
    for (int a = 0; a < 3; ++a)
    {
      const double atLower = line[a] * shape.Lower[a], atUpper = line[a] * shape.Upper[a];
      low += std::min(atLower, atUpper);
      high += std::max(atLower, atUpper);
    }
    double part = 1.0;
    part = low < least ? std::min(part, least / low) : part;
    part = high > most ? std::min(part, most / high) : part;
    line[3] = shift;
    for (int i = 0; i < 4; ++i)
    {
      line[i] = part > 0.0 && std::isfinite(line[i]) ? part * line[i] : 0.0;
    }
  }

  const StateColumns& Columns;
  const DonorTable& Donors;
  const DonorValues& Values;
  const std::vector<DonorShape>& Shapes;
  const std::array<Index, 27> Steps; // offsets of the cells around
  std::vector<Neighbour> Around;
  // Per column the right-hand side, three numbers, then the least and the largest difference: five
  // lists, each with one number per column.
  std::vector<double> Sums;
};

/// Returns whether all parts of a donor are at one position.
bool IsPoint(const DonorShape& shape)
{
  return !(shape.Lower[0] < shape.Upper[0] || shape.Lower[1] < shape.Upper[1] ||
    shape.Lower[2] < shape.Upper[2]);
}

} // namespace

Slopes::Slopes(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
  const DonorValues& values, const std::vector<DonorShape>& shapes, const DonorLinks& links,
  Runtime& runtime) :
  Columns(columns), Places(donors.Count(), -1)
{
  const int width = 4 * columns.Count();
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
