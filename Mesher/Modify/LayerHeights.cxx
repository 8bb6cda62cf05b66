#include "Modify/LayerHeights.h"

#include "Base/HexNumbering.h"
#include "Elements/Hex/HexCoefficients.h"
#include "Ranks/MergeByKey.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr int Steps = 4;          // in which edges approach the division without a thickness
constexpr double Parts = 1 << 30; // components of normals are summed as integers of this unit

/// Returns the sum 1 + growth + .. of this many terms.
double SumOfPowers(double growth, int terms)
{
  double sum = 0.0;
  for (int t = 0; t < terms; ++t)
  {
    sum = 1.0 + growth * sum;
  }
  return sum;
}

/// Returns the growth with which layers of first thickness 1 have a height; 1 if they need more.
/// @param largest growth that needs more than the height
double FitGrowth(int layers, double largest, double height)
{
  double low = 1.0, high = largest;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (low + high);
    (SumOfPowers(middle, layers) < height ? low : high) = middle;
  }
  return low;
}

/// Returns the unit normal of the base of a column, into the column, as integers.
Index3 NormalOf(const Mesh& mesh, const LayerColumns& columns, const LayerColumns::Column& column)
{
  std::array<Vector3, 4> x;
  for (int c = 0; c < 4; ++c)
  {
    x[c] = mesh.PointAt(columns.Edges[column.Edges[c]].Foot);
  }
  const Vector3 inward = Cross(x[3] - x[1], x[2] - x[0]);
  const double length = Norm(inward);
  Index3 normal{};
  for (int a = 0; a < 3; ++a)
  {
    normal[a] = length > 0.0 ? std::llround(Parts * inward[a] / length) : 0;
  }
  return normal;
}

/// Collective. Returns the height of each edge along the mean normal of its columns, in units of
/// the first thickness; 0 if the edge is not above the surface.
std::vector<double> FindNormalHeights(const Mesh& mesh, const LayerColumns& columns,
  const std::vector<std::array<Index, 2>>& keys, double thickness, Ranks& ranks)
{
  std::vector<Index3> normals(columns.Edges.size(), Index3{});
  const auto add = [](Index3 a, const Index3& b)
  {
    for (int i = 0; i < 3; ++i)
    {
      a[i] += b[i];
    }
    return a;
  };
  for (const LayerColumns::Column& column : columns.Columns)
  {
    for (Index edge : column.Edges)
    {
      normals[edge] = add(normals[edge], NormalOf(mesh, columns, column));
    }
  }
  normals = MergeByKey(keys, normals, add, ranks);
  std::vector<double> heights(normals.size());
  for (std::size_t e = 0; e < heights.size(); ++e)
  {
    const Vector3 normal{ { static_cast<double>(normals[e][0]), static_cast<double>(normals[e][1]),
      static_cast<double>(normals[e][2]) } };
    const LayerColumns::Edge& edge = columns.Edges[e];
    const double along = Dot(mesh.PointAt(edge.Top) - mesh.PointAt(edge.Foot), normal);
    heights[e] = along > 0.0 ? along / (Norm(normal) * thickness) : 0.0;
  }
  return heights;
}

/// Returns whether all layers of a column have positive coefficients.
bool ArePositive(const Mesh& mesh, const LayerColumns& columns, const LayerColumns::Column& column,
  const std::vector<std::vector<double>>& ends)
{
  const std::size_t layers = ends[column.Edges[0]].size() - 1;
  for (std::size_t layer = 0; layer < layers; ++layer)
  {
    std::array<Vector3, 8> corners;
    for (int c = 0; c < 4; ++c)
    {
      const LayerColumns::Edge& edge = columns.Edges[column.Edges[c]];
      const Vector3 foot = mesh.PointAt(edge.Foot), along = mesh.PointAt(edge.Top) - foot;
      const int corner = FaceCorners[column.Side][c];
      const std::vector<double>& places = ends[column.Edges[c]];
      corners[corner] = foot + places[layer] * along;
      corners[OppositeCorner(corner, column.Side)] = foot + places[layer + 1] * along;
    }
    if (!(SmallestCoefficient(corners) > 0.0))
    {
      return false;
    }
  }
  return true;
}

/// Moves the ends of an edge to a mean of those with and without a thickness.
std::vector<double> Blend(
  const std::vector<double>& thick, const std::vector<double>& even, int step)
{
  std::vector<double> ends(even);
  const double weight = 1.0 - static_cast<double>(step) / Steps;
  for (std::size_t k = 0; k < ends.size() && step < Steps; ++k)
  {
    ends[k] = even[k] + weight * (thick[k] - even[k]);
  }
  return ends;
}

} // namespace

std::vector<double> FindLayerEnds(const LayerSpacing& spacing, double height)
{
  const int layers = spacing.Layers;
  double growth = spacing.Growth;
  const bool isLow = height > 0.0 && height < SumOfPowers(growth, layers);
  if (isLow)
  {
    growth = FitGrowth(layers, growth, height);
  }
  const double all = SumOfPowers(growth, layers);
  const double total = isLow ? all : std::max(all, height);
  std::vector<double> ends;
  for (int layer = 0; layer < layers; ++layer)
  {
    ends.push_back(SumOfPowers(growth, layer) / total);
  }
  ends.push_back(1.0);
  return ends;
}

std::vector<std::vector<double>> FindLayerHeights(
  const Mesh& mesh, const LayerColumns& columns, const LayerSpacing& spacing, Runtime& runtime)
{
  const std::vector<double> even = FindLayerEnds(spacing, 0.0);
  std::vector<std::vector<double>> ends(columns.Edges.size(), even);
  if (spacing.Thickness <= 0.0)
  {
    return ends;
  }
  const std::vector<std::array<Index, 2>> keys = columns.KeysOfEdges(mesh);
  const std::vector<double> heights =
    FindNormalHeights(mesh, columns, keys, spacing.Thickness, runtime.Group());
  std::vector<char> steps(columns.Edges.size(), 0);
  for (bool changes = true; changes;)
  {
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      ends[e] = Blend(FindLayerEnds(spacing, heights[e]), even, steps[e]);
    }
    std::vector<char> next(steps);
    for (const LayerColumns::Column& column : columns.Columns)
    {
      const bool isPositive = ArePositive(mesh, columns, column, ends);
      for (Index edge : column.Edges)
      {
        const int after = isPositive ? 0 : steps[edge] + 1;
        next[edge] = static_cast<char>(std::min(Steps, std::max<int>(next[edge], after)));
      }
    }
    next = MergeByKey(
      keys, next, [](char a, char b) { return std::max(a, b); }, runtime.Group());
    changes = runtime.Group().Any(next != steps);
    steps = std::move(next);
  }
  return ends;
}

} // namespace vfm
