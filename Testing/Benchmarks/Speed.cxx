/**
 * Speed, effort and quality of meshes: one row per case. scripts/compare_speed compares two builds.
 *
 * usage: Speed [CASE, list, list-real, list-parts, all or real, default all] [runs, default 3]
 *              [threads, default 1] [ranks, default 1]
 *
 * Seconds are of the fastest run, CPU of all threads in it. Stages of rank 0: wall time, CPU of its
 * threads, the part of it that runs on one thread only (serial), and the largest possible ratio of
 * the speeds on two threads and on one (bound). CPU times of a stage that occurs repeatedly are of
 * all its occurrences. Ranks are threads here, with boxes of equal weight (MakePartition). Off:
 * fragments of one rank whose volume is off by more than .5 %. Memory: the peak of the process
 * above its memory before meshing, over that of fractions and mesh; bytes a point: the same over
 * the points that move. `real` are the cases like the data of users (RealCases.h); images come from
 * Debian's package mricron-data. The cases NAME-3 smooth the labels of NAME by 3 passes, which is
 * one of their stages. Parts are small cases like them.
 */
#include "Atlas.h"
#include "Elements/MeasureFragments.h"
#include "FragmentShares.h"
#include "Input/MakePartition.h"
#include "Labels/SmoothLabels.h"
#include "MeasureAlone.h"
#include "Options/OptionTable.h"
#include "RankMeshes.h"
#include "RealCases.h"
#include "Report/FragmentTargets.h"
#include "SerialTimes.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr char Header[] =
  "| case | threads | ranks | elements | seconds | CPU | elements/s | SJ min | SJ mean | "
  "distance max | rms | points | sweeps | visits per point | peak MB | fragments | off | material "
  "off by | bytes a point | memory |\n"
  "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

/// A case and the options of its mesh.
struct SpeedCase
{
  std::string Name;
  std::function<MeshCase()> Make; // no distance if there is no true surface
  MeshOptions Options;
  MeshMaker Maker = MakeHexMesh;
  int LabelPasses = 0; // label smoothing, part of what is measured
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

MeshCase MakeLabelsCase(int n, int labels)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  return MakeSmoothedCase(grid, MakeAtlas(grid, labels, 1), 3);
}

std::vector<SpeedCase> ListCases()
{
  MeshOptions stairs;
  stairs.StairStep = true;
  MeshOptions cells;
  cells.Method = TetMethod::Cells;
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
    { "polycrystal-lattice", [] { return MakePolycrystalCase(300, 48); }, {}, MakeTetMesh },
    { "cells", [] { return MakeSphereCase(64); }, cells, MakeTetMesh } };
}

/// Returns a case of an image whose labels are smoothed in each run.
SpeedCase SmoothedImage(const std::string& name, const std::string& image)
{
  return { name, [image] { return MakeImageCase(image, 0); }, {}, MakeHexMesh, 3 };
}

std::vector<SpeedCase> ListRealCases()
{
  return { { "gyroid-128", [] { return MakeGyroidCase(128); }, {} },
    { "spray-100", [] { return MakeSprayCase(100, 2880, 1); }, {} },
    { "spray-200", [] { return MakeSprayCase(200, 23040, 1); }, {} },
    { "pores", [] { return MakePoresCase(48, 3, 1); }, {} },
    { "aicha", [] { return MakeImageCase("AICHAmc", 0); }, {} },
    { "jhu", [] { return MakeImageCase("JHU-WhiteMatter-labels-1mm", 3); }, {} },
    { "aal", [] { return MakeImageCase("aal", 0); }, {} },
    { "inia19", [] { return MakeImageCase("inia19-NeuroMaps", 0); }, {} },
    SmoothedImage("aicha-3", "AICHAmc"), SmoothedImage("aal-3", "aal"),
    SmoothedImage("inia19-3", "inia19-NeuroMaps") };
}

/// Returns small cases of the same kinds, which end in minutes where misses are counted
/// (scripts/count_misses).
std::vector<SpeedCase> ListParts()
{
  return { { "aicha-32", [] { return MakeImageCase("AICHAmc", 0, 32); }, {} },
    { "spray-48", [] { return MakeSprayCase(48, 320, 1); }, {} },
    { "polycrystal-24", [] { return MakePolycrystalCase(40, 24); }, {} } };
}

constexpr double TolerableError = 5e-3; // relative error of a fragment

