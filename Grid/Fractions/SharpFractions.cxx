#include "Fractions/SharpFractions.h"

#include "Base/Lanes.h"
#include "Fractions/Plic.h"

#include <bit>
#include <limits>
#include <optional>

namespace vfm
{
namespace
{

// Samples along an edge of an octant where three materials meet.
constexpr int SamplesAlong = 4;
constexpr double RelativeStep = 1e-3; // relative change of a difference that measures its rate
constexpr double Flat = 1e-12;        // a difference with a smaller slope has no plane
constexpr double OctantPart = 0.125;
// Fields differ by at most 1 at cells, and by less than this between them.
constexpr double LargestShift = 8.0;
constexpr double SmallestShift = 1e-12;

using Corners = std::array<double, 8>;

Corners CornersOfOctant(const MaterialPatch& patch, int octant)
{
  Corners corners;
  for (int c = 0; c < 8; ++c)
  {
    const int x = (octant & 1) + (c & 1), y = (octant >> 1 & 1) + (c >> 1 & 1);
    const int z = (octant >> 2 & 1) + (c >> 2 & 1);
    corners[c] = patch.Values[x + 3 * y + 9 * z];
  }
  return corners;
}

/// LinearDifference of two fields as a linear function in the unit cube around 0: Mean + Slope.x
class LinearDifference
{
public:
  LinearDifference(double mean, const Vector3& slope) : Mean(mean), Size(Norm(slope))
  {
    if (this->Size > Flat)
    {
      this->Below.emplace(-1.0 * slope);
    }
  }
  LinearDifference(const Corners& a, const Corners& b) :
    LinearDifference(MeanOf(a, b), SlopeOf(a, b))
  {
  }

  /// Returns the length of the slope.
  double Steepness() const { return this->Size; }
  /// Returns the fraction of the cube where it is above -shift.
  double PartAbove(double shift) const
  {
    return this->Below ? this->Below->Volume(this->Mean + shift)
                       : (this->Mean + shift >= 0.0 ? 1.0 : 0.0);
  }

private:
  static double MeanOf(const Corners& a, const Corners& b)
  {
    double mean = 0.0;
    for (int c = 0; c < 8; ++c)
    {
      mean += 0.125 * (a[c] - b[c]);
    }
    return mean;
  }
  static Vector3 SlopeOf(const Corners& a, const Corners& b)
  {
    Vector3 slope{ { 0.0, 0.0, 0.0 } };
    for (int c = 0; c < 8; ++c)
    {
      const double d = a[c] - b[c];
      for (int axis = 0; axis < 3; ++axis)
      {
        slope[axis] += (c >> axis & 1) ? 0.25 * d : -0.25 * d;
      }
    }
    return slope;
  }

