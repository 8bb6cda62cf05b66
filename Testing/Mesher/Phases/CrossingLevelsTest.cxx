/// Meshes whose interfaces pass through cells of several levels (LevelPlan::FineInterfaces false).
#include "RankMeshes.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexCoefficients.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MeshOptions CrossingOptions(int refinements)
{
  MeshOptions options;
  options.Levels.Refinements = refinements;
  options.Levels.FineInterfaces = false;
  return options;
}

struct CrossingCase
{
  std::string Name;
  int Refinements;
  double Share; // refined part of the domain along x
  bool MeshVoid;
  /// Bounds: least scaled Jacobian of hexes or dihedral angle of tets; distance in base cells.
  double LeastQuality, LargestDistance;
  double VolumeError = 1e-6; // largest relative one of a material, tets
};

void PrintTo(const CrossingCase& c, std::ostream* out)
{
  *out << c.Name << ", " << c.Refinements << " refinements, share " << c.Share;
}

/// Refines a part of the domain.
MeshOptions OptionsOf(const CrossingCase& p, const MeshCase& c)
{
  MeshOptions options = CrossingOptions(p.Refinements);
  options.MeshVoid = p.MeshVoid;
  options.Levels.Families = RefineBelow(c.Grid, p.Refinements, p.Share);
  return options;
}

class CrossingShapes : public ::testing::TestWithParam<CrossingCase>
{
};

} // namespace

TEST_P(CrossingShapes, MeshIsValidAndNear)
{
  const CrossingCase& p = this->GetParam();
  const MeshCase c = MakeMeshCase(p.Name);
  Runtime runtime;
  MeshOptions options = OptionsOf(p, c);
  const MeshFigures f = MeasureCase(c, options, runtime);
  EXPECT_EQ(FindTopologyProblem(f.Result), "");
  EXPECT_EQ(FindFragmentProblem(f.Result), "");
  EXPECT_TRUE(IsPositiveEverywhere(f.Result));
  const Index requested = static_cast<Index>(options.Levels.Families.back().size());
  const MeshReport::Level& last = f.Report.Levels[p.Refinements - 1];
  EXPECT_EQ(last.Families - last.AddedForBalance - last.AddedForValidity, requested);
  EXPECT_EQ(last.AddedForValidity > 0, f.Report.LevelRounds > 0);
  // Distances are in base cells: most of these interfaces lie there.
  const double width = 1 << p.Refinements;
  EXPECT_GT(f.Report.MinimumScaledJacobian, p.LeastQuality);
  EXPECT_LT(f.Distance.Largest / width, p.LargestDistance);
  EXPECT_LT(f.Distance.RootMeanSquare / width, 0.045);
  std::printf("%s| transitions %lld, flips %lld, rounds %d\n", FormatFigures(p.Name, f).c_str(),
    static_cast<long long>(f.Report.TransitionCells), static_cast<long long>(f.Report.FlippedCells),
    f.Report.LevelRounds);
}

namespace
{

class CrossingTets : public ::testing::TestWithParam<CrossingCase>
{
};

} // namespace

/// Lattice makes the tets of Cells, TetGen has fine interfaces.
TEST_P(CrossingTets, AreValidAndNear)
{
  const CrossingCase& p = this->GetParam();
  const MeshCase c = MakeMeshCase(p.Name);
  Runtime runtime;
  MeshOptions options = OptionsOf(p, c);
  const MeshFigures f = MeasureCase(c, options, runtime, MakeTetMesh);
  const MeshReport& report = f.Report;
  const Mesh& mesh = f.Result;
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(FindFragmentProblem(mesh), "");
  EXPECT_GT(SmallestCornerDeterminant(mesh), 0.0);
  EXPECT_GE(report.MinimumDihedralAngle, p.LeastQuality);
  EXPECT_LT(f.VolumeError, p.VolumeError);
  const double width = 1 << p.Refinements; // of base cells
  EXPECT_LT(f.Distance.Largest / width, p.LargestDistance);
  EXPECT_LT(f.Distance.RootMeanSquare / width, 0.06); // Cells has up to .09 of its cells
  MeshReport ofCells;
  options.Method = TetMethod::Cells;
  EXPECT_TRUE(AreEqual(mesh, MakeTetMesh(c.Grid, c.Fractions, options, runtime, ofCells)));
  options.Levels.FineInterfaces = true;
  const MeshFigures fine = MeasureCase(c, options, runtime, MakeTetMesh);
  EXPECT_LT(f.Elements, fine.Elements);
  std::printf("%-18s %d refinements: %8zu tets of %8zu, dihedral %.1f-%.1f (%.1f-%.1f), distance "
              "%.3f, rms %.4f (%.3f, %.4f)\n",
    p.Name.c_str(), p.Refinements, f.Elements, fine.Elements, report.MinimumDihedralAngle,
    report.MaximumDihedralAngle, fine.Report.MinimumDihedralAngle, fine.Report.MaximumDihedralAngle,
    f.Distance.Largest / width, f.Distance.RootMeanSquare / width, fine.Distance.Largest,
    fine.Distance.RootMeanSquare);
}

