/**
 * Time of the volume fractions of a long solid whose length lies along x, y or z.
 *
 * usage: SurfaceFractions [CELLS [RINGS [THREADS]]]
 *
 * The solid is an ellipsoid with the half axes 1, 0.2 and 0.1 as 4 RINGS (RINGS - 1) triangles. The
 * grid has CELLS cubic cells along its length. Each time is the least of several runs.
 */
#include "Surfaces/SurfaceFractions.h"
#include "Base/ThreadRuntime.h"
#include "Base/Vector3.h"
#include "MeasureAlone.h"
#include "SurfaceCases.h"

#include <cstdio>
#include <cstdlib>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Rounds = 5;
constexpr double Margin = 1.01; // grid over solid

/// Returns the half axes of the solid, the longest along an axis.
Vector3 HalfAxes(int axis)
{
  Vector3 half;
  half[axis] = 1.0;
  half[(axis + 1) % 3] = 0.2;
  half[(axis + 2) % 3] = 0.1;
  return half;
}

std::array<std::vector<double>, 3> NodesAround(const Vector3& half, int cells)
{
  std::array<std::vector<double>, 3> nodes;
  const double width = 2.0 * Margin / cells;
  for (int a = 0; a < 3; ++a)
  {
    const int count = static_cast<int>(std::ceil(2.0 * Margin * half[a] / width));
    for (int i = 0; i <= count; ++i)
    {
      nodes[a].push_back((i - 0.5 * count) * width);
    }
  }
  return nodes;
}

double LeastTime(int axis, int cells, int rings, int threads)
{
  const Vector3 half = HalfAxes(axis);
  InputSurfaces input;
  input.Bodies.push_back({ "hull", SphereSurface({ { 0, 0, 0 } }, 1.0, rings), {}, {} });
  for (Vector3& point : input.Bodies[0].Boundary.Points)
  {
    point = Scaled(half, point);
  }
  const std::array<std::vector<double>, 3> nodes = NodesAround(half, cells);
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    box.Upper[a] = static_cast<Index>(nodes[a].size()) - 1;
  }
  double least = 1e300;
  for (int round = 0; round < Rounds; ++round)
  {
    ThreadRuntime runtime(threads);
    const double begin = Now();
    FractionsOfSurfaces(nodes, box, input, runtime);
    least = std::min(least, Now() - begin);
  }
  return least;
}

} // namespace

int main(int argc, char** argv)
{
  const int cells = argc > 1 ? std::atoi(argv[1]) : 135;
  const int rings = argc > 2 ? std::atoi(argv[2]) : 170;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 1;
  if (cells < 1 || rings < 2 || threads < 1)
  {
    std::fprintf(stderr, "At least 1 cell, 2 rings and 1 thread are required.\n");
    return 1;
  }
  std::array<double, 3> seconds;
  for (int axis = 0; axis < 3; ++axis)
  {
    seconds[axis] = LeastTime(axis, cells, rings, threads);
  }
  const auto range = std::minmax_element(seconds.begin(), seconds.end());
  std::printf(
    "| cells | triangles | s along x | y | z | largest / least |\n|---|---|---|---|---|---|\n"
    "| %d | %d | %.4f | %.4f | %.4f | %.2f |\n",
    cells, 4 * rings * (rings - 1), seconds[0], seconds[1], seconds[2],
    *range.second / *range.first);
  return 0;
}