  double Mean, Size;
  std::optional<CellBelowPlanes> Below; // unless it is flat
};

/// Values of a patch at corner c of the octants with bits 0 and 1 = 0 .. 3, from the place of that
/// corner of the first of them.
VFM_INLINE Lanes LoadOctants(const double* values)
{
  return __builtin_shufflevector(LoadLanes(values), LoadLanes(values + 1), 0, 1, 3, 7);
}

/// Compares two patches in four octants. Sums are added in the order of LinearDifference.
/// @param first, second  values of the patches, from the lowest corner of the octants
/// @param[out] pair  numbers of the octants from `octant` on are set
VFM_INLINE void CompareFour(
  const double* first, const double* second, int octant, OctantDifferences& pair)
{
  const Lanes zero = Fill(0.0);
  Lanes least = Fill(std::numeric_limits<double>::max()), greatest = -least;
  Lanes mean = zero, x = zero, y = zero, z = zero, value = zero;
  for (int c = 0; c < 8; ++c)
  {
    const int at = (c & 1) + 3 * (c >> 1 & 1) + 9 * (c >> 2);
    const Lanes a = LoadOctants(first + at), b = LoadOctants(second + at), d = a - b;
    const Lanes quarter = 0.25 * d;
    least = Least(least, d);
    greatest = Greatest(greatest, d);
    mean += 0.125 * d;
    x += (c & 1) ? quarter : -quarter;
    y += (c & 2) ? quarter : -quarter;
    z += (c & 4) ? quarter : -quarter;
    value += 0.0625 * (a + b);
  }
  StoreLanes(least, pair.Least.data() + octant);
  StoreLanes(greatest, pair.Greatest.data() + octant);
  StoreLanes(mean, pair.Mean.data() + octant);
  StoreLanes(x, pair.Slope[0].data() + octant);
  StoreLanes(y, pair.Slope[1].data() + octant);
  StoreLanes(z, pair.Slope[2].data() + octant);
  StoreLanes(value, pair.Value.data() + octant);
}

VFM_CLONES void CompareOctants(const double* first, const double* second, OctantDifferences& pair)
{
  CompareFour(first, second, 0, pair);
  CompareFour(first + 9, second + 9, 4, pair);
}

/// Counts the samples of an octant at which each field is the largest, the first of equal ones.
/// Products are formed in the order of Trilinear.
/// @param values  `count` fields at the corners
VFM_CLONES void CountWins(const Corners* values, int count, int* wins)
{
  static_assert(SamplesAlong == 4); // one row of samples is one set of lanes
  const Lanes upper = (Lanes{ 0.0, 1.0, 2.0, 3.0 } + 0.5) / double(SamplesAlong);
  const Lanes lower = 1.0 - upper;
  for (int row = 0; row < SamplesAlong * SamplesAlong; ++row)
  {
    const double y = (row % SamplesAlong + 0.5) / SamplesAlong;
    const double z = (row / SamplesAlong + 0.5) / SamplesAlong;
    const double alongY[] = { 1.0 - y, y }, alongZ[] = { 1.0 - z, z };
    Lanes most = Fill(-1.0), best = Fill(0.0);
    for (int f = 0; f < count; ++f)
    {
      Lanes value = Fill(0.0);
      for (int c = 0; c < 8; ++c)
      {
        value += values[f][c] * ((c & 1) ? upper : lower) * alongY[c >> 1 & 1] * alongZ[c >> 2 & 1];
      }
      best = value > most ? Fill(double(f)) : best;
      most = Greatest(value, most);
    }
    for (int lane = 0; lane < SamplesAlong; ++lane)
    {
      ++wins[static_cast<int>(best[lane])];
    }
  }
}

double Trilinear(const Corners& values, const Vector3& x)
{
  double result = 0.0;
  for (int c = 0; c < 8; ++c)
  {
    result += values[c] * ((c & 1) ? x[0] : 1.0 - x[0]) * ((c & 2) ? x[1] : 1.0 - x[1]) *
      ((c & 4) ? x[2] : 1.0 - x[2]);
  }
  return result;
}

/// Part of a child in one octant.
struct Piece
{
  double Part; // fraction of the child
  LinearDifference Ahead;
};

/// Interval of child n of several in the lower or upper half of a cell; the half is [0, 1].
struct HalfInterval
{
  double Lower, Upper;

