/**
 * NodeCoordinates: node coordinates of a grid along one axis, from values with
 * rounding differences.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <algorithm>
#include <vector>

namespace vfm
{

/// Names of the axes in messages.
constexpr const char* AxisNames[3] = { "x", "y", "z" };

/// Node coordinates closer than this fraction of the smallest cell width are merged.
constexpr double MatchTolerance = 1e-3;

/// Returns evenly spaced nodes first .. last; node 0 is at start.
inline std::vector<double> EvenNodes(double start, double spacing, int first, int last)
{
  std::vector<double> x;
  for (int i = first; i <= last; ++i)
  {
    x.push_back(start + i * spacing);
  }
  return x;
}

/// Returns the nodes of cells of an image along its axes. Node 0 is at the origin, or half a
/// spacing before it if points are used as cells.
inline std::array<std::vector<double>, 3> EvenCoordinates(
  const Vector3& origin, const Vector3& spacing, const IndexBox& cells, bool arePoints = false)
{
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    coordinates[a] = EvenNodes(arePoints ? origin[a] - 0.5 * spacing[a] : origin[a], spacing[a],
      static_cast<int>(cells.Lower[a]), static_cast<int>(cells.Upper[a]));
  }
  return coordinates;
}

/// Merges close values to the smallest of them. sorted: increasing; width: smallest cell width.
inline std::vector<double> MergeClose(const std::vector<double>& sorted, double width)
{
  std::vector<double> merged;
  for (double x : sorted)
  {
    if (merged.empty() || x - merged.back() > width * MatchTolerance)
    {
      merged.push_back(x);
    }
  }
  return merged;
}

/// Returns the index of the node that a value was merged into.
inline Index FindNode(const std::vector<double>& merged, double value)
{
  return std::upper_bound(merged.begin(), merged.end(), value) - merged.begin() - 1;
}

} // namespace vfm