struct Outcome
{
  double Seconds = 1e300, Cpu = 1e300;
  Index Elements = 0;
  MeshReport Report; // report of the fastest run
  SerialTimes Times; // of the fastest run
  Distances Distance;
  Index OffFragments = 0;      ///< fragments off by more than TolerableError
  double MaterialError = 0.0;  ///< largest relative error of a material
  double Memory = 0.0;         ///< bytes above those before meshing, at the peak
  double InputAndOutput = 0.0; ///< bytes of fractions and mesh
};

/// The mesh of one rank, or the largest part of several.
struct Run
{
  Mesh Result;
  MeshReport Report;
  std::vector<double> Targets; // volume of the fractions of fragments 1, 2, ..
  SerialTimes Times;           // of rank 0
  Index Elements = 0;
};

/// Makes the mesh of a rank; with label smoothing as its first stage, if the case has it.
Mesh MakeMesh(const SpeedCase& what, const CartesianGrid& grid, const FractionField& fractions,
  Runtime& runtime, MeshReport& report)
{
  if (what.LabelPasses == 0)
  {
    return what.Maker(grid, fractions, what.Options, runtime, report);
  }
  const char* const stage = "Smoothing labels";
  const double begin = Now();
  runtime.Progress(0.0, stage);
  FractionField smooth = fractions;
  SmoothLabels(grid, what.LabelPasses, Partition(grid, runtime.Group()), runtime, smooth);
  const double seconds = Now() - begin;
  Mesh mesh = what.Maker(grid, smooth, what.Options, runtime, report);
  report.Stages.insert(report.Stages.begin(), { stage, seconds });
  return mesh;
}

Run MeshOnce(const SpeedCase& what, const MeshCase& c, int threads)
{
  TimedRuntime runtime(threads, nullptr);
  Run run;
  run.Result = MakeMesh(what, c.Grid, c.Fractions, runtime, run.Report);
  run.Targets = run.Report.Fragments.Volumes;
  run.Times = runtime.Times();
  run.Elements = static_cast<Index>(run.Result.ElementIds.size());
  return run;
}

std::vector<Index3> ListInterfaceCells(const MeshCase& c)
{
  std::vector<Index3> cells;
  FindInterfaceCells(
    c.Grid.Owned(),
    [&](const Index3& first, Index count, int* materials)
    {
      const Index begin = c.Grid.Linear(first);
      for (Index i = 0; i < count; ++i)
      {
        materials[i] = c.Fractions.IsMixed(begin + i) ? -1 : c.Fractions.Label(begin + i);
      }
    },
    cells);
  return cells;
}

/// Returns the boxes of the ranks as the filters choose them.
std::vector<IndexBox> CutByWeights(const MeshCase& c, int count)
{
  std::vector<IndexBox> boxes(count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const bool isFirst = ranks.Rank() == 0;
      const auto listCells = [&]
      { return isFirst ? ListInterfaceCells(c) : std::vector<Index3>(); };
      boxes[ranks.Rank()] = MakePartition(c.Grid.Owned(),
        isFirst ? std::vector<IndexBox>{ c.Grid.Owned() } : std::vector<IndexBox>(), listCells,
        ranks, false);
    });
  return boxes;
}

