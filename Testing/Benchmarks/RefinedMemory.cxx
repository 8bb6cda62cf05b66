/**
 * Cost of a small refinement: peak memory and time of meshing all of n^3 cells, and of the
 * same cells halved once around a small ball, with about 1 % of the cells in families. Each
 * mesh is made in a separate process.
 *
 * usage: RefinedMemory [n, default 64] [n ...] [--block] [--place] [--stages]
 *   --block: the ball is tiny, a block next to it is refined
 *   --place: the ball is large, only a block that its surface crosses is refined
 *   --stages: prints the start of each stage and the peak memory then
 */
#include "Fractions/RefineCells.h"
#include "MeasureAlone.h"
#include "MeshCases.h"
#include "Octree/OctreeKeys.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double RefinedShare = 0.01;
/// Families around a sphere of radius r cells contain about this number times r^2 cells.
constexpr double CellsPerSquare = 85.0;

/// Prints the time and the peak memory so far at the start of each stage.
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

/// Refined part of the grid, and the ball.
enum class Scene
{
  Shell, // all interfaces of a small ball
  Block, // a block next to a tiny ball
  Place  // a block that the surface of a large ball crosses
};

constexpr double LargeRadius = 0.36; // in units of n

/// Returns the families of a cube of 1 % of n^3 cells, at a corner or around the
/// end of the large ball along x.
std::vector<Index> ListBlock(Index n, Scene scene)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  const OctreeKeys lattice(grid, 1);
  const Index size = std::llround(0.5 * std::cbrt(RefinedShare) * static_cast<double>(n));
  Index3 first{ { 1, 1, 1 } };
  if (scene == Scene::Place)
  {
    const Index middle = n / 4 - size / 2;
    first = { { middle + std::llround(0.5 * LargeRadius * static_cast<double>(n)), middle,
      middle } };
  }
  std::vector<Index> keys;
  const IndexBox box{ first, { { first[0] + size, first[1] + size, first[2] + size } } };
  ForCells(box, [&](const Index3& q) { keys.push_back(lattice.FamilyKey(0, q)); });
  return keys;
}

/// Returns peak bytes, seconds, hexes, refined cells, transition hexes.
std::vector<double> MeshBall(Index n, int refinements, Scene scene, bool stages)
{
  CartesianGrid grid = MakeUnitGrid(n);
  const double cells = std::pow(static_cast<double>(n), 3.0);
  const double radius = scene == Scene::Block ? 4.0
    : scene == Scene::Place                   ? LargeRadius * static_cast<double>(n)
                                              : std::sqrt(RefinedShare * cells / CellsPerSquare);
  const double middle = 0.5 * n;
  FractionField field = FractionsOfShapes(
    grid, { MakeSphere(1, { { middle + 0.1, middle + 0.2, middle + 0.3 } }, radius) });
  Watch runtime(stages);
  MeshReport report;
  MeshOptions options;
  options.MeshVoid = true;
  options.Levels.Refinements = refinements;
  if (scene != Scene::Shell && refinements > 0)
  {
    options.Levels.Families = { ListBlock(n, scene) };
    options.Levels.FineInterfaces = scene == Scene::Block;
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
    report.Levels.empty() ? 0.0 : 8.0 * static_cast<double>(report.Levels[0].Families);
  return { static_cast<double>(PeakBytes()), seconds, static_cast<double>(mesh.ElementIds.size()),
    refined, static_cast<double>(report.TransitionCells) };
}

void PrintRow(Index n, Scene scene, bool stages)
{
  const std::vector<double> base = MeasureAlone(5, [&] { return MeshBall(n, 0, scene, stages); });
  const std::vector<double> refined =
    MeasureAlone(5, [&] { return MeshBall(n, 1, scene, stages); });
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
  bool stages = false;
  Scene scene = Scene::Shell;
  for (int a = 1; a < argc; ++a)
  {
    stages = stages || std::strcmp(argv[a], "--stages") == 0;
    scene = std::strcmp(argv[a], "--block") == 0 ? Scene::Block
      : std::strcmp(argv[a], "--place") == 0     ? Scene::Place
                                                 : scene;
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
    PrintRow(n, scene, stages);
  }
  return 0;
}
