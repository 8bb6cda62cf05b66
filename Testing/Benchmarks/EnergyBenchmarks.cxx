/**
 * Whether the derivatives of the energy wait for memory: their time per point in blocks of hexes of
 * several sizes. "of_small" is the time in units of that in a block whose data fit in a
 * second-level cache, measured in turn.
 */
#include "Base/Vector3.h"
#include "Cells/HexBlock.h"
#include "RandomDraw.h"
#include "SerialTimes.h"
#include "Smoothing/Hex/HexEnergy.h"

#include <benchmark/benchmark.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int SmallBlock = 12;   // points along each axis
constexpr double Distance = 0.1; // of points from their place in cubes, in cells

ActiveMesh MakeShaken(int points)
{
  ActiveMesh mesh = MakeHexBlock(points);
  RandomDraw draw(1);
  for (Vector3& x : mesh.X)
  {
    x = x + draw.Vector(-Distance, Distance);
  }
  return mesh;
}

/// Returns the seconds per point of the derivatives at all points.
double TimeDerivatives(const ActiveMesh& mesh)
{
  const HexEnergy energy(0.5);
  const SmoothingStage& stage = HexRamp().back();
  const int count = static_cast<int>(mesh.X.size());
  const double begin = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
  for (int p = 0; p < count; ++p)
  {
    benchmark::DoNotOptimize(energy.Differentiate(mesh, p, stage).Value);
  }
  return (CpuSeconds(CLOCK_THREAD_CPUTIME_ID) - begin) / count;
}

void HexDerivatives(benchmark::State& state)
{
  const ActiveMesh small = MakeShaken(SmallBlock);
  const ActiveMesh mesh = MakeShaken(static_cast<int>(state.range(0)));
  double nearest = 1e300, seconds = 1e300;
  for (auto _ : state)
  {
    seconds = std::min(seconds, TimeDerivatives(mesh));
    nearest = std::min(nearest, TimeDerivatives(small));
  }
  state.counters["ns/point"] = 1e9 * seconds;
  state.counters["of_small"] = seconds / nearest;
}
BENCHMARK(HexDerivatives)->Arg(12)->Arg(40)->Arg(70)->Iterations(40)->Unit(benchmark::kMillisecond);

} // namespace
