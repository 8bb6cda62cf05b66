#include "GluedChecks.h"

#include "Base/Vector3.h"
#include "RandomDraw.h"

#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

/// Returns the positions of a point moved by periods along some axes, bit a of `axes`.
Vector3 Upper(const CartesianGrid& grid, const Vector3& x, int axes)
{
  Vector3 moved = x;
  for (int a = 0; a < 3; ++a)
  {
    moved[a] = axes >> a & 1 ? x[a] + grid.PeriodLength(a) : x[a];
  }
  return moved;
}

int PeriodicAxes(const CartesianGrid& grid)
{
  int axes = 0;
  for (int a = 0; a < 3; ++a)
  {
    axes |= (grid.Period(a) > 0) << a;
  }
  return axes;
}

Index Root(const std::vector<Index>& parent, Index p)
{
  while (parent[p] != p)
  {
    p = parent[p];
  }
  return p;
}

/// Returns the lowest translate of each point.
std::vector<Index> FindTranslates(const CartesianGrid& grid, const Mesh& mesh)
{
  const Index count = static_cast<Index>(mesh.PointIds.size());
  const int periodic = PeriodicAxes(grid);
  std::vector<Index> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  // Free sides can have only the two copies across an edge of the domain: p + axes = q + others.
  for (int others = 0; others < 8; ++others)
  {
    std::map<Vector3, Index> places;
    for (Index q = 0; (others & ~periodic) == 0 && q < count; ++q)
    {
      places[Upper(grid, mesh.PointAt(q), others)] = q;
    }
    for (int axes = others + 1; axes < 8; ++axes)
    {
      for (Index p = 0; (axes & others) == 0 && (axes & ~periodic) == 0 && p < count; ++p)
      {
        const auto at = places.find(Upper(grid, mesh.PointAt(p), axes));
        if (at != places.end())
        {
          const Index a = Root(parent, p), b = Root(parent, at->second);
          parent[std::max(a, b)] = std::min(a, b);
        }
      }
    }
  }
  for (Index p = 0; p < count; ++p)
  {
    parent[p] = Root(parent, p);
  }
  return parent;
}

} // namespace

CartesianGrid MakePeriodicGrid(
  const Index3& n, const std::array<bool, 3>& isPeriodic, Seam seam, Index layers)
{
  const CartesianGrid unit = MakeUnitGrid(n[0], n[1], n[2]);
  return CartesianGrid::Covering(
    unit.Coordinates(), unit.Global(), isPeriodic, seam, GhostLayers, HexLayers, layers);
}

FractionField MakePeriodicLabels(
  const CartesianGrid& grid, int materials, const std::function<int(const Index3&)>& label)
{
  return MakeLabels(grid, materials,
    [&](const Index3& cell)
    {
      Index3 own = grid.Canonical(cell);
      for (int a = 0; a < 3; ++a)
      {
        own[a] -= grid.Domain().Lower[a];
      }
      return label(own);
    });
}

FractionField SamplePeriodic(const CartesianGrid& grid, int materials, int samples,
  const std::function<int(const Vector3&)>& label)
{
  const IndexBox& domain = grid.Domain();
  const Vector3 corner = grid.NodePoint(domain.Lower);
  const double part = 1.0 / (samples * samples * samples);
  std::map<Index3, std::vector<FractionField::Part>> cells;
  ForCells(domain,
    [&](const Index3& cell)
    {
      std::map<int, int> counts;
      ForCells({ {}, { { samples, samples, samples } } },
        [&](const Index3& sample)
        {
          Vector3 x = grid.NodePoint(cell) - corner;
          for (int a = 0; a < 3; ++a)
          {
            x[a] += grid.Width(a, cell[a]) * (static_cast<double>(sample[a]) + 0.5) / samples;
          }
          ++counts[label(x)];
        });
      for (const auto& [own, count] : counts)
      {
        if (own > 0)
        {
          cells[cell].push_back({ own, count * part });
        }
      }
    });
  FractionField field(grid, materials);
  ForCells(grid.Local(),
    [&](const Index3& cell) { field.SetParts(grid.Linear(cell), cells[grid.Canonical(cell)]); });
  return field;
}

