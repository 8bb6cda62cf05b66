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
// Above all rounding of fields, far below values that matter.
constexpr double LeadSlack = 1e-9;
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
    corners[c] = patch.Values[x + MaterialPatch::Row * y + MaterialPatch::Layer * z];
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

/// Reads the values of a patch at a corner of four octants, from its place in the first of them.
VFM_INLINE Lanes LoadOctants(const double* values)
{
  return __builtin_shufflevector(
    LoadLanes(values), LoadLanes(values + MaterialPatch::Row), 0, 1, 4, 5);
}

/// Returns the place of corner c of the first octant in a patch.
constexpr int PlaceOfCorner(int c)
{
  return (c & 1) + MaterialPatch::Row * (c >> 1 & 1) + MaterialPatch::Layer * (c >> 2);
}

/// Returns which of four lanes are set.
VFM_INLINE unsigned BitsOf(const Mask& lanes)
{
  const Mask bits = lanes & Mask{ 1, 2, 4, 8 };
  return static_cast<unsigned>((bits[0] | bits[1]) | (bits[2] | bits[3]));
}

/// Finds the octants in which one of two patches covers the other: a trilinear difference has its
/// extremes at corners.
VFM_CLONES void FindCovers(const double* first, const double* second, OctantDifferences& pair)
{
  pair.FirstCovers = pair.SecondCovers = 0;
  for (int half = 0; half < 2; ++half)
  {
    Lanes least = Fill(std::numeric_limits<double>::max()), greatest = -least;
    for (int c = 0; c < 8; ++c)
    {
      const int at = PlaceOfCorner(c) + half * MaterialPatch::Layer;
      const Lanes difference = LoadOctants(first + at) - LoadOctants(second + at);
      least = Least(least, difference);
      greatest = Greatest(greatest, difference);
    }
    pair.FirstCovers |= BitsOf(least >= Fill(0.0)) << 4 * half;
    pair.SecondCovers |= BitsOf(greatest <= Fill(0.0)) << 4 * half;
  }
}

/// Finds the means and the slopes of two patches in the octants. Sums are added in the order of
/// LinearDifference.
VFM_CLONES void FindPlanes(const double* first, const double* second, OctantDifferences& pair)
{
  for (int half = 0; half < 2; ++half)
  {
    const Lanes zero = Fill(0.0);
    Lanes mean = zero, x = zero, y = zero, z = zero, value = zero;
    for (int c = 0; c < 8; ++c)
    {
      const int at = PlaceOfCorner(c) + half * MaterialPatch::Layer;
      const Lanes a = LoadOctants(first + at), b = LoadOctants(second + at), d = a - b;
      const Lanes quarter = 0.25 * d;
      mean += 0.125 * d;
      x += (c & 1) ? quarter : -quarter;
      y += (c & 2) ? quarter : -quarter;
      z += (c & 4) ? quarter : -quarter;
      value += 0.0625 * (a + b);
    }
    StoreLanes(mean, pair.Mean.data() + 4 * half);
    StoreLanes(x, pair.Slope[0].data() + 4 * half);
    StoreLanes(y, pair.Slope[1].data() + 4 * half);
    StoreLanes(z, pair.Slope[2].data() + 4 * half);
    StoreLanes(value, pair.Value.data() + 4 * half);
  }
  pair.HasPlanes = true;
}

/// Rows of samples in an octant, and the largest field of each sample up to now.
struct SampleRows
{
  static constexpr int Count = SamplesAlong * SamplesAlong;
  Lanes Most[Count], Best[Count];
};

/// Updates samples by field f. Products are formed in the order of Trilinear.
VFM_INLINE void AddField(const Corners& values, int f, SampleRows& rows)
{
  const Lanes upper = (Lanes{ 0.0, 1.0, 2.0, 3.0 } + 0.5) / double(SamplesAlong);
  const Lanes lower = 1.0 - upper;
  Lanes alongX[8], alongXY[8];
  for (int c = 0; c < 8; ++c)
  {
    alongX[c] = values[c] * ((c & 1) ? upper : lower);
  }
  for (int j = 0; j < SamplesAlong; ++j)
  {
    const double y = (j + 0.5) / SamplesAlong;
    for (int c = 0; c < 8; ++c)
    {
      alongXY[c] = alongX[c] * ((c & 2) ? y : 1.0 - y);
    }
    for (int k = 0; k < SamplesAlong; ++k)
    {
      const double z = (k + 0.5) / SamplesAlong;
      Lanes value = Fill(0.0);
      for (int c = 0; c < 8; ++c)
      {
        value += alongXY[c] * ((c & 4) ? z : 1.0 - z);
      }
      const int row = SamplesAlong * j + k;
      rows.Best[row] = value > rows.Most[row] ? Fill(double(f)) : rows.Best[row];
      rows.Most[row] = Greatest(value, rows.Most[row]);
    }
  }
}