  HalfInterval(Index n, Index count, int half) :
    Lower(Clamp(2 * n - half * count, count)), Upper(Clamp(2 * n + 2 - half * count, count))
  {
  }
  /// Returns the fraction of the child in this half.
  double Part(Index count) const
  {
    return 0.5 * static_cast<double>(count) * (this->Upper - this->Lower);
  }

private:
  static double Clamp(Index value, Index count)
  {
    const Index inside = std::min(std::max<Index>(value, 0), count);
    return static_cast<double>(inside) / static_cast<double>(count);
  }
};

/// Returns the pieces of a child in the octants of its cell, with the lead of one
/// field over the other.
std::vector<Piece> CutAtOctants(const MaterialPatch& first, const MaterialPatch& second,
  const Index3& child, const Index3& counts)
{
  std::vector<Piece> pieces;
  for (int octant = 0; octant < 8; ++octant)
  {
    const HalfInterval x(child[0], counts[0], octant & 1), y(child[1], counts[1], octant >> 1 & 1),
      z(child[2], counts[2], octant >> 2 & 1);
    const double part = x.Part(counts[0]) * y.Part(counts[1]) * z.Part(counts[2]);
    if (!(part > 0.0))
    {
      continue;
    }
    const Corners a = CornersOfOctant(first, octant), b = CornersOfOctant(second, octant);
    Corners own, others;
    for (int c = 0; c < 8; ++c)
    {
      const Vector3 at{ { c & 1 ? x.Upper : x.Lower, c & 2 ? y.Upper : y.Lower,
        c & 4 ? z.Upper : z.Lower } };
      own[c] = Trilinear(a, at);
      others[c] = Trilinear(b, at);
    }
    pieces.push_back({ part, LinearDifference(own, others) });
  }
  return pieces;
}

/// Divides by a width. A width that is a power of 2 has an exact inverse, which is faster and gives
/// the same.
class WidthDivisor
{
public:
  explicit WidthDivisor(double width) : Width(width), Inverse(1.0 / width)
  {
    constexpr std::uint64_t digits = (std::uint64_t(1) << 52) - 1;
    this->IsPower = (std::bit_cast<std::uint64_t>(width) & digits) == 0;
  }
  bool IsPowerOf2() const { return this->IsPower; }
  double Divide(double value) const { return value / this->Width; }
  double Multiply(double value) const { return value * this->Inverse; }

private:
  double Width, Inverse;
  bool IsPower;
};

/// A cell and those below and above it along an axis.
struct ThreeCells
{
  bool IsFirst, IsLast; // of the domain
  double Width, Below, Above;
  WidthDivisor WithBelow, WithAbove; // of the sums of two widths

