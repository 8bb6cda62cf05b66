/**
 * Counts the labels of a parcellation that keep their volume: an atlas of many labels
 * (Support/Atlas.h), smoothed and meshed.
 *
 * usage: AtlasLabels [n, default 160] [labels, default 700] [passes of smoothing, default 3]
 *                    [seed, default 1]
 */
#include "Atlas.h"
#include "Base/Partition.h"
#include "HexPipeline.h"
#include "Labels/SmoothLabels.h"
#include "MeshChecks.h"

#include <cstdio>
#include <cstdlib>

using namespace vfm;
using namespace vfm::testing;

int main(int argc, char** argv)
{
  const auto argument = [&](int a, int otherwise)
  { return argc > a ? std::atoi(argv[a]) : otherwise; };
  const CartesianGrid grid = MakeUnitGrid(argument(1, 160));
  const FractionField labels = MakeAtlas(grid, argument(2, 700), argument(4, 1));
  Runtime runtime;
  FractionField fractions = labels;
  double error = 0.0;
  if (const int passes = argument(3, 3); passes > 0)
  {
    error = SmoothLabels(grid, passes, Partition(grid, runtime.Group()), runtime, fractions);
  }
  MeshReport report;
  const Mesh mesh = MakeHexMesh(grid, fractions, MeshOptions(), runtime, report);
  std::printf("%zu hexes, %lld fragments, %lld flips in %d rounds, volume error of smoothing %.2g, "
              "scaled Jacobian min %.4f mean %.4f\n",
    mesh.ElementIds.size(), static_cast<long long>(report.NumberOfFragments),
    static_cast<long long>(report.FlippedCells), report.ResolveRounds, error,
    report.MinimumScaledJacobian, report.MeanScaledJacobian);
  for (const MeshReport::Stage& stage : report.Stages)
  {
    std::printf("    %-24s %7.3f s\n", stage.Name, stage.Seconds);
  }
  std::printf("%s", FormatAtlas(MeasureAtlas(grid, labels, report)).c_str());
  return 0;
}