/// With cells as hexes and no inserted layers, volumes equal the volumes of leaves and transitions.
TEST(CrossingStairs, MeshIsConforming)
{
  const MeshCase c = MakeMeshCase("ball and plate");
  Runtime runtime;
  MeshReport report;
  MeshOptions options = CrossingOptions(1);
  options.StairStep = true;
  options.Levels.Families = RefineBelow(c.Grid, 1, .5);
  const Mesh mesh = MakeHexMesh(c.Grid, c.Fractions, options, runtime, report);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(FindFragmentProblem(mesh), "");
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
  for (int m = 1; m <= 2; ++m)
  {
    EXPECT_NEAR(MeasureVolume(mesh, m) / report.MeshVolume[m], 1.0, 1e-9);
  }
  std::size_t facets = 0;
  for (std::size_t f = 0; f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    facets += mesh.Surfaces.DomainSide[f] < 0;
  }
  EXPECT_GT(facets, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Cases, CrossingShapes,
  ::testing::Values(CrossingCase{ "sphere 32", 1, 0.0, false, .66, .04 },
    CrossingCase{ "sphere 32", 1, 0.5, false, .6, .15 },
    CrossingCase{ "sphere 32", 1, 0.5, true, .54, .35 },
    CrossingCase{ "polycrystal", 2, 0.6, false, .47, .45 },
    CrossingCase{ "ball and plate", 1, 0.5, true, .53, .35 },
    CrossingCase{ "ball of 3 sectors", 2, 0.6, false, .48, .2 },
    CrossingCase{ "half sphere", 1, 0.5, true, .6, .2 },
    CrossingCase{ "torus", 1, 0.5, true, .57, .2 }));

// In polycrystal, volumes of small grains in coarse cells are off, as those of hexes are.
INSTANTIATE_TEST_SUITE_P(Cases, CrossingTets,
  ::testing::Values(CrossingCase{ "sphere 32", 1, 0.0, false, 32.0, .37 },
    CrossingCase{ "sphere 32", 1, 0.5, false, 32.0, .37 },
    CrossingCase{ "sphere 32", 1, 0.5, true, 29.0, .37 },
    CrossingCase{ "polycrystal", 2, 0.6, false, 26.0, .5, .5 },
    CrossingCase{ "ball and plate", 1, 0.5, true, 29.0, .37 },
    CrossingCase{ "ball of 3 sectors", 2, 0.6, false, 30.0, .25 },
    CrossingCase{ "half sphere", 1, 0.5, true, 30.0, .2 },
    CrossingCase{ "torus", 1, 0.5, true, 30.0, .38 }));

namespace
{

/// A hex from a mesh of noise: all corners are positive, the scaled Jacobian is .46.
const std::array<Vector3, 8> TwistedHex{ { { { 14.7771, 11.2020, 0.9880 } },
  { { 16.0, 11.8259, 1.2524 } }, { { 14.6772, 11.5539, 1.1012 } }, { { 16.0, 11.4633, 1.1742 } },
  { { 14.9468, 11.0452, 1.1155 } }, { { 16.0, 11.4252, 0.7148 } }, { { 14.7581, 11.3092, 1.2542 } },
  { { 16.0, 11.3650, 0.9639 } } } };

/// Returns the Jacobian determinant of the trilinear map at a place in the unit cube.
double JacobianAt(const std::array<Vector3, 8>& x, const Vector3& at)
{
  std::array<Vector3, 3> d{};
  for (int c = 0; c < 8; ++c)
  {
    for (int a = 0; a < 3; ++a)
    {
      const int b = (a + 1) % 3, e = (a + 2) % 3;
      const double weight = (c >> a & 1 ? 1.0 : -1.0) * (c >> b & 1 ? at[b] : 1.0 - at[b]) *
        (c >> e & 1 ? at[e] : 1.0 - at[e]);
      d[a] = d[a] + weight * x[c];
    }
  }
  return Dot(d[0], Cross(d[1], d[2]));
}

double SmallestJacobianAt(const std::array<Vector3, 8>& x, int steps)
{
  double smallest = 1e300;
  for (int n = 0; n < (steps + 1) * (steps + 1) * (steps + 1); ++n)
  {
    const auto at = [&](int i) { return 1.0 * (i % (steps + 1)) / steps; };
    smallest = std::min(smallest,
      JacobianAt(x, { { at(n), at(n / (steps + 1)), at(n / (steps + 1) / (steps + 1)) } }));
  }
  return smallest;
}

} // namespace

TEST(SmallestCoefficient, IsABound)
{
  std::array<Vector3, 8> cube;
  for (int c = 0; c < 8; ++c)
  {
    cube[c] = { { 2.0 * (c & 1), 3.0 * (c >> 1 & 1), 1.0 * (c >> 2) } };
  }
  EXPECT_DOUBLE_EQ(SmallestCoefficient(cube), 6.0);
  EXPECT_GT(SmallestJacobianAt(TwistedHex, 1), 0.0);
  EXPECT_LT(SmallestJacobianAt(TwistedHex, 8), 0.0);
  EXPECT_LT(SmallestCoefficient(TwistedHex), 0.0);
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial)
  {
    std::array<Vector3, 8> hex = cube;
    for (Vector3& x : hex)
    {
      for (double& value : x)
      {
        value += 0.6 * (random() / 4294967296.0 - 0.5);
      }
    }
    const double smallest = SmallestCoefficient(hex), sampled = SmallestJacobianAt(hex, 8);
    EXPECT_LE(smallest, sampled + 1e-12);
    EXPECT_GT(smallest, sampled - 1.0); // the bound is close
  }
}