/// Counts the samples of an octant at which each field is the largest, the first of equal ones.
/// @param values  `count` fields at the corners
VFM_CLONES void CountWins(const Corners* values, int count, int* wins)
{
  static_assert(SamplesAlong == 4); // one row of samples is one set of lanes
  SampleRows rows;
  for (int row = 0; row < SampleRows::Count; ++row)
  {
    rows.Most[row] = Fill(-1.0);
    rows.Best[row] = Fill(0.0);
  }
  for (int f = 0; f < count; ++f)
  {
    AddField(values[f], f, rows);
  }
  for (const Lanes& best : rows.Best)
  {
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

/// A cell and those below and above it along an axis.
struct ThreeCells
{
  bool IsFirst, IsLast; // of the domain
  double Width, Below, Above;

  ThreeCells(const CartesianGrid& grid, int axis, Index i) :
    IsFirst(i == 0),
    IsLast(i == grid.Global().Upper[axis] - 1),
    Width(grid.Width(axis, i)),
    Below(grid.Width(axis, this->IsFirst ? i : i - 1)),
    Above(grid.Width(axis, this->IsLast ? i : i + 1))
  {
  }
};

/// Divides by the sum of two widths. A sum that is a power of 2 has an exact inverse, which is
/// faster and gives the same.
template <bool IsPowerOf2>
VFM_INLINE Lanes Divide(const Lanes& value, const Lanes& by)
{
  return IsPowerOf2 ? value * by : value / by;
}

/// Converts lanes of values at the centres of three cells to values on the sides of the second.
/// @param below, above  sums of widths, or their inverses
/// @param[in,out] low, high  first and third cell
template <bool IsPowerOf2>
VFM_INLINE void Interpolate(const ThreeCells& cells, double below, double above,
  const Lanes& middle, double* low, double* high)
{
  const Lanes atLow =
    Divide<IsPowerOf2>(LoadLanes(low) * cells.Width + middle * cells.Below, Fill(below));
  const Lanes atHigh =
    Divide<IsPowerOf2>(LoadLanes(high) * cells.Width + middle * cells.Above, Fill(above));
  StoreLanes(cells.IsFirst ? 2.0 * middle - atHigh : atLow, low);
  StoreLanes(cells.IsLast ? 2.0 * middle - atLow : atHigh, high);
}

/// Does the same along x, in each row of a patch.
template <bool IsPowerOf2>
VFM_INLINE void InterpolateRow(const ThreeCells& cells, double below, double above, double* row)
{
  const Lanes values = LoadLanes(row);
  const Lanes middle = __builtin_shufflevector(values, values, 1, 1, 1, 1);
  const Lanes sides =
    Divide<IsPowerOf2>(values * cells.Width + middle * Lanes{ cells.Below, 0.0, cells.Above, 0.0 },
      Lanes{ below, 1.0, above, 1.0 });
  const Lanes beyond =
    2.0 * middle - __builtin_shufflevector(sides, sides, 2, 1, 0, 3); // from the other side
  row[0] = cells.IsFirst ? beyond[0] : sides[0];
  row[2] = cells.IsLast ? beyond[2] : sides[2];
}

template <bool IsPowerOf2>
VFM_INLINE void InterpolateAll(
  const ThreeCells& cells, int axis, double below, double above, double* values)
{
  constexpr int row = MaterialPatch::Row, layer = MaterialPatch::Layer;
  for (int n = 0; axis == 0 && n < 9; ++n)
  {
    InterpolateRow<IsPowerOf2>(cells, below, above, values + row * n);
  }
  const int step = axis == 1 ? row : layer; // between values along the axis
  const int next = axis == 1 ? layer : row; // between rows across it
  for (int n = 0; axis != 0 && n < 3; ++n)
  {
    double* const low = values + next * n;
    Interpolate<IsPowerOf2>(cells, below, above, LoadLanes(low + step), low, low + 2 * step);
  }
}

/// Returns whether a number above 0 is a power of 2.
bool IsPowerOf2(double number)
{
  return (std::bit_cast<std::uint64_t>(number) & ((std::uint64_t(1) << 52) - 1)) == 0;
}

/// Converts the values of a patch at the centres of cells to values on the sides and in the middle
/// of the second cell along each axis. On a side of the domain the field is extrapolated, so that
/// planes stay planes.
/// @param cells  by axis
VFM_CLONES void InterpolatePatch(const std::array<ThreeCells, 3>& cells, double* values)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double below = cells[axis].Below + cells[axis].Width;
    const double above = cells[axis].Above + cells[axis].Width;
    if (IsPowerOf2(below) && IsPowerOf2(above))
    {
      InterpolateAll<true>(cells[axis], axis, 1.0 / below, 1.0 / above, values);
    }
    else
    {
      InterpolateAll<false>(cells[axis], axis, below, above, values);
    }
  }
}

} // namespace

