#include "SharpFeatures/FeatureData.h"

#include "Base/PortableMath.h"

#include <algorithm>
#include <bitset>
#include <cstdint>

namespace vfm
{
namespace
{

// Least sum of the fractions of both labels in a cell that is used.
constexpr double WholePair = 0.99;
// Least share of the weights that cells of the pair must have.
constexpr double SmallestShare = 0.3;
constexpr Index SeedRadius = 2; // distance of nodes with crossings that define planes
constexpr int SeedRings = 3;    // rings of faces that connect them to the node
constexpr std::size_t MaximumPlanes = 3;
constexpr int FewestSupporters = 5;
constexpr double LeastShare = 0.35; // least share of crossings on planes, around an edge
// 15 degrees, between normals of crossings on one plane
constexpr double SupportCosine = 0.965926;
// Distance between the plane of one crossing and another crossing.
constexpr double SupportDistance = 0.25;
constexpr double PlaneCosine = 0.939693; // 20 degrees, between two planes

/// Centres and half widths of the cells of a stencil along one axis, in the local frame.
struct AxisCells
{
  std::array<double, 6> Centre, Half;
};

AxisCells CellsAlong(
  const CartesianGrid& grid, int axis, const NodeFrame& frame, Index radius, double scale)
{
  AxisCells cells{};
  const std::vector<double>& x = grid.Coordinates(axis);
  const Index last = static_cast<Index>(x.size()) - 1;
  for (Index c = 0; c < 2 * radius; ++c)
  {
    const Index i = frame.Position[axis] - radius + c;
    if (i >= 0 && i < last)
    {
      const double low = (x[i] - x[0]) / scale, high = (x[i + 1] - x[0]) / scale;
      cells.Centre[c] = (0.5 * (low + high) - frame.Origin[axis]) / frame.Widths[axis];
      cells.Half[c] = 0.5 * (high - low) / frame.Widths[axis];
    }
  }
  return cells;
}

double WeightAt(double squaredRadius, const Stencil& stencil)
{
  return Exp(-squaredRadius / (2.0 * stencil.Sigma * stencil.Sigma));
}

/// Finds one plane after another among crossings.
class PlaneFinder
{
public:
  explicit PlaneFinder(const std::vector<LocalCrossing>& crossings) :
    Crossings(crossings),
    Words((crossings.size() + 63) / 64),
    Supporters(crossings.size() * Words, 0),
    IsFree(Words, 0)
  {
    for (std::size_t i = 0; i < crossings.size(); ++i)
    {
      this->IsFree[i / 64] |= std::uint64_t{ 1 } << i % 64;
      this->SetSupporters(i);
    }
  }

  bool FindNext()
  {
    int most = FewestSupporters - 1;
    std::size_t best = this->Crossings.size();
    for (std::size_t i = 0; i < this->Crossings.size(); ++i)
    {
      const int supporters = this->IsNew(i) ? this->CountSupporters(i) : 0;
      if (supporters > most)
      {
        most = supporters;
        best = i;
      }
    }
    if (best == this->Crossings.size())
    {
      return false;
    }
    this->TakePlane(best);
    return true;
  }

  /// Returns the number of crossings that are not yet on a plane.
  int CountFree() const
  {
    int count = 0;
    for (std::uint64_t word : this->IsFree)
    {
      count += CountBits(word);
    }
    return count;
  }

  std::vector<LocalQuadric> Planes;

private:
  static int CountBits(std::uint64_t word)
  {
    return static_cast<int>(std::bitset<64>(word).count());
  }
  static bool Bit(const std::uint64_t* words, std::size_t i) { return words[i / 64] >> i % 64 & 1; }

  const std::uint64_t* SupportersOf(std::size_t i) const
  {
    return &this->Supporters[i * this->Words];
  }
  void SetSupporters(std::size_t i)
  {
    const LocalCrossing& a = this->Crossings[i];
    const double offset = Dot(a.Normal, a.Point);
    for (std::size_t j = 0; j < this->Crossings.size(); ++j)
    {
      const LocalCrossing& b = this->Crossings[j];
      const std::uint64_t isNear = std::fabs(Dot(a.Normal, b.Point) - offset) < SupportDistance;
      const std::uint64_t supports = (Dot(a.Normal, b.Normal) > SupportCosine) & isNear;
      this->Supporters[i * this->Words + j / 64] |= supports << j % 64;
    }
  }
  bool IsNew(std::size_t i) const
  {
    return Bit(this->IsFree.data(), i) &&
      std::none_of(this->Planes.begin(), this->Planes.end(),
        [&](const LocalQuadric& plane)
        { return Dot(plane.N, this->Crossings[i].Normal) >= PlaneCosine; });
  }
  int CountSupporters(std::size_t i) const
  {
    int count = 0;
    for (std::size_t w = 0; w < this->Words; ++w)
    {
      count += CountBits(this->SupportersOf(i)[w] & this->IsFree[w]);
    }
    return count;
  }
  void TakePlane(std::size_t i)
  {
    Vector3 point{}, normal{};
    int count = 0;
    for (std::size_t j = 0; j < this->Crossings.size(); ++j)
    {
      if (Bit(this->SupportersOf(i), j) && Bit(this->IsFree.data(), j))
      {
        point = point + this->Crossings[j].Point;
        normal = normal + this->Crossings[j].Normal;
        ++count;
        this->IsFree[j / 64] &= ~(std::uint64_t{ 1 } << j % 64);
      }
    }
    this->Planes.push_back(MakeLocalPlane((1.0 / count) * point, Unit(normal)));
  }

