/// State is bitwise identical on any number of ranks and threads.
#include "RankMeshes.h"
#include "Shapes/ShapesScenes.h"
#include "State/StateCases.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Gives each cell and component its own value; densities differ by 1e6 between materials.
void FillNoise(const CartesianGrid& grid, const Index3& p, int material, double* values)
{
  for (int c = 0; c < 14; ++c)
  {
    const double wave =
      std::sin(12.9898 * static_cast<double>(grid.CellKey(p) % 9973) + 78.233 * c);
    values[c] = std::fabs(43758.5453 * wave - std::floor(43758.5453 * wave));
  }
  values[0] = (1.0 + values[0]) * (material == 1 ? 1.0 : 1e6);
  values[5] += 1.0;
}

struct TransferRankCase
{
  const char* Mesh;
  bool MeshVoid;
  int Refinements;
  bool FineInterfaces = true;
};

void PrintTo(const TransferRankCase& c, std::ostream* out)
{
  *out << c.Mesh;
}

class TransferRanks : public ::testing::TestWithParam<std::tuple<MeshMaker, TransferRankCase>>
{
};

std::string NameOfCase(
  const ::testing::TestParamInfo<std::tuple<MeshMaker, TransferRankCase>>& info)
{
  const TransferRankCase& c = std::get<1>(info.param);
  std::string name = (std::get<0>(info.param) == MakeHexMesh ? "Hexes_" : "Tets_") +
    std::string(c.Mesh) + (c.MeshVoid ? "_and_void" : "") + (c.Refinements > 0 ? "_refined" : "") +
    (c.FineInterfaces ? "" : "_crossing");
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

} // namespace

TEST_P(TransferRanks, SameBits)
{
  const TransferRankCase& what = std::get<1>(this->GetParam());
  const bool noise = what.Mesh == std::string("noise");
  const bool patches = what.Mesh == std::string("patches");
  const bool plate = what.Mesh == std::string("thick plate");
  const CartesianGrid cube = MakeUnitGrid(12, 11, 13), uneven = MakeUnevenGrid(13);
  const MeshCase shape = MakeMeshCase(noise || patches || plate ? "sphere 8" : what.Mesh);
  const CartesianGrid& grid = noise || plate ? cube : patches ? uneven : shape.Grid;
  const FractionField field = noise ? MakeRandomLabels(cube, 3, 0, 5)
    : patches                       ? MakePatchyFractions(uneven, 3, 7)
    : plate
    ? FractionsOfShapes(cube, { MakePlate(1, { { 6.0, 5.5, 6.4 } }, { { 0.1, 0.2, 1.0 } }, 9.0) })
    : shape.Fractions;
  StateCase c{ grid, field, FillNoise };
  c.Quantities = MakeCodeQuantities();
  c.Density = 0;
  c.Make = std::get<0>(this->GetParam());
  c.Options.MeshVoid = what.MeshVoid;
  c.Options.Levels.Refinements = what.Refinements;
  c.Options.Levels.FineInterfaces = what.FineInterfaces;
  const StateOutcome alone = TransferAlone(c);
  EXPECT_EQ(FindTotalsProblem(c, alone), "");
  EXPECT_EQ(FindOutcomeDifference(TransferOnThreads(c), alone), "") << "threads";
  const auto cut = [&](int ranks, int axis)
  {
    return what.Refinements > 0 ? CutBaseBox(grid, what.Refinements, ranks, axis)
                                : CutBox(grid.Global(), ranks, axis);
  };
  std::vector<std::vector<IndexBox>> cuts{ cut(2, -1), cut(3, 0), cut(8, -1) };
  cuts[0].insert(cuts[0].begin() + 1, IndexBox());
  for (const std::vector<IndexBox>& boxes : cuts)
  {
    SCOPED_TRACE(std::to_string(boxes.size()) + " ranks");
    EXPECT_EQ(FindOutcomeDifference(TransferOnRanks(c, boxes), alone), "");
  }
}

