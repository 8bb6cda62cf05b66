/**
 * Speed, effort and quality of meshes: one row per case. scripts/compare_speed compares two builds.
 *
 * usage: Speed [CASE, list or all, default all] [runs, default 3] [threads, default 1]
 *              [ranks, default 1]
 *
 * Seconds are of the fastest run, CPU of all threads in it. Ranks are
 * threads here, with slabs along z.
 */
#include "Atlas.h"
#include "Base/ThreadRuntime.h"
#include "Labels/SmoothLabels.h"
#include "MeasureAlone.h"
#include "RankMeshes.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr char Header[] =
  "| case | threads | ranks | elements | seconds | CPU | elements/s | SJ min | SJ mean | "
  "distance max | rms | points | sweeps | visits per point | peak MB |\n"
  "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

/// A case and the options of its mesh.
struct SpeedCase
{
  std::string Name;
  std::function<MeshCase()> Make; // no distance if there is no true surface
  MeshOptions Options;
  MeshMaker Maker = MakeHexMesh;
};

MeshCase MakeGyroidCase(int n)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  const std::vector<Shape> shapes{ MakeGyroid(1, { { 0.1, 0.2, 0.3 } }, 16.0) };
  MeshCase c = MakeMeshCase("gyroid");
  c.Grid = grid;
  c.Fractions = FractionsOfShapes(grid, shapes);
  return c;
}

MeshCase WithoutDistance(const CartesianGrid& grid, FractionField fractions)
{
  return { "", grid, std::move(fractions), {}, 0.0, 0.0, 0.0, 0.0, 0.0 };
}

MeshCase MakeLabelsCase(int n, int labels)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  FractionField fractions = MakeAtlas(grid, labels, 1);
  Runtime runtime;
  SmoothLabels(grid, 3, Partition(grid, runtime.Group()), runtime, fractions);
  return WithoutDistance(grid, std::move(fractions));
}

std::vector<SpeedCase> ListCases()
{
  MeshOptions stairs;
  stairs.StairStep = true;
  MeshOptions cells;
  cells.Tets = TetMethod::Cells;
  return { { "sphere", [] { return MakeSphereCase(64); }, {} },
    { "gyroid", [] { return MakeGyroidCase(64); }, {} },
    { "polycrystal", [] { return MakePolycrystalCase(300, 48); }, {} },
    { "labels", [] { return MakeLabelsCase(96, 200); }, {} },
    { "plate", [] { return MakeMeshCase("plate 2 thick"); }, {} },
    { "small", [] { return MakeSphereCase(16); }, {} },
    { "stairs",
      []
      {
        const CartesianGrid grid = MakeUnitGrid(160);
        return WithoutDistance(grid, MakeConcentricLabels(grid, 160));
      },
      stairs },
    { "lattice", [] { return MakeSphereCase(64); }, {}, MakeTetMesh },
    { "cells", [] { return MakeSphereCase(64); }, cells, MakeTetMesh } };
}

double CpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Outcome
{
  double Seconds = 1e300, Cpu = 1e300;
  Index Elements = 0;
  MeshReport Report; // report of the fastest run
  Distances Distance;
};

/// The mesh of one rank, or the largest part of several.
struct Run
{
  Mesh Result;
  MeshReport Report;
  Index Elements = 0;
};

Run MeshOnce(const SpeedCase& what, const MeshCase& c, int threads)
{
  ThreadRuntime runtime(threads, nullptr);
  Run run;
  run.Result = what.Maker(c.Grid, c.Fractions, what.Options, runtime, run.Report);
  run.Elements = static_cast<Index>(run.Result.ElementIds.size());
  return run;
}

class RankedCase
{
public:
  RankedCase(const MeshCase& c, int ranks) : Boxes(CutBox(c.Grid.Owned(), ranks, 2))
  {
    for (const IndexBox& box : this->Boxes)
    {
      this->Grids.push_back(MakeRankGrid(c.Grid, box));
      this->Fields.push_back(CopyToLocal(c.Grid, c.Fractions, this->Grids.back()));
    }
  }