class RankedCase
{
public:
  RankedCase(const MeshCase& c, int ranks) : Boxes(CutByWeights(c, ranks))
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
        TimedRuntime runtime(threads, &ranks);
        MeshReport report;
        const std::size_t rank = ranks.Rank();
        const Mesh mesh = MakeMesh(what, this->Grids[rank], this->Fields[rank], runtime, report);
        elements += static_cast<Index>(mesh.ElementIds.size());
        const std::vector<double> targets =
          GatherFragmentTargets(report.Fragments, report.NumberOfFragments, ranks);
        if (rank == 0)
        {
          run.Report = report;
          run.Targets = targets;
          run.Times = runtime.Times();
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

double BytesOf(const Mesh& mesh)
{
  return static_cast<double>(sizeof(double) * mesh.Points.size() +
    sizeof(Index) * (mesh.PointIds.size() + mesh.Elements.size() + mesh.ElementIds.size()) +
    sizeof(int) * (mesh.Material.size() + mesh.Fragment.size()));
}

/// Compares volumes with those of the fractions.
void MeasureVolumes(const MeshCase& c, const Run& run, Outcome& outcome)
{
  Runtime runtime;
  const MeshReport& report = run.Report;
  const std::vector<double> volumes = MeasureFragments(
    run.Result, c.Grid, ShareOfAll(report.NumberOfFragments, runtime.Group()), runtime);
  for (std::size_t f = 1; f < volumes.size(); ++f)
  {
    const double target = run.Targets[f - 1]; // cells have volume 1
    outcome.OffFragments += std::abs(volumes[f] - target) > TolerableError * target;
  }
  for (std::size_t m = 1; m < report.MeshVolume.size(); ++m)
  {
    const double target = report.TargetVolume[m];
    outcome.MaterialError =
      std::max(outcome.MaterialError, std::abs(report.MeshVolume[m] - target) / target);
  }
}

Outcome Measure(const SpeedCase& what, int runs, int threads, int ranks)
{
  const MeshCase c = what.Make();
  const RankedCase cut(c, ranks);
  Outcome outcome;
  const double before = static_cast<double>(CurrentBytes());
  for (int r = 0; r < runs; ++r)
  {
    const double begin = Now(), cpu = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    const Run run = ranks > 1 ? cut.MeshOnce(what, threads) : MeshOnce(what, c, threads);
    const double seconds = Now() - begin;
    outcome.Cpu = std::min(outcome.Cpu, CpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
    if (seconds < outcome.Seconds)
    {
      outcome.Seconds = seconds;
      outcome.Report = run.Report;
      outcome.Times = run.Times;
    }
    outcome.Elements = run.Elements;
    outcome.Memory = static_cast<double>(PeakBytes()) - before;
    outcome.InputAndOutput = static_cast<double>(c.Fractions.MemoryInBytes()) + BytesOf(run.Result);
    if (r == 0 && ranks == 1)
    {
      MeasureVolumes(c, run, outcome);
      Distances onSides;
      if (c.Distance)
      {
        MeasureInterfaces(c, run.Result, outcome.Distance, onSides);
      }
    }
  }
  return outcome;
}

void PrintStage(const char* name, double seconds, const SerialTime& time)
{
  std::printf("    %-24s %7.3f s, CPU %7.3f s, serial %7.3f s, bound %.3f\n", name, seconds,
    time.Total(), time.Serial, time.Bound(2));
}

void Print(const std::string& name, int threads, int ranks, const Outcome& o)
{
  const MeshReport& r = o.Report;
  const double points = std::max<double>(1.0, static_cast<double>(r.SmoothedPoints));
  std::printf(
    "| %s | %d | %d | %lld | %.3f | %.3f | %.0f | %.4f | %.4f | %.4f | %.5f | %lld | %d | "
    "%.1f | %.0f | %lld | %lld | %.1e | %.0f | %.1f |\n",
    name.c_str(), threads, ranks, static_cast<long long>(o.Elements), o.Seconds, o.Cpu,
    static_cast<double>(o.Elements) / o.Seconds, r.MinimumScaledJacobian, r.MeanScaledJacobian,
    o.Distance.Largest, o.Distance.RootMeanSquare, static_cast<long long>(r.SmoothedPoints),
    r.Sweeps, static_cast<double>(r.Visits) / points, static_cast<double>(PeakBytes()) * 1e-6,
    static_cast<long long>(r.NumberOfFragments), static_cast<long long>(o.OffFragments),
    o.MaterialError, o.Memory / points, o.Memory / o.InputAndOutput);
  for (const MeshReport::Stage& stage : r.Stages)
  {
    PrintStage(stage.Name, stage.Seconds, o.Times.at(stage.Name));
  }
  SerialTime all;
  for (const auto& time : o.Times)
  {
    all.Serial += time.second.Serial;
    all.Loops += time.second.Loops;
  }
  PrintStage("all", o.Seconds, all);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  GetOptionTable(); // front ends have it before the fields, too: later it would split free memory
  const std::string requested = argc > 1 ? argv[1] : "all";
  const auto argument = [&](int a, int otherwise)
  { return argc > a ? std::max(1, std::atoi(argv[a])) : otherwise; };
  const int runs = argument(2, 3), threads = argument(3, 1), ranks = argument(4, 1);
  std::vector<SpeedCase> cases = ListCases(), real = ListRealCases(), parts = ListParts();
  const std::map<std::string, const std::vector<SpeedCase>*> lists{ { "list", &cases },
    { "list-real", &real }, { "list-parts", &parts } };
  if (const auto list = lists.find(requested); list != lists.end())
  {
    for (const SpeedCase& what : *list->second)
    {
      std::printf("%s\n", what.Name.c_str());
    }
    return 0;
  }
  if (requested == "real")
  {
    cases.clear();
  }
  if (requested != "all")
  {
    std::move(real.begin(), real.end(), std::back_inserter(cases));
    std::move(parts.begin(), parts.end(), std::back_inserter(cases));
  }
  bool isKnown = false;
  for (const SpeedCase& what : cases)
  {
    if (requested == "all" || requested == "real" || requested == what.Name)
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