/// Smoothing moves elements over more thin cells than a rank has ghost layers.
TEST(TransferThinCells, SameBits)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    double at = 0.0;
    for (int i = 0; i <= 20; ++i)
    {
      x[a].push_back(at);
      at += a == 0 && i >= 6 && i < 14 ? 0.01 : 1.0;
    }
  }
  const CartesianGrid grid(x);
  const double middle = 0.5 * x[0].back();
  const FractionField field =
    FractionsOfShapes(grid, { MakeSphere(1, { { middle, 10.1, 10.2 } }, 0.36 * x[0].back()) });
  for (MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    StateCase c{ grid, field, FillNoise };
    c.Quantities = MakeCodeQuantities();
    c.Density = 0;
    c.Make = make;
    const StateOutcome alone = TransferAlone(c);
    EXPECT_EQ(FindTotalsProblem(c, alone), "");
    for (int ranks : { 3, 8 })
    {
      EXPECT_EQ(
        FindOutcomeDifference(TransferOnRanks(c, CutBox(grid.Global(), ranks, 0)), alone), "")
        << ranks << " ranks";
    }
  }
}

/// Returns the most bytes that a rank gathers while the state of a spray is transferred.
/// @param drops  number of drops along each axis
std::int64_t CountGathered(Index drops)
{
  constexpr Index distance = 5; // of drops, in cells
  const CartesianGrid whole = MakeUnitGrid(distance * drops);
  std::vector<Shape> shapes;
  ForCells({ {}, { { drops, drops, drops } } },
    [&](const Index3& p)
    {
      const auto middle = [&](int a) { return static_cast<double>(distance * p[a]) + 2.6; };
      shapes.push_back(MakeSphere(1, { { middle(0), middle(1), middle(2) } }, 1.7));
    });
  const FractionField field = FractionsOfShapes(whole, shapes);
  StateCase c{ whole, field, FillNoise };
  c.Quantities = MakeCodeQuantities();
  c.Density = 0;
  c.Options.StairStep = true;
  const std::vector<IndexBox> boxes = CutBox(whole.Global(), 8);
  std::vector<std::int64_t> gathered(boxes.size());
  RunOnRanks(static_cast<int>(boxes.size()),
    [&](ThreadRanks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      const FractionField fractions = CopyToLocal(whole, field, grid);
      RankRuntime runtime(ranks);
      MeshReport report;
      const Mesh mesh = c.Make(grid, fractions, c.Options, runtime, report);
      const FunctionValues values(c, grid);
      const std::int64_t before = ranks.Sent().GatheredBytes;
      TransferState(mesh, { grid, fractions, values, c.Quantities, c.Density }, runtime);
      gathered[ranks.Rank()] = ranks.Sent().GatheredBytes - before;
    });
  return *std::max_element(gathered.begin(), gathered.end());
}

/// No rank learns of all drops.
TEST(TransferSpray, BytesGatheredDoNotDependOnTheDrops)
{
  const std::int64_t few = CountGathered(5);
  EXPECT_LT(few, 10000);
  EXPECT_EQ(CountGathered(10), few);
}

INSTANTIATE_TEST_SUITE_P(Cases, TransferRanks,
  ::testing::Combine(::testing::Values(MakeHexMesh, MakeTetMesh),
    ::testing::Values(TransferRankCase{ "sphere 8", false, 0 },
      TransferRankCase{ "sphere 16", true, 0 }, TransferRankCase{ "half sphere", false, 0 },
      TransferRankCase{ "sphere 16", false, 1 }, TransferRankCase{ "noise", false, 0 },
      TransferRankCase{ "thick plate", false, 0 }, TransferRankCase{ "patches", true, 0 })),
  NameOfCase);

INSTANTIATE_TEST_SUITE_P(Crossing, TransferRanks,
  ::testing::Combine(::testing::Values(MakeHexMesh, MakeTetMesh),
    ::testing::Values(TransferRankCase{ "sphere 16", false, 1, false })),
  NameOfCase);
