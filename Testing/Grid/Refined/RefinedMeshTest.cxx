/// Meshes with coarser cells away from interfaces: valid, conforming, and equal to the
/// uniform grid's mesh at interfaces.
#include "RankMeshes.h"
#include "RefinedChecks.h"
#include "Sweep.h"

#include "Fractions/RefineCells.h"
#include "Octree/RefinedGrid.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MeshOptions Coarsened(int refinements)
{
  MeshOptions options;
  options.Levels.Refinements = refinements;
  return options;
}

void ExpectValid(const Mesh& mesh)
{
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(FindFragmentProblem(mesh), "");
  EXPECT_GT(SmallestCornerDeterminant(mesh), 0.0);
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
}

struct CoarseCase
{
  std::string Name;
  int Refinements;
  bool MeshVoid;
};

void PrintTo(const CoarseCase& c, std::ostream* out)
{
  *out << c.Name << ", " << c.Refinements << " refinements";
}

class CoarsenedShapes : public ::testing::TestWithParam<CoarseCase>
{
};

} // namespace

TEST_P(CoarsenedShapes, InterfacesAreThoseOfTheUniformMesh)
{
  const MeshCase c = MakeMeshCase(this->GetParam().Name);
  Runtime runtime;
  MeshReport report, fineReport;
  MeshOptions options = Coarsened(this->GetParam().Refinements);
  options.MeshVoid = this->GetParam().MeshVoid;
  const Mesh mesh = MakeHexMesh(c.Grid, c.Fractions, options, runtime, report);
  options.Levels = LevelPlan();
  const Mesh fine = MakeHexMesh(c.Grid, c.Fractions, options, runtime, fineReport);
  ExpectValid(mesh);
  EXPECT_EQ(InterfacePoints(mesh), InterfacePoints(fine));
  EXPECT_EQ(report.NumberOfFragments, fineReport.NumberOfFragments);
  EXPECT_EQ(report.NumberOfSurfaces, fineReport.NumberOfSurfaces);
  EXPECT_EQ(report.NumberOfCurves, fineReport.NumberOfCurves);
  EXPECT_EQ(report.NumberOfVertices, fineReport.NumberOfVertices);
  EXPECT_EQ(report.MeshVolume, fineReport.MeshVolume);
  EXPECT_GT(report.MinimumScaledJacobian, std::min(0.605, fineReport.MinimumScaledJacobian - 1e-3));
  for (int m = 1; m < static_cast<int>(report.MeshVolume.size()); ++m)
  {
    EXPECT_NEAR(MeasureVolume(mesh, m) / report.MeshVolume[m], 1.0, 1e-9);
  }
  std::printf("%-24s %d refinements: %8zu hexes of %8zu, %7lld in transitions, min SJ %.3f (%.3f), "
              "mean %.3f (%.3f)\n",
    c.Name.c_str(), this->GetParam().Refinements, mesh.ElementIds.size(), fine.ElementIds.size(),
    static_cast<long long>(report.TransitionCells), report.MinimumScaledJacobian,
    fineReport.MinimumScaledJacobian, report.MeanScaledJacobian, fineReport.MeanScaledJacobian);
}

