/**
 * What refining a little costs: peak memory and time of meshing all of n^3 cells, and of the same halved once around a
 * small ball, whose octets are about 1 % of the cells. Each runs in a process of its own.
 *
 * usage: RefinedMemory [n, default 64] [n ...] [--block: the ball is tiny, a block beside it is refined]
 * [--stages: when each began, and the peak then]
 */
#include "MeasureAlone.h"
#include "MeshCases.h"
#include "RefineCells.h"
#include "RefinedLattice.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double RefinedShare = 0.01;
/// Octets around a sphere of r cells hold about this times r^2 of them.
constexpr double CellsPerSquare = 85.0;

/// Tells at each step of a stage when it began and the peak so far.
class Watch : public Runtime
{
public:
  explicit Watch(bool prints) : Prints(prints), Begin(Now()) {}
  void Progress(double, const char* stage) override
  {
    if (this->Prints && this->Last != stage)
    {
      this->Last = stage;
      std::printf("    %-24s at %7.2f s, peak so far %7.1f MB\n", stage, Now() - this->Begin,
        1e-6 * static_cast<double>(PeakBytes()));
      std::fflush(stdout);
    }
  }

private:
  bool Prints;
  double Begin;
  const char* Last = nullptr;
};

/// Octets of a cube of 1 % of n^3 cells, in a corner.
std::vector<Index> ListBlock(Index n)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  const RefinedLattice lattice(grid, 1);
  const Index size = std::llround(0.5 * std::cbrt(RefinedShare) * static_cast<double>(n));
  std::vector<Index> keys;
  for (Index at = 0; at < size * size * size; ++at)
  {
    keys.push_back(
      lattice.OctetKey(0, { { at % size + 1, at / size % size + 1, at / size / size + 1 } }));
  }
  return keys;
}

/// Peak bytes, seconds, hexes, refined cells, transition hexes.
std::vector<double> MeshBall(Index n, int refinements, bool block, bool stages)
{
  CartesianGrid grid = MakeUnitGrid(n);
  const double cells = std::pow(static_cast<double>(n), 3.0);
  const double radius = block ? 4.0 : std::sqrt(RefinedShare * cells / CellsPerSquare);
  const double middle = 0.5 * n;
  FractionField field = FractionsOfShapes(
    grid, { MakeSphere(1, { { middle + 0.1, middle + 0.2, middle + 0.3 } }, radius) });
  Watch runtime(stages);
  MeshReport report;
  MeshOptions options;
  options.MeshVoid = true;
  options.Levels.Refinements = refinements;
  if (block && refinements > 0)
  {
    options.Levels.Octets = { ListBlock(n) };
  }
  const double begin = Now();
  for (int level = 0; level < refinements; ++level)
  {
    RefinedCells refined = RefineCells(grid, field, runtime);
    grid = std::move(refined.Grid);
    field = std::move(refined.Fractions);
  }
  const Mesh mesh = MakeHexMesh(grid, field, options, runtime, report);
  const double seconds = Now() - begin;
  const double refined =
    report.Levels.empty() ? 0.0 : 8.0 * static_cast<double>(report.Levels[0].Octets);
  return { static_cast<double>(PeakBytes()), seconds, static_cast<double>(mesh.ElementIds.size()),
    refined, static_cast<double>(report.TransitionCells) };
}

void PrintRow(Index n, bool block, bool stages)
{
  const std::vector<double> base = MeasureAlone(5, [&] { return MeshBall(n, 0, block, stages); });
  const std::vector<double> refined =
    MeasureAlone(5, [&] { return MeshBall(n, 1, block, stages); });
  if (base.empty() || refined.empty())
  {
    std::printf("| %lld^3 | failed |\n", static_cast<long long>(n));
    return;
  }
  std::printf(
    "| %lld^3 | %.2f %% | %.0f | %.0f | %.3f (%.0f in transitions) | %.1f | %.1f | %.3f | "
    "%.2f | %.2f | %.3f |\n",
    static_cast<long long>(n), 100.0 * refined[3] / std::pow(static_cast<double>(n), 3.0), base[2],
    refined[2], refined[2] / base[2], refined[4], 1e-6 * base[0], 1e-6 * refined[0],
    refined[0] / base[0], base[1], refined[1], refined[1] / base[1]);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<Index> sizes;
  bool stages = false, block = false;
  for (int a = 1; a < argc; ++a)
  {
    stages = stages || std::strcmp(argv[a], "--stages") == 0;
    block = block || std::strcmp(argv[a], "--block") == 0;
    if (argv[a][0] != '-')
    {
      sizes.push_back(std::atoll(argv[a]));
    }
  }
  if (sizes.empty())
  {
    sizes.push_back(64);
  }
  std::printf(
    "| cells | refined | hexes | hexes refined | ratio | peak MB | peak MB refined | ratio | "
    "s | s refined | ratio |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::fflush(stdout);
  for (Index n : sizes)
  {
    PrintRow(n, block, stages);
  }
  return 0;
}
