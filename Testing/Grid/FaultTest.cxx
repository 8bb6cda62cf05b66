/// Memory runs out on one rank at any call: all ranks end with the same message, and the next
/// mesh on the same ranks is correct.
#include "Faults.h"
#include "MeshCases.h"
#include "RankFields.h"
#include "RankMeshes.h"
#include "Sweep.h"

#include "Labels/SmallRegions.h"
#include "Labels/SmoothLabels.h"
#include "Ranks/WorkTogether.h"
#include "State/Transfer/TransferState.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Count = 3;

using Words = std::vector<double>;

/// Collective work of the ranks; returns the result of this rank.
using Work = std::function<Words(Ranks& ranks)>;

template <class Values>
void Append(const Values& values, Words& words)
{
  for (const auto& value : values)
  {
    words.push_back(static_cast<double>(value));
  }
}

Words WordsOf(const Mesh& mesh)
{
  Words words;
  Append(mesh.Points, words);
  Append(mesh.PointIds, words);
  Append(mesh.Elements, words);
  Append(mesh.ElementIds, words);
  Append(mesh.Material, words);
  Append(mesh.Fragment, words);
  Append(mesh.GeometryId, words);
  return words;
}

/// Returns work that meshes a field on a grid cut in three.
Work Meshing(const MeshCase& c, const MeshOptions& options, MeshMaker make)
{
  const std::vector<IndexBox> boxes =
    CutBaseBox(c.Grid, options.Levels.Refinements, Count, options.Levels.Refinements ? 0 : -1);
  return [=](Ranks& ranks)
  {
    const CartesianGrid grid = MakeRankGrid(c.Grid, boxes[ranks.Rank()], LayersFor(options.Levels));
    RankRuntime runtime(ranks);
    MeshReport report;
    return WordsOf(make(grid, CopyToLocal(c.Grid, c.Fractions, grid), options, runtime, report));
  };
}

/// Returns work that makes a mesh and transfers state to it.
Work Carrying(const MeshCase& c, MeshMaker make)
{
  const std::vector<IndexBox> boxes = CutBox(c.Grid.Global(), Count);
  return [=](Ranks& ranks)
  {
    class Places : public StateCellValues
    {
      void Read(const Index3& cell, int material, double* values) const override
      {
        values[0] = 1.0 + static_cast<double>(cell[0] + material);
        values[1] = static_cast<double>(cell[1] - cell[2]);
      }
    };
    const CartesianGrid grid = MakeRankGrid(c.Grid, boxes[ranks.Rank()]);
    const FractionField fractions = CopyToLocal(c.Grid, c.Fractions, grid);
    RankRuntime runtime(ranks);
    MeshReport report;
    const Mesh mesh = make(grid, fractions, MeshOptions(), runtime, report);
    const Places values;
    const TransferredState state = TransferState(mesh,
      { grid, fractions, values, { { StateKind::PerVolume, 1, -1 }, { StateKind::PerMass, 1, -1 } },
        0, 2, true },
      runtime);
    Words words;
    Append(state.Values[0], words);
    Append(state.Values[1], words);
    Append(state.Input[1], words);
    return words;
  };
}

/// Returns work that removes small regions and smooths labels, the steps before meshing.
Work Clearing()
{
  const CartesianGrid whole = MakeUnitGrid(12, 10, 11);
  const FractionField field = MakeRandomLabels(whole, 3, 0, 5);
  const std::vector<IndexBox> boxes = CutBox(whole.Global(), Count);
  return [=](Ranks& ranks)
  {
    const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
    RankRuntime runtime(ranks);
    FractionField mine = CopyToLocal(whole, field, grid);
    const Partition partition(grid, ranks);
    RemoveSmallRegions(grid, 3, 0.5, partition, mine);
    SmoothLabels(grid, 2, partition, runtime, mine);
    Words words;
    ForCells(grid.Local(),
      [&](const Index3& p)
      {
        const Index cell = grid.Linear(p);
        words.push_back(mine.IsMixed(cell) ? mine.Parts(cell).begin()->Fraction : mine.Label(cell));
      });
    return words;
  };
}

/// Result of the work on each rank.
struct Outcome
{
  std::vector<std::string> Messages{ Count };
  std::vector<Words> Made{ Count };
  std::vector<std::int64_t> Calls = std::vector<std::int64_t>(Count);
  bool HasStruck = false;
};

struct FaultAt
{
  int Rank;
  std::int64_t Call;
  FaultKind Kind;
};

