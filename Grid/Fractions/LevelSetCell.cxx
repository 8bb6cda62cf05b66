#include "Fractions/LevelSetCell.h"

#include "Fractions/LevelSetVolumes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfm
{
namespace
{

constexpr int FineParts = 4; // of a cell along each axis
constexpr int FineNodes = FineParts + 1;
// Of the largest slope, that are taken for a kink:
constexpr double SlopeJump = 0.8;         // difference of the slopes on both sides of two centres
constexpr double UnequalJump = 0.5;       // difference of its parts at both centres
constexpr double NegligibleShare = 1e-13; // of a cell
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

using Line = std::array<double, StencilWidth>;
using FineLine = std::array<double, FineNodes>;

/// Interpolation along one axis of a cell, from the centres of the cells to the nodes of its parts.
class LineInterpolation
{
public:
  LineInterpolation(const Line& centres, double lower, double upper) : Centres(centres)
  {
    for (int n = 0; n < FineNodes; ++n)
    {
      const double share = static_cast<double>(n) / FineParts;
      const double x = (1.0 - share) * lower + share * upper;
      Place& place = this->Places[n];
      place.First = x < centres[LevelSetLayers] ? LevelSetLayers - 1 : LevelSetLayers;
      const double* c = centres.data() + place.First;
      place.After = x - c[0];
      place.Before = c[1] - x;
      place.Right = (x - c[-1]) / (c[2] - c[-1]);
      place.LeftScale = 1.0 / (c[1] - c[-1]);
      place.RightScale = 1.0 / (c[2] - c[0]);
    }
  }

  /// @param slope  largest slope of the function near the cell
  FineLine Find(const Line& f, double slope) const
  {
    FineLine found{};
    const Line slopes = this->SlopesOf(f);
    for (int n = 0; n < FineNodes; ++n)
    {
      const Place& p = this->Places[n];
      const double left = slopes[p.First - 1], middle = slopes[p.First],
                   right = slopes[p.First + 1];
      const bool isKink = std::abs(right - left) > SlopeJump * slope ||
        std::abs(left + right - 2.0 * middle) > UnequalJump * slope;
      const double f0 = f[p.First], f1 = f[p.First + 1];
      if (isKink && (middle - left) * (right - middle) >= 0.0)
      {
        const double fromLeft = f0 + p.After * left, fromRight = f1 - p.Before * right;
        found[n] = right > left ? std::max(fromLeft, fromRight) : std::min(fromLeft, fromRight);
        continue;
      }
      const double bend =
        (1.0 - p.Right) * (middle - left) * p.LeftScale + p.Right * (right - middle) * p.RightScale;
      found[n] = f0 + p.After * middle - (isKink ? 0.0 : p.After * p.Before * bend);
    }
    return found;
  }

  /// Returns the largest slope between neighbours.
  double SlopeOf(const Line& f) const
  {
    double slope = 0.0;
    for (double one : this->SlopesOf(f))
    {
      slope = std::max(slope, std::abs(one));
    }
    return slope;
  }

private:
  /// A node between two centres.
  struct Place
  {
    int First;                    // centre below the node
    double After, Before;         // distances from both
    double Right;                 // weight of the parabola through the next centre
    double LeftScale, RightScale; // from differences of slopes to second divided differences
  };

  /// Returns the slopes between neighbours.
  Line SlopesOf(const Line& f) const
  {
    Line slopes{};
    for (int i = 0; i + 1 < StencilWidth; ++i)
    {
      slopes[i] = (f[i + 1] - f[i]) / (this->Centres[i + 1] - this->Centres[i]);
    }
    return slopes;
  }

  Line Centres;
  std::array<Place, FineNodes> Places{};
};

using FineValues = std::array<double, FineNodes * FineNodes * FineNodes>;

constexpr std::array<int, 3> Strides{ { 1, StencilWidth, StencilWidth* StencilWidth } };
constexpr int Middle =
  LevelSetLayers * (1 + StencilWidth + StencilWidth * StencilWidth); // the cell itself

/// Interpolates one function to the nodes of the parts of a cell.
/// @note Both counts along an axis are 5, so the values change in place, axis by axis.
FineValues Interpolate(const std::array<LineInterpolation, 3>& axes, const StencilValues& values)
{
  static_assert(StencilWidth == FineNodes, "values change in place");
  double slope = 0.0;
  const auto lineAt = [](const auto& from, int first, int stride)
  {
    Line line{};
    for (int i = 0; i < StencilWidth; ++i)
    {
      line[i] = from[first + i * stride];
    }
    return line;
  };
  for (int a = 0; a < 3; ++a)
  {
    slope = std::max(
      slope, axes[a].SlopeOf(lineAt(values, Middle - LevelSetLayers * Strides[a], Strides[a])));
  }
  FineValues found = values;
  for (int a = 0; a < 3; ++a)
  {
    const int b = Strides[(a + 1) % 3], c = Strides[(a + 2) % 3];
    for (int line = 0; line < StencilWidth * StencilWidth; ++line)
    {
      const int first = line % StencilWidth * b + line / StencilWidth * c;
      const FineLine fine = axes[a].Find(lineAt(found, first, Strides[a]), slope);
      for (int i = 0; i < FineNodes; ++i)
      {
        found[first + i * Strides[a]] = fine[i];
      }
    }
  }
  return found;
}

/// Returns the volumes of void and of the materials in the cell, of unit volume.
/// @param step  nodes of the finest parts across each part
std::vector<double> VolumesInParts(
  const std::vector<FineValues>& functions, LevelSetRule rule, int step)
{
  std::vector<double> volumes(functions.size() + 1, 0.0);
  std::vector<CornerValues> corners(functions.size());
  const int parts = FineParts / step;
  const double volume = 1.0 / (parts * parts * parts);
  for (int part = 0; part < parts * parts * parts; ++part)
  {
    const int first = step *
      (part % parts * Strides[0] + part / parts % parts * Strides[1] +
        part / (parts * parts) * Strides[2]);
    for (std::size_t m = 0; m < functions.size(); ++m)
    {
      for (int c = 0; c < 8; ++c)
      {
        corners[m][c] = functions[m][first +
          step * ((c & 1) * Strides[0] + (c >> 1 & 1) * Strides[1] + (c >> 2) * Strides[2])];
      }
    }
    AddVolumesInBox(corners, rule, volume, volumes);
  }
  return volumes;
}

/// Extrapolates a value that is unknown at centre i of a line; NaN if fewer than `least` are known.
double ExtrapolateTo(int i, const Line& centres, const Line& f, int least)
{
  std::array<int, 3> nearest{};
  int count = 0;
  for (int distance = 1; distance < StencilWidth; ++distance)
  {
    for (int j : { i - distance, i + distance })
    {
      if (j >= 0 && j < StencilWidth && count < 3 && !std::isnan(f[j]))
      {
        nearest[count++] = j;
      }
    }
  }
  double value = count < least ? Unknown : 0.0;
  for (int p = 0; p < count; ++p)
  {
    double weight = 1.0;
    for (int q = 0; q < count; ++q)
    {
      weight *= q == p
        ? 1.0
        : (centres[i] - centres[nearest[q]]) / (centres[nearest[p]] - centres[nearest[q]]);
    }
    value += weight * f[nearest[p]];
  }
  return value;
}

/// Extrapolates unknown values along one axis, in lines where `least` values are known.
void FillAlong(int axis, const StencilPlaces& places, int least, StencilValues& values)
{
  const int stride = Strides[axis], b = Strides[(axis + 1) % 3], c = Strides[(axis + 2) % 3];
  for (int line = 0; line < StencilWidth * StencilWidth; ++line)
  {
    const int first = line % StencilWidth * b + line / StencilWidth * c;
    Line f{};
    for (int i = 0; i < StencilWidth; ++i)
    {
      f[i] = values[first + i * stride];
    }
    for (int i = 0; i < StencilWidth; ++i)
    {
      if (std::isnan(f[i]))
      {
        values[first + i * stride] = ExtrapolateTo(i, places.Centres[axis], f, least);
      }
    }
  }
}

bool IsComplete(const StencilValues& values)
{
  return std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

/// Returns the lowest function at a cell of the stencil; the first one of equal values.
int LowestAt(const std::vector<StencilValues>& functions, int cell)
{
  int lowest = 0;
  for (std::size_t m = 1; m < functions.size(); ++m)
  {
    lowest = functions[m][cell] < functions[lowest][cell] ? static_cast<int>(m) : lowest;
  }
  return lowest;
}

/// Returns the material of a centre.
int MaterialAt(const std::vector<StencilValues>& functions, int cell, LevelSetRule rule)
{
  if (rule == LevelSetRule::Priority)
  {
    const auto found = std::find_if(functions.begin(), functions.end(),
      [cell](const StencilValues& values) { return values[cell] < 0.0; });
    return found == functions.end() ? 0 : static_cast<int>(found - functions.begin()) + 1;
  }
  const int lowest = LowestAt(functions, cell);
  return rule == LevelSetRule::Fill || functions[lowest][cell] < 0.0 ? lowest + 1 : 0;
}

} // namespace

StencilPlaces PlacesAround(const std::array<std::vector<double>, 3>& nodes, const Index3& cell)
{
  StencilPlaces places{};
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = nodes[a];
    const Index count = static_cast<Index>(x.size()) - 1;
    places.Lower[a] = x[cell[a]];
    places.Upper[a] = x[cell[a] + 1];
    const auto centre = [&](Index i) { return 0.5 * (x[i] + x[i + 1]); };
    for (int i = 0; i < StencilWidth; ++i)
    {
      const Index at = cell[a] + i - LevelSetLayers;
      const Index inside = std::clamp<Index>(at, 0, count - 1);
      places.Centres[a][i] =
        centre(inside) + static_cast<double>(at - inside) * (x[inside + 1] - x[inside]);
    }
  }
  return places;
}

void FillUnknown(const StencilPlaces& places, StencilValues& values)
{
  for (int least : { 2, 2, 1, 1 })
  {
    for (int a = 0; a < 3 && !IsComplete(values); ++a)
    {
      FillAlong(a, places, least, values);
    }
  }
}

int FindOnlyMaterial(const std::vector<StencilValues>& functions, LevelSetRule rule)
{
  const int material = MaterialAt(functions, Middle, rule);
  for (int k = -1; k <= 1; ++k)
  {
    for (int j = -1; j <= 1; ++j)
    {
      for (int i = -1; i <= 1; ++i)
      {
        const int cell = Middle + i * Strides[0] + j * Strides[1] + k * Strides[2];
        if (MaterialAt(functions, cell, rule) != material)
        {
          return -1;
        }
      }
    }
  }
  return material;
}

std::vector<double> FractionsOfFunctions(
  const StencilPlaces& places, const std::vector<StencilValues>& functions, LevelSetRule rule)
{
  const auto axis = [&places](int a)
  { return LineInterpolation(places.Centres[a], places.Lower[a], places.Upper[a]); };
  const std::array<LineInterpolation, 3> axes{ { axis(0), axis(1), axis(2) } };
  std::vector<FineValues> fine;
  for (const StencilValues& values : functions)
  {
    fine.push_back(Interpolate(axes, values));
  }
  const std::vector<double> coarse = VolumesInParts(fine, rule, 2);
  std::vector<double> volumes = VolumesInParts(fine, rule, 1);
  double sum = 0.0;
  for (std::size_t m = 0; m < volumes.size(); ++m)
  {
    volumes[m] = std::max(0.0, volumes[m] + (volumes[m] - coarse[m]) / 3.0);
    sum += volumes[m];
  }
  for (double& volume : volumes)
  {
    volume /= sum;
    volume = volume < NegligibleShare ? 0.0 : (volume > 1.0 - NegligibleShare ? 1.0 : volume);
  }
  volumes.erase(volumes.begin());
  return volumes;
}

} // namespace vfm