FractionField MakePeriodicPolycrystal(const CartesianGrid& grid, unsigned seed, int grains)
{
  const auto n = static_cast<double>(grid.Domain().Size(0));
  RandomDraw draw(seed);
  std::vector<Vector3> seeds;
  for (int g = 0; g < grains; ++g)
  {
    seeds.push_back(draw.Vector(0.0, n));
  }
  return SamplePeriodic(grid, grains, 4,
    [&](const Vector3& x)
    {
      int nearest = 0;
      double lowest = std::numeric_limits<double>::max();
      for (int g = 0; g < grains; ++g)
      {
        double distance = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          const double d = std::fabs(x[a] - seeds[g][a]);
          distance += std::min(d, n - d) * std::min(d, n - d);
        }
        nearest = distance < lowest ? g + 1 : nearest;
        lowest = std::min(lowest, distance);
      }
      return nearest;
    });
}

FractionField MakeRandomPeriodic(
  const CartesianGrid& grid, int materials, int lowest, unsigned seed)
{
  std::mt19937 random(seed);
  std::map<Index3, int> labels;
  return MakePeriodicLabels(grid, materials,
    [&](const Index3& cell)
    {
      const auto at = labels.emplace(cell, 0);
      if (at.second)
      {
        at.first->second =
          lowest + static_cast<int>(random() % static_cast<unsigned>(materials + 1 - lowest));
      }
      return at.first->second;
    });
}

Mesh Glue(const CartesianGrid& grid, const Mesh& mesh)
{
  const std::vector<Index> lowest = FindTranslates(grid, mesh);
  std::vector<Index> number(lowest.size(), -1);
  Mesh glued;
  glued.Corners = mesh.Corners;
  std::vector<Index> kept;
  for (std::size_t p = 0; p < lowest.size(); ++p)
  {
    if (lowest[p] == static_cast<Index>(p))
    {
      number[p] = static_cast<Index>(kept.size());
      kept.push_back(static_cast<Index>(p));
    }
  }
  glued.ResizePoints(static_cast<Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k)
  {
    glued.SetPoint(static_cast<Index>(k), mesh.PointAt(kept[k]), mesh.PointIds[kept[k]]);
  }
  glued.ResizeElements(static_cast<Index>(mesh.ElementIds.size()));
  std::copy_n(mesh.ElementIds.data(), mesh.ElementIds.size(), glued.ElementIds.data());
  std::copy_n(mesh.Material.data(), mesh.Material.size(), glued.Material.data());
  glued.Fragment = Buffer<int>(mesh.Fragment.size());
  std::copy_n(mesh.Fragment.data(), mesh.Fragment.size(), glued.Fragment.data());
  for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
  {
    glued.Elements[at] = number[lowest[mesh.Elements[at]]];
  }
  return glued;
}

std::string FindGluedProblem(
  const CartesianGrid& grid, const Mesh& mesh, bool meshVoid, Index fragments)
{
  const Mesh glued = Glue(grid, mesh);
  const std::string topology = FindTopologyProblem(glued) + FindFragmentProblem(glued);
  const std::set<int> numbers(glued.Fragment.data(), glued.Fragment.data() + glued.Fragment.size());
  const bool isTorus = PeriodicAxes(grid) == 7;
  if (static_cast<Index>(numbers.size()) != fragments)
  {
    return topology + std::to_string(numbers.size()) + " fragments instead of " +
      std::to_string(fragments);
  }
  const Index free = isTorus && meshVoid ? CountFreeFaces(glued) : 0;
  return topology + (free > 0 ? std::to_string(free) + " faces are on one element only" : "");
}

} // namespace testing
} // namespace vfm
