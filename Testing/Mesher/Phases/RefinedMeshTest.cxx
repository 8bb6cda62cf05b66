/// Meshes with coarser cells away from interfaces: valid, conforming, and equal to the
/// uniform grid's mesh at interfaces.
#include "RankMeshes.h"

#include <gtest/gtest.h>

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
  const double fewer = static_cast<double>(fine.ElementIds.size()) / mesh.ElementIds.size();
  EXPECT_GT(fewer, c.Name == "ball and plate" ? 1.2 : 0.99);
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
