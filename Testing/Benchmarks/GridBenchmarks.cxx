/**
 * Speed and memory of the mesher on one core. The reference of each run is a plain copy of the
 * arrays of its mesh: "of_copy" is the time in units of such copies.
 *
 * --table prints the figures of the manufactured cases instead. --table-tets prints the figures of
 * tetrahedra by every method, and their dihedral angles.
 */
#include "Base/Vector3.h"
#include "Elements/Tet/LatticeTopology.h"
#include "Fractions/RefineCells.h"
#include "Labels/ResolveLabels.h"
#include "MeasureAlone.h"
#include "MeshCases.h"
#include "NoCoarseTets.h"
#include "RankFields.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <fstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

template <class T>
std::size_t BytesOf(const Buffer<T>& buffer)
{
  return buffer.size() * sizeof(T);
}

std::size_t BytesOf(const Mesh& m)
{
  return BytesOf(m.Points) + BytesOf(m.PointIds) + BytesOf(m.GeometryDimension) +
    BytesOf(m.GeometryId) + BytesOf(m.Elements) + BytesOf(m.ElementIds) + BytesOf(m.Material) +
    BytesOf(m.Fragment) + BytesOf(m.ScaledJacobian);
}

/// Returns the seconds to copy as many bytes as the mesh has into new memory.
double TimeCopy(const Mesh& mesh)
{
  const std::size_t bytes = BytesOf(mesh);
  const Buffer<char> from(bytes, 1);
  const double begin = Now();
  Buffer<char> to(bytes);
  std::memcpy(to.data(), from.data(), bytes);
  benchmark::DoNotOptimize(to.data());
  return Now() - begin;
}

void Report(benchmark::State& state, const CartesianGrid& grid, const Mesh& mesh,
  const MeshReport& report, double seconds)
{
  const double cells = static_cast<double>(grid.Owned().NumberOfCells());
  state.counters["cells/s"] = cells / seconds;
  const std::string elements = mesh.HasHexes() ? "hexes" : "tets";
  state.counters[elements] = static_cast<double>(mesh.ElementIds.size());
  state.counters[elements + "/s"] = static_cast<double>(mesh.ElementIds.size()) / seconds;
  state.counters["bytes/cell"] = static_cast<double>(BytesOf(mesh)) / cells;
  state.counters["min_sj"] = report.MinimumScaledJacobian;
  state.counters["of_copy"] = seconds / TimeCopy(mesh);
  if (mesh.Corners == 4)
  {
    state.counters["min_dihedral"] = report.MinimumDihedralAngle;
    state.counters["max_dihedral"] = report.MaximumDihedralAngle;
  }
  std::string shares;
  for (const MeshReport::Stage& stage : report.Stages)
  {
    char text[64];
    std::snprintf(text, sizeof(text), "%s %.0f %%, ", stage.Name, 100.0 * stage.Seconds / seconds);
    shares += text;
  }
  state.SetLabel(shares);
}

void Run(benchmark::State& state, const CartesianGrid& grid, const FractionField& field,
  const MeshOptions& options, MeshMaker make = MakeHexMesh)
{
  Runtime runtime;
  MeshReport report, fastest;
  Mesh mesh;
  double seconds = 1e300;
  for (auto _ : state)
  {
    mesh = Mesh();
    const double begin = Now();
    mesh = make(grid, field, options, runtime, report);
    const double elapsed = Now() - begin;
    fastest = elapsed < seconds ? report : fastest;
    seconds = std::min(seconds, elapsed);
  }
  Report(state, grid, mesh, fastest, seconds);
}

void StairStep(benchmark::State& state)
{
  const CartesianGrid grid = MakeUnitGrid(state.range(0));
  MeshOptions options;
  options.StairStep = true;
  options.ComputeQuality = false; // all hexes are cells
  Run(state, grid, MakeConcentricLabels(grid, state.range(0)), options);
}
// The first run includes the cost of memory that the system has not provided before.
BENCHMARK(StairStep)
  ->Arg(24)
  ->Arg(96)
  ->Arg(240)
  ->Iterations(5)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void Sphere(benchmark::State& state)
{
  const MeshCase c = MakeSphereCase(static_cast<int>(state.range(0)));
  Run(state, c.Grid, c.Fractions, MeshOptions());
}
BENCHMARK(Sphere)->Arg(16)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond)->UseRealTime();