INSTANTIATE_TEST_SUITE_P(Cases, CoarsenedShapes,
  ::testing::Values(CoarseCase{ "sphere 8", 1, true }, CoarseCase{ "sphere 32", 1, true },
    CoarseCase{ "half sphere", 1, true }, CoarseCase{ "half sphere", 2, true },
    CoarseCase{ "ball and plate", 1, true }, CoarseCase{ "ball and plate", 3, true },
    CoarseCase{ "ball of 3 sectors", 2, true }, CoarseCase{ "torus", 2, true },
    CoarseCase{ "plate 5 thick", 3, true }, CoarseCase{ "polycrystal", 1, false }),
  [](const ::testing::TestParamInfo<CoarseCase>& info)
  {
    std::string name = info.param.Name + "_" + std::to_string(info.param.Refinements) +
      (info.param.MeshVoid ? "_void" : "");
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

/// Transitions of two levels are adjacent around this ball.
TEST(CoarsenedBall, HexesAreGoodWhereLevelsMeet)
{
  const CartesianGrid grid = MakeUnitGrid(48);
  MeshOptions options = Coarsened(2);
  options.MeshVoid = true;
  Runtime runtime;
  MeshReport report;
  MakeHexMesh(grid, FractionsOfShapes(grid, { MakeSphere(1, { { 24.1, 24.2, 24.3 } }, 17.28) }),
    options, runtime, report);
  EXPECT_GT(report.TransitionCells, 0);
  EXPECT_GT(report.MinimumScaledJacobian, 0.605);
}

/// Five parts of one sweep.
class RandomFamilies : public ::testing::TestWithParam<unsigned>
{
};

TEST_P(RandomFamilies, MeshIsValid)
{
  double worst = 1.0;
  for (unsigned seed : ListSeeds(50, this->GetParam(), 5))
  {
    SCOPED_TRACE(seed);
    const int refinements = 1 + static_cast<int>(seed % 3 == 0);
    const Index n = refinements == 1 ? 16 : 24;
    const CartesianGrid grid = MakeUnitGrid(n, n + 4 * (seed % 3), n);
    MeshOptions options = Coarsened(refinements);
    options.MeshVoid = seed % 5 == 0;
    options.Levels.Families = MakeRandomFamilies(grid, refinements, .02 * (1 + seed % 4), seed);
    Runtime runtime;
    MeshReport report;
    const Mesh mesh =
      MakeHexMesh(grid, MakeBlockLabels(grid, refinements, seed), options, runtime, report);
    EXPECT_EQ(FindTopologyProblem(mesh), "");
    EXPECT_EQ(FindFragmentProblem(mesh), "");
    EXPECT_GT(SmallestCornerDeterminant(mesh), 0.0);
    worst = std::min(worst, report.MinimumScaledJacobian);
  }
  std::printf("smallest scaled Jacobian of random meshes: %.3f\n", worst);
  EXPECT_GT(worst, 0.51);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFamilies, ::testing::Range(0u, 5u));

namespace
{

/// Returns coordinates of n base cells, halved. Widths are random; neighbouring
/// widths differ by up to a factor.
std::vector<double> MakeGradedAxis(Index n, double factor, double width, std::mt19937& random)
{
  std::uniform_real_distribution<double> exponent(-1.0, 1.0);
  std::vector<double> x(1, 0.0);
  for (Index i = 0; i < n; ++i)
  {
    x.push_back(x.back() + width);
    width *= std::pow(factor, exponent(random));
  }
  return x;
}

CartesianGrid MakeGradedGrid(Index n, int refinements, unsigned seed)
{
  std::mt19937 random(seed);
  const double factor = seed % 2 == 0 ? 300.0 : 7.0, aspect = seed % 4 < 2 ? 1e4 : 100.0;
  std::uniform_real_distribution<double> exponent(0.0, 1.0);
  std::array<std::vector<double>, 3> x;
  for (std::vector<double>& axis : x)
  {
    axis = MakeGradedAxis(n, factor, std::pow(aspect, exponent(random)), random);
  }
  return CartesianGrid(HalveWidths(x, refinements));
}

} // namespace

/// More cells are refined where transitions of stretched cells cannot be
/// untangled or cut into tets.
TEST(StretchedFamilies, MeshIsValid)
{
  std::map<std::string, Index> added;
  for (unsigned seed : ListSeeds(4))
  {
    SCOPED_TRACE(seed);
    const int refinements = 1 + static_cast<int>(seed % 3 == 0);
    const CartesianGrid grid = MakeGradedGrid(refinements == 1 ? 8 : 6, refinements, seed);
    const FractionField field = MakeBlockLabels(grid, refinements, seed);
    for (const char* kind : { "hexes", "crossing", "Cells", "Lattice" })
    {
      SCOPED_TRACE(kind);
      const std::string name = kind;
      MeshOptions options = Coarsened(refinements);
      options.MeshVoid = true;
      options.Levels.FineInterfaces = name != "crossing";
      options.Method = name == "Lattice" ? TetMethod::Lattice : TetMethod::Cells;
      options.Levels.Families = MakeRandomFamilies(grid, refinements, .02 * (1 + seed % 4), seed);
      Runtime runtime;
      MeshReport report;
      const bool isHex = name == "hexes" || name == "crossing";
      const Mesh mesh = isHex ? MakeHexMesh(grid, field, options, runtime, report)
                              : MakeTetMesh(grid, field, options, runtime, report);
      EXPECT_EQ(FindTopologyProblem(mesh), "");
      EXPECT_TRUE(IsPositiveEverywhere(mesh));
      for (const MeshReport::Level& level : report.Levels)
      {
        added[name] += level.AddedForValidity;
      }
    }
  }
  for (const auto& kind : added)
  {
    std::printf("%s: %lld families added for validity\n", kind.first.c_str(),
      static_cast<long long>(kind.second));
    EXPECT_TRUE(kind.second > 0 || !IsWholeSweep());
  }
}

namespace
{

struct LevelRanks
{
  const char* Mesh;
  int Refinements, Ranks, Axis;
};

void PrintTo(const LevelRanks& c, std::ostream* out)
{
  *out << c.Mesh << ", " << c.Refinements << " refinements, " << c.Ranks << " ranks";
}

class RefinedRanks : public ::testing::TestWithParam<LevelRanks>
{
};

} // namespace

TEST_P(RefinedRanks, SameMesh)
{
  const LevelRanks& c = this->GetParam();
  const bool noise = std::string(c.Mesh) == "noise";
  const MeshCase shape = MakeMeshCase(noise ? "sphere 8" : c.Mesh);
  const CartesianGrid cube = MakeUnitGrid(24, 16, 32);
  const CartesianGrid& grid = noise ? cube : shape.Grid;
  const FractionField field = noise ? MakeBlockLabels(cube, c.Refinements, 3) : shape.Fractions;
  MeshOptions options = Coarsened(c.Refinements);
  options.MeshVoid = true;
  if (noise)
  {
    options.Levels.Families = MakeRandomFamilies(grid, c.Refinements, .02, 7);
  }
  std::vector<IndexBox> boxes = CutBaseBox(grid, c.Refinements, c.Ranks, c.Axis);
  if (c.Ranks == 3)
  {
    boxes.insert(boxes.begin() + 1, IndexBox());
  }
  CompareWithSerial(grid, field, { boxes }, options);
}

INSTANTIATE_TEST_SUITE_P(Cases, RefinedRanks,
  ::testing::Values(LevelRanks{ "ball and plate", 1, 2, -1 },
    LevelRanks{ "ball and plate", 2, 8, -1 }, LevelRanks{ "ball and plate", 3, 4, -1 },
    LevelRanks{ "half sphere", 1, 3, 0 }, LevelRanks{ "noise", 1, 8, -1 },
    LevelRanks{ "noise", 2, 4, 2 }, LevelRanks{ "noise", 3, 3, -1 }));
