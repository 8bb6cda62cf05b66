/// Tables of the geometry by rank, and of the whole mesh.
#include "Geometry/GatherTables.h"

#include "GluedChecks.h"
#include "RankMeshes.h"
#include "SharpCases.h"

#include <gtest/gtest.h>

#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct RankCase
{
  const char* Name;
  CartesianGrid Grid;
  FractionField Fractions;
  MeshOptions Options;
  MeshMaker Make = MakeHexMesh;
};

/// Returns drops of one to eight cells at the places of a lattice, some at the sides of the domain
/// and some in contact.
FractionField MakeSpray(const CartesianGrid& grid, Index spacing)
{
  return MakeLabels(grid, 2,
    [spacing](const Index3& cell)
    {
      std::uint64_t site = 0;
      bool isInside = true;
      for (int a = 0; a < 3; ++a)
      {
        site = (site + static_cast<std::uint64_t>(cell[a] / spacing) + 1) * 0x9e3779b97f4a7c15u;
        site ^= site >> 29;
      }
      for (int a = 0; a < 3; ++a)
      {
        const auto first = static_cast<Index>(site >> (8 + 4 * a) & 1);
        const auto size = static_cast<Index>(1 + (site >> (20 + 4 * a) & 1));
        const Index at = cell[a] % spacing;
        isInside = isInside && at >= first && at < first + size;
      }
      return isInside ? static_cast<int>(1 + (site >> 40 & 1)) : 0;
    });
}

std::vector<RankCase> MakeCases()
{
  std::vector<RankCase> cases;
  const auto add = [&cases](const char* name, const CartesianGrid& grid, FractionField field,
                     MeshOptions options = {}, MeshMaker make = MakeHexMesh) {
    cases.push_back({ name, grid, std::move(field), options, make });
  };
  MeshOptions stairs, filled, sharp;
  stairs.StairStep = true;
  filled.StairStep = filled.MeshVoid = true;
  sharp.SharpEdges = SharpEdgeMode::On;
  const CartesianGrid drops = MakeUnitGrid(15, 13, 12);
  add("spray", drops, MakeSpray(drops, 3), stairs);
  add("spray in meshed void", drops, MakeSpray(drops, 3), filled);
  const MeshCase grains = MakePolycrystalCase(20, 14);
  add("polycrystal", grains.Grid, grains.Fractions);
  add("polycrystal of tets", grains.Grid, grains.Fractions, {}, MakeTetMesh);
  const CartesianGrid torus = MakePeriodicGrid({ { 8, 6, 7 } }, { { true, true, false } });
  add("periodic", torus, MakeRandomPeriodic(torus, 3, 0, 5));
  add("periodic, meshed void", torus, MakeRandomPeriodic(torus, 2, 0, 6), filled);
  const SharpCase cube = MakeSharpCase("cube A in matrix", 14);
  add("cube with edges", cube.Grid, cube.Fractions, sharp);
  return cases;
}

/// Counts the bytes that a stage gathers and reduces.
class CountedRuntime : public RankRuntime
{
public:
  explicit CountedRuntime(ThreadRanks& ranks) : RankRuntime(ranks), TheRanks(ranks) {}
  void Progress(double, const char* stage) override
  {
    const MessageRanks::Traffic& now = this->TheRanks.Sent();
    if (this->IsIn)
    {
      this->Gathered += now.GatheredBytes - this->Before.GatheredBytes;
      this->Reduced += now.ReducedBytes - this->Before.ReducedBytes;
    }
    this->IsIn = std::string(stage) == "Finding geometry";
    this->Before = now;
  }
  std::int64_t Gathered = 0, Reduced = 0;

private:
  ThreadRanks& TheRanks;
  MessageRanks::Traffic Before;
  bool IsIn = false;
};

} // namespace

TEST(GatherTables, RowsOfRanksAreThoseOfOneRank)
{
  for (const RankCase& c : MakeCases())
  {
    SCOPED_TRACE(c.Name);
    Runtime alone;
    MeshReport report;
    const GeometryTables whole = c.Make(c.Grid, c.Fractions, c.Options, alone, report).Tables;
    EXPECT_TRUE(whole.HasAllSurfaces && whole.HasAllCurves);
    const RankMesh expected = MakeAlone(c.Grid, c.Fractions, c.Options, c.Make);
    for (int count : { 2, 3, 5, 8, 27 })
    {
      SCOPED_TRACE(count);
      std::mutex lock;
      std::size_t least = whole.SurfaceVolumes.size();
      const auto gather = [&](Runtime& runtime, Mesh& mesh, MeshReport&)
      {
        GeometryTables tables = mesh.Tables;
        GatherSurfaceTables(runtime.Group(), tables);
        GatherCurveTables(runtime.Group(), tables);
        const std::lock_guard<std::mutex> guard(lock);
        EXPECT_TRUE(tables == whole);
        EXPECT_FALSE(mesh.Tables.HasAllSurfaces);
        EXPECT_EQ(mesh.Tables.SurfaceIds.size(), mesh.Tables.SurfaceVolumes.size());
        least = std::min(least, mesh.Tables.SurfaceIds.size());
      };
      const RankMesh made =
        MakeOnRanks(c.Grid, c.Fractions, CutBox(c.Grid.Domain(), count), c.Options, c.Make, gather);
      EXPECT_EQ(FindDifference(made, expected), "");
      EXPECT_TRUE(
        count < 8 || whole.SurfaceVolumes.size() < 20 || least < whole.SurfaceVolumes.size() / 2);
    }
  }
}

TEST(GatherTables, BytesDoNotGrowWithTheNumberOfDrops)
{
  std::vector<std::array<std::int64_t, 2>> bytes;
  Index before = 0;
  for (const Index3& cells : { Index3{ { 12, 12, 12 } }, Index3{ { 30, 27, 27 } } })
  {
    const CartesianGrid whole = MakeUnitGrid(cells[0], cells[1], cells[2]);
    const FractionField field = MakeSpray(whole, 3);
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), 8);
    std::mutex lock;
    Index drops = 0;
    std::array<std::int64_t, 2> most{};
    RunOnRanks(8,
      [&](ThreadRanks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        CountedRuntime runtime(ranks);
        MeshOptions options;
        options.StairStep = options.ComputeQuality = true;
        MeshReport report;
        MakeHexMesh(grid, CopyToLocal(whole, field, grid), options, runtime, report);
        const std::lock_guard<std::mutex> guard(lock);
        drops = report.NumberOfFragments;
        most = { { std::max(most[0], runtime.Gathered), std::max(most[1], runtime.Reduced) } };
      });
    EXPECT_GT(drops, 8 * before);
    before = drops;
    bytes.push_back(most);
  }
  EXPECT_GT(before, 500);
  EXPECT_EQ(bytes[0], bytes[1]);
  EXPECT_GT(bytes[0][1], 0);
}