void Polycrystal(benchmark::State& state)
{
  const MeshCase c =
    MakePolycrystalCase(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  Run(state, c.Grid, c.Fractions, MeshOptions());
}
BENCHMARK(Polycrystal)
  ->Args({ 30, 24 })
  ->Args({ 1000, 96 })
  ->Iterations(1)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

MeshOptions OptionsOf(TetMethod method)
{
  MeshOptions options;
  options.Method = method;
  return options;
}

/// Measures only the step from labels to tets: without smoothing and quality.
void LatticeExtraction(benchmark::State& state)
{
  const MeshCase c = MakeSphereCase(static_cast<int>(state.range(0)));
  Runtime runtime;
  const Partition partition(c.Grid, runtime.Group());
  const LabelArray labels = MakeResolvedLabels(c.Grid, c.Fractions, partition, runtime);
  TetTopology topology;
  double seconds = 1e300;
  for (auto _ : state)
  {
    topology = TetTopology();
    const double begin = Now();
    LatticeNodes nodes(c.Grid, c.Fractions, labels, 0.5, partition, runtime);
    topology = BuildLatticeTets(
      c.Grid, nodes, false, NarrowVoid(), partition, runtime, NoCoarseTets(c.Grid, runtime).Tets)
                 .Topology;
    seconds = std::min(seconds, Now() - begin);
  }
  Report(state, c.Grid, topology.Tets, MeshReport(), seconds);
}
BENCHMARK(LatticeExtraction)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond)->UseRealTime();

void TetSphere(benchmark::State& state, TetMethod method)
{
  const MeshCase c = MakeSphereCase(static_cast<int>(state.range(0)));
  Run(state, c.Grid, c.Fractions, OptionsOf(method), MakeTetMesh);
}
BENCHMARK_CAPTURE(TetSphere, Lattice, TetMethod::Lattice)
  ->Arg(32)
  ->Arg(64)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(TetSphere, Cells, TetMethod::Cells)
  ->Arg(64)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void EightShapes(benchmark::State& state, TetMethod method)
{
  if (method == TetMethod::TetGen && !HasTetGen())
  {
    state.SkipWithError("built without TetGen");
    return;
  }
  const MeshCase c = MakeEightShapesCase();
  Run(state, c.Grid, c.Fractions, OptionsOf(method), MakeTetMesh);
}
BENCHMARK_CAPTURE(EightShapes, Lattice, TetMethod::Lattice)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(EightShapes, Cells, TetMethod::Cells)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(EightShapes, TetGen, TetMethod::TetGen)
  ->Iterations(1)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

