/// Cases with figures in Sculpt's publications and logs, rebuilt from
/// exact shapes: the counts agree.
#include "MeshCases.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

CartesianGrid MakeBoxGrid(const Vector3& lower, const Vector3& upper, const Index3& cells)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= cells[a]; ++i)
    {
      x[a].push_back(lower[a] + (upper[a] - lower[a]) * i / cells[a]);
    }
  }
  return CartesianGrid(x);
}

CartesianGrid MakeCube(double half, Index cells)
{
  return MakeBoxGrid(
    { { -half, -half, -half } }, { { half, half, half } }, { { cells, cells, cells } });
}

struct Result
{
  Mesh Hexes;
  MeshReport Report;
};

Result MeshShapes(const char* name, const CartesianGrid& grid, const std::vector<Shape>& shapes)
{
  Result result;
  Runtime runtime;
  result.Hexes =
    MakeHexMesh(grid, FractionsOfShapes(grid, shapes), MeshOptions(), runtime, result.Report);
  std::printf("%s: %zu hexes, %zu nodes, scaled Jacobian %.3f / %.3f, volume off %.5f %%\n", name,
    result.Hexes.ElementIds.size(), result.Hexes.PointIds.size(),
    result.Report.MinimumScaledJacobian, result.Report.MeanScaledJacobian,
    100.0 * (MeasureVolume(result.Hexes, 1) / result.Report.TargetVolume[1] - 1.0));
  EXPECT_EQ(FindTopologyProblem(result.Hexes), "");
  EXPECT_TRUE(IsPositiveEverywhere(result.Hexes));
  return result;
}

const Vector3 Origin{ { 0.0, 0.0, 0.0 } };

} // namespace

TEST(PublishedCases, ConcentricSpheres)
{
  const Result r = MeshShapes(
    "two spheres", MakeCube(16.0, 16), { MakeSphere(1, Origin, 5.0), MakeSphere(2, Origin, 10.0) });
  EXPECT_EQ(r.Hexes.ElementIds.size(), 1224u);
  EXPECT_GE(r.Report.MinimumScaledJacobian, 0.50);
}

TEST(PublishedCases, Capsule)
{
  const CartesianGrid grid = MakeBoxGrid({ { -1.349116, -1.305064, -1.305064 } },
    { { 3.349116, 1.305064, 1.305064 } }, { { 36, 20, 20 } });
  const Result r = MeshShapes("capsule", grid,
    { MakeSphere(1, Origin, 1.0), MakeSphere(1, { { 2.0, 0.0, 0.0 } }, 1.0),
      MakeCylinder(1, { { 1.0, 0.0, 0.0 } }, 1.0, 2.0, { { 0.0, 90.0, 0.0 } }) });
  EXPECT_EQ(r.Hexes.ElementIds.size(), 6832u);
  EXPECT_EQ(r.Hexes.PointIds.size(), 7941u);
  EXPECT_GE(r.Report.MinimumScaledJacobian, 0.60);
}

TEST(PublishedCases, UnitSphere)
{
  const Result r =
    MeshShapes("unit sphere", MakeCube(1.240409, 26), { MakeSphere(1, Origin, 1.0) });
  EXPECT_EQ(r.Hexes.ElementIds.size(), 6768u);
  EXPECT_EQ(r.Hexes.PointIds.size(), 7827u);
  EXPECT_GE(r.Report.MinimumScaledJacobian, 0.65);
  EXPECT_GE(r.Report.MeanScaledJacobian, 0.90);
}

TEST(PublishedCases, HalfSphereAtThreeResolutions)
{
  const std::pair<Index, std::size_t> counts[] = { { 10, 352 }, { 20, 2048 }, { 40, 13288 } };
  for (const auto& count : counts)
  {
    const Result r = MeshShapes(
      "sphere of radius .5", MakeCube(0.75, count.first), { MakeSphere(1, Origin, 0.5) });
    EXPECT_EQ(r.Hexes.ElementIds.size(), count.second);
    const double exact = 4.0 / 3.0 * M_PI * 0.125;
    EXPECT_NEAR(MeasureVolume(r.Hexes, 1), exact, 1e-4 * exact);
  }
}

TEST(PublishedCases, SphereInItsOwnBox)
{
  const Result r =
    MeshShapes("sphere in its box", MakeCube(1.0, 4), { MakeSphere(1, Origin, 1.0) });
  EXPECT_EQ(r.Hexes.ElementIds.size(), 80u);
  EXPECT_GE(r.Report.MinimumScaledJacobian, 0.6);
}
