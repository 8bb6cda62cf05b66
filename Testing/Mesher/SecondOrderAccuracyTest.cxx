/// Distance of second-order meshes of a ball from the true sphere, at quadrature points.
#include "CurvedNodes.h"
#include "MeshCases.h"
#include "Modify/AddMidNodes.h"
#include "Phases/MeshOfCells.h"
#include "Shapes/ShapesFractions.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Gauss[3] = { 0.1127016653792583, 0.5, 0.8872983346207417 };

struct Ball
{
  Vector3 Centre;
  double Radius;
};

/// Root mean square distances from the sphere, in cells.
struct Distances2
{
  double Curved, Straight;
};

/// Returns the point of a face with mid nodes: corners, then edges.
/// @param isCurved  false: mid nodes count as middles
Vector3 PointOfFace(const std::vector<Vector3>& x, double u, double v, bool isCurved)
{
  const std::size_t corners = x.size() / 2;
  std::vector<double> shape;
  if (corners == 4)
  {
    shape = { (1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v };
  }
  else
  {
    v *= 1 - u;
    shape = { 1 - u - v, u, v };
  }
  std::vector<double> bubbles;
  for (std::size_t c = 0; c < corners; ++c)
  {
    const bool alongU = c % 2 == 0;
    const double t = alongU ? u : v;
    bubbles.push_back(corners == 4 ? 4 * t * (1 - t) * (shape[c] + shape[(c + 1) % 4])
                                   : 4 * shape[c] * shape[(c + 1) % 3]);
  }
  Vector3 point{};
  for (std::size_t c = 0; c < corners; ++c)
  {
    const Vector3 middle = 0.5 * (x[c] + x[(c + 1) % corners]);
    point = point + shape[c] * x[c];
    point = point + (isCurved ? bubbles[c] : 0.0) * (x[corners + c] - middle);
  }
  return point;
}

Distances2 Measure(const Mesh& mesh, const Ball& ball)
{
  const MidNodes nodes(mesh.Corners, mesh.MidsPerElement);
  double curved = 0.0, straight = 0.0;
  Index count = 0;
  for (const MeshFacet& facet : mesh.Facets)
  {
    const ElementFaces faces(mesh.Corners);
    const auto corners =
      faces.PointsOf(mesh.Elements.data() + mesh.Corners * facet.Element, facet.Side);
    std::vector<Vector3> x;
    for (int c = 0; c < faces.Corners; ++c)
    {
      x.push_back(mesh.PointAt(corners[c]));
    }
    for (int c = 0; c < faces.Corners; ++c)
    {
      x.push_back(mesh.PointAt(
        mesh.MidPoints[nodes.Count * facet.Element + nodes.EdgeOfFace(facet.Side, c)]));
    }
    for (int n = 0; n < 9; ++n)
    {
      const auto off = [&](bool isCurved)
      {
        const double distance =
          Norm(PointOfFace(x, Gauss[n % 3], Gauss[n / 3], isCurved) - ball.Centre) - ball.Radius;
        return distance * distance;
      };
      curved += off(true);
      straight += off(false);
      ++count;
    }
  }
  const auto mean = [count](double sum) { return std::sqrt(sum / static_cast<double>(count)); };
  return { mean(curved), mean(straight) };
}

struct Kind
{
  const char* Name;
  MeshMaker Make;
};

} // namespace

/// Linear meshes, whose straight faces have the volume of the ball, are nearer than the straight
/// faces through the corners of the curved mesh.
TEST(SecondOrderAccuracy, FacesAreNearTheSphere)
{
  std::printf("rms distance of 3 x 3 quadrature points of faces from a sphere, in cells\n"
              "%6s %8s %14s %22s %14s %8s %8s\n",
    "cells", "elements", "curved faces", "their corners, straight", "linear mesh", "ratio",
    "ratio");
  for (const Index n : { 16, 32 })
  {
    const Ball ball{ { { 0.5 * n + 0.13, 0.5 * n + 0.07, 0.5 * n + 0.21 } }, 0.35 * n };
    std::vector<double> nodes(n + 1);
    std::iota(nodes.begin(), nodes.end(), 0.0);
    const std::array<std::vector<double>, 3> coordinates{ { nodes, nodes, nodes } };
    const CartesianGrid grid(coordinates);
    const FractionField fractions =
      FractionsOfShapes(grid, { MakeSphere(1, ball.Centre, ball.Radius) });
    for (const Kind& kind : { Kind{ "hexes", MakeHexMesh }, Kind{ "Lattice", MakeTetMesh } })
    {
      Runtime runtime;
      std::array<Distances2, 2> distances;
      for (int order = 0; order < 2; ++order)
      {
        MeshOptions options;
        options.ElementOrder =
          order == 1 ? InterpolationOrder::Quadratic : InterpolationOrder::Linear;
        MeshReport report;
        Mesh mesh = kind.Make(grid, fractions, options, runtime, report);
        OutputState none;
        AddMidNodes(InterpolationOrder::Quadratic, {}, runtime, mesh, none);
        distances[order] = Measure(mesh, ball);
        EXPECT_NEAR(report.MeshVolume[1] / report.TargetVolume[1], 1.0, 2e-7);
      }
      const double linear = distances[0].Straight;
      const Distances2& own = distances[1];
      std::printf("%6lld %8s %14.5f %22.5f %14.5f %8.1f %8.1f\n", static_cast<long long>(n),
        kind.Name, own.Curved, own.Straight, linear, own.Straight / own.Curved,
        linear / own.Curved);
      EXPECT_GT(own.Straight / own.Curved, 5.0);
      EXPECT_GT(linear / own.Curved, 5.0);
    }
  }
}