/// The slack covers the rounding of both fields by other weights.
VFM_CLONES double FindLead(const MaterialPatch& one, const MaterialPatch& other)
{
  const Lanes zero = Fill(0.0), slack = Fill(LeadSlack);
  const Mask isUsed{ -1, -1, -1, 0 };
  Lanes lead = Fill(std::numeric_limits<double>::max());
  for (int row = 0; row < MaterialPatch::Size; row += MaterialPatch::Row)
  {
    const Lanes values = LoadLanes(one.Values.data() + row) - slack;
    const Lanes others = Greatest(LoadLanes(other.Values.data() + row), zero) + slack;
    lead = isUsed ? Least(lead, values / others) : lead;
  }
  return std::min({ lead[0], lead[1], lead[2] });
}

PatchFinder::PatchFinder(const CartesianGrid& grid, int numberOfMaterials) :
  Grid(grid), ValuesOf(numberOfMaterials + 1, this->Unused.data())
{
}

void PatchFinder::Begin(std::span<const int> materials)
{
  this->Patches.resize(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    this->Patches[m].Material = materials[m];
    this->Patches[m].Values.fill(0.0);
    this->ValuesOf[materials[m]] = this->Patches[m].Values.data();
  }
}

void PatchFinder::End(const Index3& cell)
{
  const std::array<ThreeCells, 3> cells{ { ThreeCells(this->Grid, 0, cell[0]),
    ThreeCells(this->Grid, 1, cell[1]), ThreeCells(this->Grid, 2, cell[2]) } };
  for (MaterialPatch& patch : this->Patches)
  {
    InterpolatePatch(cells, patch.Values.data());
    this->ValuesOf[patch.Material] = this->Unused.data();
  }
}

const std::vector<double>& SharpFractions::Find(
  const std::vector<MaterialPatch>& patches, std::vector<PairRate>* rates)
{
  this->Fractions.assign(patches.size(), 0.0);
  this->FindContenders(patches);
  for (int octant = 0; octant < 8; ++octant)
  {
    int count = 0;
    std::size_t first = 0, last = 0; // contenders
    for (std::size_t p = 0; p < patches.size(); ++p)
    {
      if (this->IsContender[p] >> octant & 1)
      {
        first = count == 0 ? p : first;
        last = p;
        ++count;
      }
    }
    if (count == 1)
    {
      this->Fractions[first] += OctantPart;
    }
    else if (count == 2)
    {
      this->PartByPlane(patches, first, last, octant, rates);
    }
    else
    {
      this->PartBySamples(patches, octant);
    }
  }
  return this->Fractions;
}

/// Finds the patches that no other covers in each octant, the first of equal ones.
void SharpFractions::FindContenders(const std::vector<MaterialPatch>& patches)
{
  const std::size_t count = patches.size();
  this->Pairs.resize(count * (count - 1) / 2);
  this->IsContender.assign(count, 0xffu);
  for (std::size_t second = 1; second < count; ++second)
  {
    unsigned& isContender = this->IsContender[second];
    for (std::size_t first = 0; first < second; ++first)
    {
      OctantDifferences& pair = this->Pair(first, second);
      pair.HasPlanes = false;
      FindCovers(patches[first].Values.data(), patches[second].Values.data(), pair);
      isContender &= ~(this->IsContender[first] & pair.FirstCovers);
    }
    for (std::size_t first = 0; first < second; ++first)
    {
      this->IsContender[first] &= ~(isContender & this->Pair(first, second).SecondCovers);
    }
  }
}

void SharpFractions::PartByPlane(const std::vector<MaterialPatch>& patches, std::size_t first,
  std::size_t second, int octant, std::vector<PairRate>* rates)
{
  OctantDifferences& pair = this->Pair(first, second);
  if (!pair.HasPlanes)
  {
    FindPlanes(patches[first].Values.data(), patches[second].Values.data(), pair);
  }
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
  this->Corners.clear();
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    if (this->IsContender[p] >> octant & 1)
    {
      this->Corners.push_back(CornersOfOctant(patches[p], octant));
    }
  }
  this->Wins.assign(this->Corners.size(), 0);
  CountWins(this->Corners.data(), static_cast<int>(this->Corners.size()), this->Wins.data());
  auto wins = this->Wins.begin();
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    if (this->IsContender[p] >> octant & 1)
    {
      this->Fractions[p] += OctantPart * (static_cast<double>(*wins++) / count);
    }
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
