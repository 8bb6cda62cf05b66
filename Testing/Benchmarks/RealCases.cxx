#include "RealCases.h"

#include "Base/Partition.h"
#include "Base/Vector3.h"
#include "Labels/SmoothLabels.h"
#include "RandomDraw.h"
#include "ReadLabelImage.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace testing
{
namespace
{

constexpr double SmallestDrop = 0.8, LargestDrop = 2.2; // radii
constexpr int TriesPerDrop = 200;
constexpr int DropSamples = 6; // points per axis and cell
constexpr double PoreShare = 0.6;
constexpr int PorePasses = 13; // of a mean of 3 x 3 x 3 cells
constexpr char Images[] = "/usr/share/mricron/templates/";

struct Drop
{
  Vector3 Centre;
  double Radius;
};

/// Drops in bins of a box, to find those near a place.
class Drops
{
public:
  explicit Drops(int n) : Bins(n / Width + 1), Content(Bins * Bins * Bins) {}

  /// Adds a drop unless it touches another one.
  bool Add(const Drop& drop)
  {
    if (this->Touches(drop))
    {
      return false;
    }
    this->Content[this->BinOf(drop.Centre, { { 0, 0, 0 } })].push_back(drop);
    ++this->Count;
    return true;
  }
  int Size() const { return this->Count; }
  template <class Body>
  void ForAll(const Body& body) const
  {
    for (const std::vector<Drop>& bin : this->Content)
    {
      std::for_each(bin.begin(), bin.end(), body);
    }
  }

private:
  static constexpr int Width = 5; // cells, above the largest distance of touching drops

  Index BinOf(const Vector3& x, const Index3& shift) const
  {
    Index bin = 0;
    for (int a = 2; a >= 0; --a)
    {
      const Index at = static_cast<Index>(x[a] / Width) + shift[a];
      if (at < 0 || at >= this->Bins)
      {
        return -1;
      }
      bin = bin * this->Bins + at;
    }
    return bin;
  }

  bool Touches(const Drop& drop) const
  {
    for (int s = 0; s < 27; ++s)
    {
      const Index bin = this->BinOf(drop.Centre, { { s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1 } });
      const auto touches = [&](const Drop& other)
      { return Norm(other.Centre - drop.Centre) < other.Radius + drop.Radius; };
      if (bin >= 0 && std::any_of(this->Content[bin].begin(), this->Content[bin].end(), touches))
      {
        return true;
      }
    }
    return false;
  }

  const Index Bins; // per axis
  std::vector<std::vector<Drop>> Content;
  int Count = 0;
};

Drops ScatterDrops(int n, int drops, unsigned seed)
{
  RandomDraw draw(seed);
  Drops all(n);
  for (int t = 0; t < TriesPerDrop * drops && all.Size() < drops; ++t)
  {
    const double radius = draw.Between(SmallestDrop, LargestDrop);
    all.Add({ draw.Vector(radius, n - radius), radius });
  }
  return all;
}

/// Returns the share of a cell in a drop.
double FindShare(const Drop& drop, const Index3& cell)
{
  int inside = 0;
  for (int s = 0; s < DropSamples * DropSamples * DropSamples; ++s)
  {
    const int at[3] = { s % DropSamples, s / DropSamples % DropSamples,
      s / DropSamples / DropSamples };
    double square = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const double x = static_cast<double>(cell[a]) + (at[a] + 0.5) / DropSamples;
      square += (x - drop.Centre[a]) * (x - drop.Centre[a]);
    }
    inside += square < drop.Radius * drop.Radius;
  }
  return inside / std::pow(DropSamples, 3.0);
}

/// Averages values of n^3 cells over 3 cells along an axis.
void AverageAlong(Index n, int axis, std::vector<double>& values)
{
  const std::vector<double> old = values;
  const Index step = axis == 0 ? 1 : (axis == 1 ? n : n * n);
  for (Index c = 0; c < n * n * n; ++c)
  {
    const Index at = c / step % n;
    values[c] = (old[c - (at > 0 ? step : 0)] + old[c] + old[c + (at + 1 < n ? step : 0)]) / 3.0;
  }
}

} // namespace

MeshCase WithoutDistance(const CartesianGrid& grid, FractionField fractions)
{
  return { "", grid, std::move(fractions), {}, 0.0, 0.0, 0.0, 0.0, 0.0 };
}

MeshCase MakeSmoothedCase(const CartesianGrid& grid, FractionField labels, int passes)
{
  Runtime runtime;
  if (passes > 0)
  {
    SmoothLabels(grid, passes, Partition(grid, runtime.Group()), runtime, labels);
  }
  return WithoutDistance(grid, std::move(labels));
}

MeshCase MakeSprayCase(int n, int drops, unsigned seed)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  std::vector<double> shares(grid.Owned().NumberOfCells(), 0.0);
  ScatterDrops(n, drops, seed)
    .ForAll(
      [&](const Drop& drop)
      {
        IndexBox box;
        for (int a = 0; a < 3; ++a)
        {
          box.Lower[a] = static_cast<Index>(drop.Centre[a] - drop.Radius);
          box.Upper[a] = std::min<Index>(n, static_cast<Index>(drop.Centre[a] + drop.Radius) + 1);
        }
        ForCells(
          box, [&](const Index3& p) { shares[IndexInBox(grid.Owned(), p)] += FindShare(drop, p); });
      });
  FractionField field(grid, 1);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const double share = std::min(1.0, shares[IndexInBox(grid.Owned(), p)]);
      if (share > 0.0)
      {
        field.SetParts(grid.Linear(p), { { 1, share } });
      }
    });
  return WithoutDistance(grid, std::move(field));
}

MeshCase MakePoresCase(int n, int passes, unsigned seed)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  RandomDraw draw(seed);
  std::vector<double> noise(grid.Owned().NumberOfCells());
  std::generate(noise.begin(), noise.end(), [&] { return draw.Between(0.0, 1.0); });
  for (int p = 0; p < 3 * PorePasses; ++p)
  {
    AverageAlong(n, p % 3, noise);
  }
  std::vector<double> sorted = noise;
  std::sort(sorted.begin(), sorted.end());
  const double level =
    sorted[static_cast<std::size_t>(PoreShare * static_cast<double>(sorted.size()))];
  return MakeSmoothedCase(grid,
    MakeLabels(
      grid, 1, [&](const Index3& p) { return noise[IndexInBox(grid.Owned(), p)] < level; }),
    passes);
}

MeshCase MakeImageCase(const std::string& name, int passes, Index cells)
{
  LabelImage image = ReadLabelImage(Images + name + ".nii.gz", cells);
  return MakeSmoothedCase(image.Grid, std::move(image.Labels), passes);
}

} // namespace testing
} // namespace vfm