/// Runs the work on all ranks, first with the fault, if there is one, then without.
std::array<Outcome, 2> RunWith(const Work& work, const FaultAt& fault)
{
  std::array<Outcome, 2> outcomes;
  RunOnRanks(Count,
    [&](Ranks& ranks)
    {
      const int rank = ranks.Rank();
      for (Outcome& outcome : outcomes)
      {
        const bool isFaulty = &outcome == &outcomes[0] && rank == fault.Rank;
        SetFault(isFaulty ? fault.Call : -1, isFaulty ? fault.Kind : FaultKind::Once);
        try
        {
          WorkTogether(ranks, [&] { outcome.Made[rank] = work(ranks); });
          outcome.Calls[rank] = ClearFault();
        }
        catch (const InputError& error)
        {
          outcome.Calls[rank] = ClearFault();
          outcome.Messages[rank] = error.what();
          outcome.Made[rank].clear();
        }
        if (isFaulty)
        {
          outcome.HasStruck = HasStruck();
        }
      }
    });
  return outcomes;
}

struct FaultCase
{
  std::string Name;
  unsigned Faults; // number of faults to try
  std::function<Work()> Make;
};

void PrintTo(const FaultCase& c, std::ostream* out)
{
  *out << c.Name;
}

MeshOptions OptionsFor(TetMethod method, int refinements, bool fineInterfaces)
{
  MeshOptions options;
  options.Method = method;
  options.Levels.Refinements = refinements;
  options.Levels.FineInterfaces = fineInterfaces;
  return options;
}

std::vector<FaultCase> ListCases()
{
  const auto meshing = [](const char* name, const MeshOptions& options, MeshMaker make)
  { return [=] { return Meshing(MakeMeshCase(name), options, make); }; };
  std::vector<FaultCase> cases{ { "hexes", 30, meshing("sphere 8", MeshOptions(), MakeHexMesh) },
    { "clearing", 60, Clearing },
    { "state", 30, [] { return Carrying(MakeMeshCase("sphere 8"), MakeHexMesh); } },
    { "state_of_tets", 12, [] { return Carrying(MakeMeshCase("sphere 8"), MakeTetMesh); } },
    { "hexes_of_3_materials", 6, meshing("ball of 3 sectors", MeshOptions(), MakeHexMesh) },
    { "cells", 12, meshing("sphere 8", OptionsFor(TetMethod::Cells, 0, true), MakeTetMesh) },
    { "lattice", 12, meshing("sphere 8", OptionsFor(TetMethod::Lattice, 0, true), MakeTetMesh) },
    { "refined_hexes", 12,
      meshing("half sphere", OptionsFor(TetMethod::Cells, 1, true), MakeHexMesh) },
    { "crossing_hexes", 12,
      meshing("half sphere", OptionsFor(TetMethod::Cells, 1, false), MakeHexMesh) },
    { "refined_lattice", 12,
      meshing("half sphere", OptionsFor(TetMethod::Lattice, 1, true), MakeTetMesh) } };
  if (HasTetGen())
  {
    cases.push_back(
      { "tetgen", 12, meshing("sphere 8", OptionsFor(TetMethod::TetGen, 0, true), MakeTetMesh) });
  }
  return cases;
}

class FaultTest : public ::testing::TestWithParam<FaultCase>
{
};

} // namespace

TEST_P(FaultTest, AllRanksReportTheSame)
{
  const Work work = this->GetParam().Make();
  const Outcome good = RunWith(work, { -1, 0, FaultKind::Once })[1];
  int struck = 0, failed = 0;
  const std::vector<unsigned> seeds = ListSeeds(this->GetParam().Faults);
  for (const unsigned seed : seeds)
  {
    std::mt19937 random(seed);
    FaultAt fault{ static_cast<int>(seed % Count), 0,
      seed / Count % 2 ? FaultKind::Lasting : FaultKind::Once };
    fault.Call = static_cast<std::int64_t>(
      static_cast<double>(random()) / 4294967296.0 * static_cast<double>(good.Calls[fault.Rank]));
    SCOPED_TRACE("seed " + std::to_string(seed) + ": call " + std::to_string(fault.Call) + " of " +
      std::to_string(good.Calls[fault.Rank]) + " on rank " + std::to_string(fault.Rank) +
      (fault.Kind == FaultKind::Once ? "" : ", lasting"));
    const auto [first, second] = RunWith(work, fault);
    struck += first.HasStruck;
    failed += !first.Messages[0].empty();
    for (int rank = 0; rank < Count; ++rank)
    {
      EXPECT_EQ(first.Messages[rank], first.Messages[0]);
      EXPECT_TRUE(!first.Messages[rank].empty() || first.Made[rank] == good.Made[rank]);
      EXPECT_EQ(second.Messages[rank], "");
      EXPECT_EQ(second.Made[rank], good.Made[rank]);
    }
  }
  std::printf("%s: %lld calls, %zu faults, %d struck, %d reported on all ranks\n",
    this->GetParam().Name.c_str(), static_cast<long long>(good.Calls[0]), seeds.size(), struck,
    failed);
  EXPECT_EQ(struck, static_cast<int>(seeds.size()));
}

INSTANTIATE_TEST_SUITE_P(Cases, FaultTest, ::testing::ValuesIn(ListCases()),
  [](const ::testing::TestParamInfo<FaultCase>& info) { return info.param.Name; });
