/**
 * MeshInterface: interface of a mesh as points and triangles, and statistics of distances.
 */
#pragma once

#include "Elements/Mesh.h"
#include "NearestTriangle.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace testing
{

/// Facets of a mesh that do not lie on a side of the domain.
struct MeshInterface
{
  explicit MeshInterface(const Mesh& mesh);

  std::vector<Vector3> Nodes;
  std::vector<Vector3> Samples;                    ///< 16 points of each bilinear facet
  std::vector<NearestTriangle::Corners> Triangles; ///< four around the centre of quads
  std::vector<Index> Facets;                       ///< facet of each triangle
};

/// Distances in cells.
struct SharpDistances
{
  double Largest = 0.0, RootMeanSquare = 0.0, Percentile99 = 0.0;
};
SharpDistances Summarise(std::vector<double> values);

/// Summarises distance(point) of all points.
template <class Distance>
SharpDistances Measure(const std::vector<Vector3>& points, const Distance& distance)
{
  std::vector<double> values;
  values.reserve(points.size());
  for (const Vector3& x : points)
  {
    values.push_back(distance(x));
  }
  return Summarise(std::move(values));
}

} // namespace testing
} // namespace vfm
