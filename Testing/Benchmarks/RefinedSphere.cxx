/**
 * Savings by levels: a ball of radius .36 n in n^3 finest cells, meshed with all cells fine and
 * with coarser cells away from its surface, without and with the void around it.
 *
 * usage: RefinedSphere [n, default 64] [refinements, default 2] [--levels] [--counts]
 *   --levels: meshes only with levels, not with all cells fine
 *   --counts: interfaces stay as before smoothing
 */
#include "Base/Vector3.h"
#include "MeshCases.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MeshCase MakeCase(Index n, double radius)
{
  const double middle = 0.5 * n;
  const Vector3 center{ { middle + 0.1, middle + 0.2, middle + 0.3 } };
  CartesianGrid grid = MakeUnitGrid(n);
  FractionField fractions = FractionsOfShapes(grid, { MakeSphere(1, center, radius) });
  return { "", std::move(grid), std::move(fractions),
    [=](int, int, const Vector3& x) { return Norm(x - center) - radius; }, 0, 0, 0, 0, 0 };
}

void PrintFigures(const std::string& name, const MeshFigures& f, double trueVolume)
{
  std::printf("| %s | %zu | %zu | %.4f/%.5f | %.5f %% | %.5f %% | %.3f | %.3f | %.2f |\n",
    name.c_str(), f.Elements, f.Points, f.Distance.Largest, f.Distance.RootMeanSquare,
    100.0 * f.VolumeError, 100.0 * std::fabs(f.Report.MeshVolume[1] / trueVolume - 1.0),
    f.Report.MinimumScaledJacobian, f.Report.MeanScaledJacobian, f.Seconds);
  std::fflush(stdout);
}

void PrintDetails(const MeshReport& report)
{
  for (std::size_t level = 0; level < report.Levels.size(); ++level)
  {
    const MeshReport::Level& l = report.Levels[level];
    std::printf("    level %zu: %lld families refined (%lld added), %lld cells\n", level,
      static_cast<long long>(l.Families), static_cast<long long>(l.AddedForBalance),
      static_cast<long long>(l.Cells));
  }
  if (!report.Levels.empty())
  {
    std::printf("    transitions: %lld hexes\n", static_cast<long long>(report.TransitionCells));
  }
  for (const MeshReport::Stage& stage : report.Stages)
  {
    std::printf("    %-24s %7.3f s\n", stage.Name, stage.Seconds);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<int> numbers;
  bool levelsOnly = false, counts = false;
  for (int a = 1; a < argc; ++a)
  {
    levelsOnly = levelsOnly || std::strcmp(argv[a], "--levels") == 0;
    counts = counts || std::strcmp(argv[a], "--counts") == 0;
    if (argv[a][0] != '-')
    {
      numbers.push_back(std::atoi(argv[a]));
    }
  }
  const Index n = numbers.empty() ? 64 : numbers[0];
  const int refinements = numbers.size() > 1 ? numbers[1] : 2;
  const double radius = 0.36 * static_cast<double>(n);
  const double volume = 4.0 / 3.0 * M_PI * std::pow(radius, 3.0);
  const MeshCase c = MakeCase(n, radius);
  Runtime runtime;
  std::printf(
    "| mesh | hexes | points | distance max/rms [finest cells] | volume error to fractions | "
    "to the true ball | min SJ | mean SJ | s |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const bool meshVoid : { true, false })
  {
    MeshOptions options;
    options.MeshVoid = meshVoid;
    options.Smoothing = counts ? SmoothingMethod::Off : options.Smoothing;
    const std::string name = meshVoid ? "all" : "ball";
    std::size_t uniform = 0;
    if (!levelsOnly)
    {
      const MeshFigures figures = MeasureCase(c, options, runtime);
      uniform = figures.Elements;
      PrintFigures(name + ", " + std::to_string(n) + "^3 fine", figures, volume);
      PrintDetails(figures.Report);
    }
    options.Levels.Refinements = refinements;
    const MeshFigures figures = MeasureCase(c, options, runtime);
    PrintFigures(name + ", " + std::to_string(refinements) + " refinements", figures, volume);
    PrintDetails(figures.Report);
    if (uniform > 0)
    {
      std::printf("    %.2f times fewer hexes\n",
        static_cast<double>(uniform) / static_cast<double>(figures.Elements));
    }
  }
  return 0;
}
