#include "Fractions/SharpFractions.h"

#include "Base/Vector3.h"
#include "Fractions/Plic.h"

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

/// Returns whether a is nowhere less than b in the octant: a trilinear difference has
/// its extremes at corners.
bool Covers(const Corners& a, const Corners& b)
{
  for (int c = 0; c < 8; ++c)
  {
    if (a[c] < b[c])
    {
      return false;
    }
  }
  return true;
}

struct Contender
{
  std::size_t Patch;
  Corners Values;
  double Part; // fraction of the octant
};

/// Returns the patches that no other covers, the first of equal ones.
std::vector<Contender> FindContenders(const std::vector<MaterialPatch>& patches, int octant)
{
  std::vector<Contender> found;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    const Contender next{ p, CornersOfOctant(patches[p], octant), 0.0 };
    const auto covers = [&next](const Contender& other)
    { return Covers(other.Values, next.Values); };
    if (std::none_of(found.begin(), found.end(), covers))
    {
      const auto covered = [&next](const Contender& other)
      { return Covers(next.Values, other.Values); };
      found.erase(std::remove_if(found.begin(), found.end(), covered), found.end());
      found.push_back(next);
    }
  }
  return found;
}

/// Difference of two contenders as a linear function in the unit cube around 0: Mean + Slope.x
struct Difference
{
  double Mean = 0.0;
  Vector3 Slope{ { 0.0, 0.0, 0.0 } };

  Difference(const Corners& a, const Corners& b)
  {
    for (int c = 0; c < 8; ++c)
    {
      const double d = a[c] - b[c];
      this->Mean += 0.125 * d;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Slope[axis] += (c >> axis & 1) ? 0.25 * d : -0.25 * d;
      }
    }
  }
  /// Returns the fraction of the cube where it is above -shift.
  double PartAbove(double shift) const
  {
    return Norm(this->Slope) > Flat ? VolumeBelowPlane(-1.0 * this->Slope, this->Mean + shift)
                                    : (this->Mean + shift >= 0.0 ? 1.0 : 0.0);
  }
};

void PartByPlane(std::vector<Contender>& two, const std::vector<MaterialPatch>& patches,
  std::vector<PairRate>* rates)
{
  const Difference difference(two[0].Values, two[1].Values);
  two[0].Part = difference.PartAbove(0.0);
  two[1].Part = 1.0 - two[0].Part;
  if (!rates)
  {
    return;
  }
  double value = 0.0; // approximate value of both fields where they are equal
  for (int c = 0; c < 8; ++c)
  {
    value += 0.0625 * (two[0].Values[c] + two[1].Values[c]);
  }
  const double step = RelativeStep * Norm(difference.Slope);
  const double rate = step > 0.0
    ? (difference.PartAbove(step) - difference.PartAbove(-step)) / (2.0 * step) * value
    : 0.0;
  rates->push_back(
    { patches[two[0].Patch].Material, patches[two[1].Patch].Material, OctantPart * rate });
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

void PartBySamples(std::vector<Contender>& several)
{
  constexpr int count = SamplesAlong * SamplesAlong * SamplesAlong;
  std::vector<int> wins(several.size(), 0);
  for (int s = 0; s < count; ++s)
  {
    const Vector3 x{ { (s % SamplesAlong + 0.5) / SamplesAlong,
      (s / SamplesAlong % SamplesAlong + 0.5) / SamplesAlong,
      (s / (SamplesAlong * SamplesAlong) + 0.5) / SamplesAlong } };
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t c = 0; c < several.size(); ++c)
    {
      const double value = Trilinear(several[c].Values, x);
      if (value > most)
      {
        most = value;
        best = c;
      }
    }
    ++wins[best];
  }
  for (std::size_t c = 0; c < several.size(); ++c)
  {
    several[c].Part = static_cast<double>(wins[c]) / count;
  }
}

/// Part of a child in one octant.
struct Piece
{
  double Part; // fraction of the child
  Difference Ahead;
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
    pieces.push_back({ part, Difference(own, others) });
  }
  return pieces;
}

/// Converts the values at the centres of three cells in a row to values on the sides and
/// in the middle of the second. On a side of the domain the field is extrapolated, so
/// that planes stay planes.
void Interpolate(const CartesianGrid& grid, int axis, Index i, std::array<double, 27>& values)
{
  const Index last = grid.Global().Upper[axis] - 1;
  const double width = grid.Width(axis, i);
  const double below = grid.Width(axis, std::max<Index>(i - 1, 0));
  const double above = grid.Width(axis, std::min(i + 1, last));
  const int step = axis == 0 ? 1 : (axis == 1 ? 3 : 9);
  for (int v = 0; v < 27; ++v)
  {
    if (v / step % 3 == 1)
    {
      const double middle = values[v];
      const double low = (values[v - step] * width + middle * below) / (below + width);
      const double high = (values[v + step] * width + middle * above) / (above + width);
      values[v - step] = i == 0 ? 2.0 * middle - high : low;
      values[v + step] = i == last ? 2.0 * middle - low : high;
    }
  }
}

} // namespace

std::vector<MaterialPatch> MakePatches(const CartesianGrid& grid, const FractionField& smooth,
  const Index3& cell, const std::vector<int>& materials, const std::vector<double>& weights)
{
  std::array<Index, 27> around;
  for (int v = 0; v < 27; ++v)
  {
    around[v] = grid.Linear(grid.Global().Nearest(CellAround(cell, v)));
  }
  std::vector<MaterialPatch> patches;
  for (int material : materials)
  {
    patches.push_back({ material, {} });
    std::array<double, 27>& values = patches.back().Values;
    for (int v = 0; v < 27; ++v)
    {
      values[v] = weights[material] * smooth.Fraction(around[v], material);
    }
    for (int a = 0; a < 3; ++a)
    {
      Interpolate(grid, a, cell[a], values);
    }
  }
  return patches;
}

std::vector<FractionField::Part> FindSharpFractions(
  const std::vector<MaterialPatch>& patches, std::vector<PairRate>* rates)
{
  std::vector<double> fractions(patches.size(), 0.0);
  for (int octant = 0; octant < 8; ++octant)
  {
    std::vector<Contender> contenders = FindContenders(patches, octant);
    if (contenders.size() == 1)
    {
      contenders[0].Part = 1.0;
    }
    else if (contenders.size() == 2)
    {
      PartByPlane(contenders, patches, rates);
    }
    else
    {
      PartBySamples(contenders);
    }
    for (const Contender& c : contenders)
    {
      fractions[c.Patch] += OctantPart * c.Part;
    }
  }
  std::vector<FractionField::Part> parts;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    if (fractions[p] > 0.0)
    {
      parts.push_back({ patches[p].Material, fractions[p] });
    }
  }
  return parts;
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