  Run MeshOnce(const SpeedCase& what, int threads) const
  {
    Run run;
    std::atomic<Index> elements(0);
    RunOnRanks(static_cast<int>(this->Boxes.size()),
      [&](Ranks& ranks)
      {
        ThreadRuntime runtime(threads, &ranks);
        MeshReport report;
        const std::size_t rank = ranks.Rank();
        const Mesh mesh =
          what.Maker(this->Grids[rank], this->Fields[rank], what.Options, runtime, report);
        elements += static_cast<Index>(mesh.ElementIds.size());
        if (rank == 0)
        {
          run.Report = report;
        }
      });
    run.Elements = elements;
    return run;
  }

private:
  std::vector<IndexBox> Boxes;
  std::vector<CartesianGrid> Grids;
  std::vector<FractionField> Fields;
};

Outcome Measure(const SpeedCase& what, int runs, int threads, int ranks)
{
  const MeshCase c = what.Make();
  const RankedCase cut(c, ranks);
  Outcome outcome;
  for (int r = 0; r < runs; ++r)
  {
    const double begin = Now(), cpu = CpuSeconds();
    const Run run = ranks > 1 ? cut.MeshOnce(what, threads) : MeshOnce(what, c, threads);
    const double seconds = Now() - begin;
    outcome.Cpu = std::min(outcome.Cpu, CpuSeconds() - cpu);
    if (seconds < outcome.Seconds)
    {
      outcome.Seconds = seconds;
      outcome.Report = run.Report;
    }
    outcome.Elements = run.Elements;
    if (r == 0 && c.Distance && ranks == 1)
    {
      Distances onSides;
      MeasureInterfaces(c, run.Result, outcome.Distance, onSides);
    }
  }
  return outcome;
}

void Print(const std::string& name, int threads, int ranks, const Outcome& o)
{
  const MeshReport& r = o.Report;
  const double points = std::max<double>(1.0, static_cast<double>(r.SmoothedPoints));
  std::printf(
    "| %s | %d | %d | %lld | %.3f | %.3f | %.0f | %.4f | %.4f | %.4f | %.5f | %lld | %d | "
    "%.1f | %.0f |\n",
    name.c_str(), threads, ranks, static_cast<long long>(o.Elements), o.Seconds, o.Cpu,
    static_cast<double>(o.Elements) / o.Seconds, r.MinimumScaledJacobian, r.MeanScaledJacobian,
    o.Distance.Largest, o.Distance.RootMeanSquare, static_cast<long long>(r.SmoothedPoints),
    r.Sweeps, static_cast<double>(r.Visits) / points, static_cast<double>(PeakBytes()) * 1e-6);
  for (const MeshReport::Stage& stage : r.Stages)
  {
    std::printf("    %-24s %7.3f s\n", stage.Name, stage.Seconds);
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const std::string requested = argc > 1 ? argv[1] : "all";
  const auto argument = [&](int a, int otherwise)
  { return argc > a ? std::max(1, std::atoi(argv[a])) : otherwise; };
  const int runs = argument(2, 3), threads = argument(3, 1), ranks = argument(4, 1);
  bool isKnown = false;
  for (const SpeedCase& what : ListCases())
  {
    if (requested == "list")
    {
      std::printf("%s\n", what.Name.c_str());
      isKnown = true;
    }
    else if (requested == "all" || requested == what.Name)
    {
      std::printf("%s", isKnown ? "" : Header);
      isKnown = true;
      Print(what.Name, threads, ranks, Measure(what, runs, threads, ranks));
    }
  }
  if (!isKnown)
  {
    std::fprintf(stderr, "Speed: there is no case %s\n", requested.c_str());
  }
  return isKnown ? 0 : 1;
}
