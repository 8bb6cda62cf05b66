#include "Parts/MeshInterface.h"

#include <set>

namespace vfm
{
namespace testing
{
namespace
{

constexpr int SamplesOfFacet = 4; // along each direction of a facet

} // namespace

SharpDistances Summarise(std::vector<double> values)
{
  SharpDistances d;
  if (values.empty())
  {
    return d;
  }
  double squares = 0.0;
  for (double value : values)
  {
    squares += value * value;
  }
  std::sort(values.begin(), values.end());
  d.Largest = values.back();
  d.RootMeanSquare = std::sqrt(squares / values.size());
  d.Percentile99 = values[static_cast<std::size_t>(0.99 * (values.size() - 1))];
  return d;
}

MeshInterface::MeshInterface(const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  std::set<Index> points;
  for (std::size_t f = 0; f < mesh.Surfaces.DomainSide.size(); ++f)
  {
    if (mesh.Surfaces.DomainSide[f] >= 0)
    {
      continue;
    }
    std::array<Vector3, 4> x;
    for (int c = 0; c < corners; ++c)
    {
      points.insert(mesh.Surfaces.Points[corners * f + c]);
      x[c] = mesh.PointAt(mesh.Surfaces.Points[corners * f + c]);
    }
    for (int i = 0; i < SamplesOfFacet * SamplesOfFacet; ++i)
    {
      const double u = (i % SamplesOfFacet + .5) / SamplesOfFacet;
      const double v = (i / SamplesOfFacet + .5) / SamplesOfFacet;
      const double r = std::sqrt(u); // distributes samples evenly over a triangle
      this->Samples.push_back(corners == 4
          ? (1 - u) * (1 - v) * x[0] + u * (1 - v) * x[1] + u * v * x[2] + (1 - u) * v * x[3]
          : (1 - r) * x[0] + r * (1 - v) * x[1] + r * v * x[2]);
    }
    const Vector3 centre = .25 * (x[0] + x[1] + x[2] + x[3]);
    for (int c = 0; corners == 4 && c < 4; ++c)
    {
      this->Triangles.push_back({ { x[c], x[(c + 1) % 4], centre } });
    }
    if (corners == 3)
    {
      this->Triangles.push_back({ { x[0], x[1], x[2] } });
    }
    this->Facets.resize(this->Triangles.size(), static_cast<Index>(f));
  }
  for (Index p : points)
  {
    this->Nodes.push_back(mesh.PointAt(p));
  }
}

} // namespace testing
} // namespace vfm