  ThreeCells(const CartesianGrid& grid, int axis, Index i) :
    IsFirst(i == 0),
    IsLast(i == grid.Global().Upper[axis] - 1),
    Width(grid.Width(axis, i)),
    Below(grid.Width(axis, this->IsFirst ? i : i - 1)),
    Above(grid.Width(axis, this->IsLast ? i : i + 1)),
    WithBelow(this->Below + this->Width),
    WithAbove(this->Above + this->Width)
  {
  }
};

/// Converts the values at the centres of three cells in a row to values on the sides and
/// in the middle of the second. On a side of the domain the field is extrapolated, so
/// that planes stay planes.
/// @param Step  places between values along the axis: 1, 3 or 9
/// @param divide  divide(value, divisor)
template <int Step, class Divide>
void Interpolate(const ThreeCells& cells, const Divide& divide, double* values)
{
  for (int n = 0; n < 9; ++n)
  {
    double* const v = values + (Step == 1 ? 3 * n : (Step == 3 ? n % 3 + n / 3 * 9 : n));
    const double middle = v[Step];
    const double low = divide(v[0] * cells.Width + middle * cells.Below, cells.WithBelow);
    const double high = divide(v[2 * Step] * cells.Width + middle * cells.Above, cells.WithAbove);
    v[0] = cells.IsFirst ? 2.0 * middle - high : low;
    v[2 * Step] = cells.IsLast ? 2.0 * middle - low : high;
  }
}

template <int Axis>
void Interpolate(const CartesianGrid& grid, const Index3& cell, std::vector<MaterialPatch>& patches)
{
  constexpr int step = Axis == 0 ? 1 : (Axis == 1 ? 3 : 9);
  const ThreeCells cells(grid, Axis, cell[Axis]);
  const auto divide = [](double value, const WidthDivisor& by) { return by.Divide(value); };
  const auto multiply = [](double value, const WidthDivisor& by) { return by.Multiply(value); };
  const bool multiplies = cells.WithBelow.IsPowerOf2() && cells.WithAbove.IsPowerOf2();
  for (MaterialPatch& patch : patches)
  {
    multiplies ? Interpolate<step>(cells, multiply, patch.Values.data())
               : Interpolate<step>(cells, divide, patch.Values.data());
  }
}

/// Returns the cells around a cell, those of the domain that are nearest to them.
std::array<Index, 27> ListAround(const CartesianGrid& grid, const Index3& cell)
{
  std::array<std::array<Index, 3>, 3> shift; // of the linear index, by axis and step
  for (int a = 0; a < 3; ++a)
  {
    shift[a] = { { cell[a] > grid.Global().Lower[a] ? -grid.Stride(a) : 0, 0,
      cell[a] + 1 < grid.Global().Upper[a] ? grid.Stride(a) : 0 } };
  }
  std::array<Index, 27> around;
  for (int v = 0; v < 27; ++v)
  {
    around[v] = grid.Linear(cell) + shift[0][v % 3] + shift[1][v / 3 % 3] + shift[2][v / 9];
  }
  return around;
}

} // namespace

PatchFinder::PatchFinder(const CartesianGrid& grid, const FractionField& smooth) :
  Grid(grid), Smooth(smooth), ValuesOf(smooth.NumberOfMaterials() + 1, this->Unused.data())
{
}

const std::vector<MaterialPatch>& PatchFinder::Find(
  const Index3& cell, std::span<const int> materials, const std::vector<double>& weights)
{
  this->Patches.resize(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    this->Patches[m].Material = materials[m];
    this->Patches[m].Values.fill(0.0);
    this->ValuesOf[materials[m]] = this->Patches[m].Values.data();
  }
  const std::array<Index, 27> around = ListAround(this->Grid, cell);
  for (int v = 0; v < 27; ++v)
  {
    this->Smooth.ForParts(around[v],
      [&](int material, double fraction)
      { this->ValuesOf[material][v] = weights[material] * fraction; });
  }
  Interpolate<0>(this->Grid, cell, this->Patches);
  Interpolate<1>(this->Grid, cell, this->Patches);
  Interpolate<2>(this->Grid, cell, this->Patches);
  for (int material : materials)
  {
    this->ValuesOf[material] = this->Unused.data();
  }
  return this->Patches;
}

const std::vector<double>& SharpFractions::Find(
  const std::vector<MaterialPatch>& patches, std::vector<PairRate>* rates)
{
  this->Fractions.assign(patches.size(), 0.0);
  this->Compare(patches);
  for (int octant = 0; octant < 8; ++octant)
  {
    this->FindContenders(patches.size(), octant);
    if (this->Contenders.size() == 1)
    {
      this->Fractions[this->Contenders[0]] += OctantPart;
    }
    else if (this->Contenders.size() == 2)
    {
      this->PartByPlane(patches, octant, rates);
    }
    else
    {
      this->PartBySamples(patches, octant);
    }
  }
  return this->Fractions;
}

void SharpFractions::Compare(const std::vector<MaterialPatch>& patches)
{
  this->Pairs.resize(patches.size() * (patches.size() - 1) / 2);
  auto pair = this->Pairs.begin();
  for (std::size_t second = 1; second < patches.size(); ++second)
  {
    for (std::size_t first = 0; first < second; ++first)
    {
      CompareOctants(patches[first].Values.data(), patches[second].Values.data(), *pair++);
    }
  }
}

/// @param second  above first
const OctantDifferences& SharpFractions::Pair(std::size_t first, std::size_t second) const
{
  return this->Pairs[second * (second - 1) / 2 + first];
}

/// A patch covers another one in an octant if it is nowhere less: a trilinear difference has its
/// extremes at corners.
void SharpFractions::FindContenders(std::size_t patches, int octant)
{
  std::vector<std::size_t>& found = this->Contenders;
  found.clear();
  for (std::size_t p = 0; p < patches; ++p)
  {
    const auto covers = [&](std::size_t other)
    { return this->Pair(other, p).Least[octant] >= 0.0; };
    if (std::none_of(found.begin(), found.end(), covers))
    {
      const auto isCovered = [&](std::size_t other)
      { return this->Pair(other, p).Greatest[octant] <= 0.0; };
      found.erase(std::remove_if(found.begin(), found.end(), isCovered), found.end());
      found.push_back(p);
    }
  }
}

void SharpFractions::PartByPlane(
  const std::vector<MaterialPatch>& patches, int octant, std::vector<PairRate>* rates)
{
  const std::size_t first = this->Contenders[0], second = this->Contenders[1];
  const OctantDifferences& pair = this->Pair(first, second);
  const LinearDifference difference(
    pair.Mean[octant], { { pair.Slope[0][octant], pair.Slope[1][octant], pair.Slope[2][octant] } });
  const double part = difference.PartAbove(0.0);
  this->Fractions[first] += OctantPart * part;
  this->Fractions[second] += OctantPart * (1.0 - part);
  if (rates)
  {
    // The mean of both fields is their approximate value where they are equal.
    const double step = RelativeStep * difference.Steepness();
    const double rate = step > 0.0 ? (difference.PartAbove(step) - difference.PartAbove(-step)) /
        (2.0 * step) * pair.Value[octant]
                                   : 0.0;
    rates->push_back({ patches[first].Material, patches[second].Material, OctantPart * rate });
  }
}

void SharpFractions::PartBySamples(const std::vector<MaterialPatch>& patches, int octant)
{
  constexpr int count = SamplesAlong * SamplesAlong * SamplesAlong;
  this->Rest.clear();
  for (std::size_t p : this->Contenders)
  {
    this->Rest.push_back(CornersOfOctant(patches[p], octant));
  }
  this->Wins.assign(this->Contenders.size(), 0);
  CountWins(this->Rest.data(), static_cast<int>(this->Rest.size()), this->Wins.data());
  for (std::size_t c = 0; c < this->Contenders.size(); ++c)
  {
    this->Fractions[this->Contenders[c]] +=
      OctantPart * (static_cast<double>(this->Wins[c]) / count);
  }
}

std::vector<double> ShareChildren(
  const MaterialPatch& first, const MaterialPatch& second, const Index3& counts, double fraction)
{
  std::vector<std::vector<Piece>> children;
  for (Index z = 0; z < counts[2]; ++z)
  {
    for (Index y = 0; y < counts[1]; ++y)
    {
      for (Index x = 0; x < counts[0]; ++x)
      {
        children.push_back(CutAtOctants(first, second, { { x, y, z } }, counts));
      }
    }
  }
  const double childPart = 1.0 / static_cast<double>(children.size());
  const auto share = [&](double shift, std::vector<double>& parts)
  {
    double sum = 0.0;
    for (std::size_t c = 0; c < children.size(); ++c)
    {
      parts[c] = 0.0;
      for (const Piece& piece : children[c])
      {
        parts[c] += piece.Part * piece.Ahead.PartAbove(shift);
      }
      sum += childPart * parts[c];
    }
    return sum;
  };
  double low = -LargestShift, high = LargestShift;
  std::vector<double> less(children.size()), more(children.size()), trial(children.size());
  double lessSum = share(low, less), moreSum = share(high, more);
  while (high - low > SmallestShift)
  {
    const double middle = 0.5 * (low + high), sum = share(middle, trial);
    (sum < fraction ? low : high) = middle;
    (sum < fraction ? less : more) = trial;
    (sum < fraction ? lessSum : moreSum) = sum;
  }
  // Where the fields are parallel, the sum jumps; interpolates across the jump.
  const double t = moreSum > lessSum ? (fraction - lessSum) / (moreSum - lessSum) : 0.0;
  for (std::size_t c = 0; c < children.size(); ++c)
  {
    less[c] += t * (more[c] - less[c]);
  }
  return less;
}

} // namespace vfm