  const std::vector<LocalCrossing>& Crossings;
  std::size_t Words; ///< number of words of a set of crossings, one bit per crossing
  std::vector<std::uint64_t> Supporters, IsFree;
};

} // namespace

NodeFrame FrameOf(const Interface& interface, Index node)
{
  const Index at = interface.Nodes()[node];
  return { interface.Grid().Position(at), interface.NodePoint(at), interface.NodeWidths(at) };
}

bool GatherCells(const Interface& interface, const FractionField& fractions, const NodeFrame& frame,
  const std::array<int, 2>& labels, const Stencil& stencil, std::vector<SampleCell>& cells)
{
  cells.clear();
  const CartesianGrid& grid = interface.Grid();
  std::array<AxisCells, 3> along;
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    along[a] = CellsAlong(grid, a, frame, stencil.Radius, interface.Scale());
    box.Lower[a] = frame.Position[a] - stencil.Radius;
    box.Upper[a] = frame.Position[a] + stencil.Radius;
  }
  double all = 0.0, kept = 0.0;
  ForCells(Intersect(box, grid.Local()),
    [&](const Index3& p)
    {
      SampleCell cell;
      for (int a = 0; a < 3; ++a)
      {
        cell.Centre[a] = along[a].Centre[p[a] - box.Lower[a]];
        cell.Half[a] = along[a].Half[p[a] - box.Lower[a]];
      }
      const double square = Dot(cell.Centre, cell.Centre);
      if (square > stencil.Reach * stencil.Reach)
      {
        return;
      }
      const Index at = grid.Linear(p);
      cell.Weight = WeightAt(square, stencil);
      all += cell.Weight;
      const double first = fractions.Fraction(at, labels[0]);
      const double second = fractions.Fraction(at, labels[1]);
      if (first + second < WholePair)
      {
        return;
      }
      cell.Fraction = second / (first + second);
      kept += cell.Weight;
      cells.push_back(cell);
    });
  return kept > SmallestShare * all;
}

std::vector<SampleCell> Narrowed(const std::vector<SampleCell>& cells, const Stencil& stencil)
{
  std::vector<SampleCell> near;
  for (SampleCell cell : cells)
  {
    const double square = Dot(cell.Centre, cell.Centre);
    if (square <= stencil.Reach * stencil.Reach)
    {
      cell.Weight = WeightAt(square, stencil);
      near.push_back(cell);
    }
  }
  return near;
}

void GatherCrossings(const Interface& interface, const NodeFrame& frame, Index node,
  const std::array<int, 2>& labels, FaceWalk& walk, std::vector<LocalCrossing>& crossings)
{
  const CartesianGrid& grid = interface.Grid();
  const auto isNear = [&](Index other)
  {
    const Index3 p = grid.Position(interface.Nodes()[other]);
    return std::abs(p[0] - frame.Position[0]) <= SeedRadius &&
      std::abs(p[1] - frame.Position[1]) <= SeedRadius &&
      std::abs(p[2] - frame.Position[2]) <= SeedRadius;
  };
  crossings.clear();
  for (int face : walk.Find(node, labels[0], labels[1], SeedRings, isNear))
  {
    const Crossing& crossing = interface.Crossings()[face];
    crossings.push_back({ Divided(crossing.Point - frame.Origin, frame.Widths),
      Unit(Scaled(crossing.Normal, frame.Widths)) });
  }
}

std::vector<LocalQuadric> FindPlanes(const std::vector<LocalCrossing>& crossings)
{
  PlaneFinder finder(crossings);
  while (finder.Planes.size() < MaximumPlanes && finder.FindNext())
  {
  }
  const double share = 1.0 - static_cast<double>(finder.CountFree()) / crossings.size();
  return share >= LeastShare ? finder.Planes : std::vector<LocalQuadric>();
}

} // namespace vfm