/// Measures peak memory of meshing a sphere in n^3 cells, relative to input
/// (one double per cell) and output.
void Memory(benchmark::State& state)
{
  const Index n = state.range(0);
  std::vector<double> result;
  for (auto _ : state)
  {
    result = MeasureAlone(3,
      [&]
      {
        const CartesianGrid grid = MakeUnitGrid(n);
        const Vector3 middle{ { 0.5 * n + 0.1, 0.5 * n + 0.2, 0.5 * n + 0.3 } };
        // represents the simulation's array
        const Buffer<double> input(static_cast<std::size_t>(n * n * n), 0.5);
        const FractionField field = FractionsOfShapes(grid, { MakeSphere(1, middle, 0.4 * n) });
        Runtime runtime;
        MeshReport report;
        const Mesh mesh = MakeHexMesh(grid, field, MeshOptions(), runtime, report);
        return std::vector<double>{ static_cast<double>(BytesOf(input)),
          static_cast<double>(BytesOf(mesh)), static_cast<double>(PeakBytes()) };
      });
  }
  if (result.empty())
  {
    state.SkipWithError("the child failed");
    return;
  }
  state.counters["input_MB"] = result[0] * 1e-6;
  state.counters["output_MB"] = result[1] * 1e-6;
  state.counters["peak_MB"] = result[2] * 1e-6;
  state.counters["peak/(in+out)"] = result[2] / (result[0] + result[1]);
}
BENCHMARK(Memory)->Arg(128)->Arg(256)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Measures fractions and labels of n^3 cells halved `times` times, in bytes per finest cell. The
/// ball is so large that about 1 % of the cells are near an interface (within two cells). Times in
/// ms: halving, assigning, resolving, finding mixed nodes.
void FinestCells(benchmark::State& state)
{
  const Index n = state.range(0);
  std::vector<double> result;
  for (auto _ : state)
  {
    result = MeasureAlone(8,
      [&]
      {
        CartesianGrid grid = MakeUnitGrid(n);
        const double radius = std::sqrt(0.01 * static_cast<double>(n * n * n) / (4.0 * M_PI * 5.0));
        const Vector3 middle{ { 0.5 * n + 0.1, 0.5 * n + 0.2, 0.5 * n + 0.3 } };
        FractionField field = FractionsOfShapes(grid, { MakeSphere(1, middle, radius) });
        const double before = static_cast<double>(PeakBytes());
        Runtime runtime;
        double now = Now();
        const auto lap = [&]
        {
          const double then = std::exchange(now, Now());
          return 1e3 * (now - then);
        };
        for (Index time = 0; time < state.range(1); ++time)
        {
          RefinedCells refined = RefineCells(grid, field, runtime);
          grid = std::move(refined.Grid);
          field = std::move(refined.Fractions);
        }
        const double halving = lap();
        LabelArray labels = AssignMaterials(grid, field, 0.5);
        const double assigning = lap();
        ResolveLabels(grid, field, labels, Partition(grid, runtime.Group()), runtime);
        const double resolving = lap();
        benchmark::DoNotOptimize(FindMixedNodes(grid, labels));
        const double finding = lap();
        return std::vector<double>{ static_cast<double>(grid.Owned().NumberOfCells()),
          static_cast<double>(field.MemoryInBytes()), static_cast<double>(labels.MemoryInBytes()),
          static_cast<double>(PeakBytes()) - before, halving, assigning, resolving, finding };
      });
  }
  if (result.empty())
  {
    state.SkipWithError("the child failed");
    return;
  }
  state.counters["cells"] = result[0];
  state.counters["fractions_B/cell"] = result[1] / result[0];
  state.counters["labels_B/cell"] = result[2] / result[0];
  state.counters["both_MB"] = (result[1] + result[2]) * 1e-6;
  state.counters["peak_growth_MB"] = result[3] * 1e-6;
  state.counters["halve_ms"] = result[4];
  state.counters["assign_ms"] = result[5];
  state.counters["resolve_ms"] = result[6];
  state.counters["mixed_ms"] = result[7];
}
BENCHMARK(FinestCells)
  ->Args({ 128, 0 })
  ->Args({ 256, 0 })
  ->Args({ 256, 1 })
  ->Args({ 256, 2 })
  ->Iterations(1)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void PrintTable()
{
  Runtime runtime;
  std::printf("%s", FormatHeader().c_str());
  for (const std::string& name : ListMeshCases())
  {
    std::printf(
      "%s", FormatFigures(name, MeasureCase(MakeMeshCase(name), MeshOptions(), runtime)).c_str());
  }
}

void PrintTetTable()
{
  Runtime runtime;
  std::string angles = FormatAnglesHeader();
  std::printf("%s", FormatTetHeader().c_str());
  const auto print = [&](TetMethod method, const MeshCase& c)
  {
    const MeshFigures figures = MeasureCase(c, OptionsOf(method), runtime, MakeTetMesh);
    std::printf("%s", FormatTetFigures(method, c.Name, figures).c_str());
    std::fflush(stdout);
    angles += FormatAngles(method, c.Name, figures.Report);
  };
  for (TetMethod method : { TetMethod::Lattice, TetMethod::Cells, TetMethod::TetGen })
  {
    if (method == TetMethod::TetGen && !HasTetGen())
    {
      continue;
    }
    for (const std::string& name : ListMeshCases())
    {
      print(method, MakeMeshCase(name));
    }
    print(method, MakeEightShapesCase());
  }
  std::printf("\n%s", angles.c_str());
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && std::strcmp(argv[1], "--table") == 0)
  {
    PrintTable();
    return 0;
  }
  if (argc > 1 && std::strcmp(argv[1], "--table-tets") == 0)
  {
    PrintTetTable();
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
