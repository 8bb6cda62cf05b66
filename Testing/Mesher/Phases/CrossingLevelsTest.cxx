/// Meshes whose interfaces pass through cells of several levels (LevelPlan::FineInterfaces false).
#include "RankMeshes.h"
#include "RefinedChecks.h"
#include "Sweep.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexCoefficients.h"
#include "Octree/OctreeKeys.h"

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

/// Returns families of every level in the lower part of the domain along x; the box of each level
/// is shorter than the one before.
std::vector<std::vector<Index>> RefineBelow(
  const CartesianGrid& grid, int refinements, double share)
{
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= grid.Global().Upper[a]; i += Index(1) << refinements)
    {
      coordinates[a].push_back(grid.Coordinates(a)[i]);
    }
  }
  const CartesianGrid base(coordinates);
  const OctreeKeys lattice(base, refinements);
  std::vector<std::vector<Index>> families(refinements);
  for (int level = 0; level < refinements; ++level)
  {
    IndexBox box;
    for (int a = 0; a < 3; ++a)
    {
      box.Upper[a] = lattice.Families(level, a);
    }
    box.Upper[0] = static_cast<Index>(share * static_cast<double>(box.Upper[0])) - level;
    ForCells(box, [&](const Index3& q) { families[level].push_back(lattice.FamilyKey(level, q)); });
  }
  return families;
}

struct CrossingCase
{
  std::string Name;
  int Refinements;
  double Share; // refined part of the domain along x
  bool MeshVoid;
  double LeastJacobian, LargestDistance; // bounds; distance in base cells
};

void PrintTo(const CrossingCase& c, std::ostream* out)
{
  *out << c.Name << ", " << c.Refinements << " refinements, share " << c.Share;
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
  MeshOptions options = CrossingOptions(p.Refinements);
  options.MeshVoid = p.MeshVoid;
  options.Levels.Families = RefineBelow(c.Grid, p.Refinements, p.Share);
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
  EXPECT_GT(f.Report.MinimumScaledJacobian, p.LeastJacobian);
  EXPECT_LT(f.Distance.Largest / width, p.LargestDistance);
  EXPECT_LT(f.Distance.RootMeanSquare / width, 0.045);
  std::printf("%s| transitions %lld, flips %lld, rounds %d\n", FormatFigures(p.Name, f).c_str(),
    static_cast<long long>(f.Report.TransitionCells), static_cast<long long>(f.Report.FlippedCells),
    f.Report.LevelRounds);
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

namespace
{

/// Returns random labels, or fractions in which labels can change at almost no cost.
FractionField MakeNoise(const CartesianGrid& grid, bool isTies, unsigned seed)
{
  return isTies ? MakeNearTies(grid, seed % 2 == 0 ? 0.3 : 1.0, seed)
                : MakeRandomLabels(grid, 2, 0, seed);
}

/// Five parts of one sweep.
class CrossingFamilies : public ::testing::TestWithParam<unsigned>
{
};

} // namespace

TEST_P(CrossingFamilies, MeshIsValid)
{
  double worst = 1.0;
  int rounds = 0;
  Index transitions = 0;
  for (unsigned seed : ListSeeds(50, this->GetParam(), 5))
  {
    SCOPED_TRACE(seed);
    const int refinements = 1 + static_cast<int>(seed % 3 == 0);
    const Index n = 8 + 2 * (seed % 2);
    const CartesianGrid grid =
      refinements == 1 ? MakeUnitGrid(n, 8 + 2 * (seed % 3), 10) : MakeUnitGrid(8, 12, 12);
    MeshOptions options = CrossingOptions(refinements);
    options.MeshVoid = seed % 5 == 0;
    options.Levels.Families = MakeRandomFamilies(grid, refinements, .05 * (1 + seed % 4), seed);
    Runtime runtime;
    MeshReport report;
    const Mesh mesh =
      MakeHexMesh(grid, MakeNoise(grid, seed / 2 % 2 == 1, seed), options, runtime, report);
    EXPECT_EQ(FindTopologyProblem(mesh), "");
    EXPECT_EQ(FindFragmentProblem(mesh), "");
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
    worst = std::min(worst, report.MinimumScaledJacobian);
    rounds = std::max(rounds, report.LevelRounds);
    transitions += report.TransitionCells;
  }
  std::printf(
    "smallest scaled Jacobian of random meshes: %.3f, at most %d rounds, %lld transitions\n", worst,
    rounds, static_cast<long long>(transitions));
  EXPECT_GT(worst, 0.39);
  if (IsWholeSweep())
  {
    EXPECT_GT(transitions, 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CrossingFamilies, ::testing::Range(0u, 5u));

namespace
{

struct CrossingRanksCase
{
  const char* Mesh; ///< name of a case, or "labels" or "ties": noise
  int Refinements;
  Index3 Base; ///< number of base cells of noise
  int Ranks, Axis;
  unsigned Seed;
};

void PrintTo(const CrossingRanksCase& c, std::ostream* out)
{
  *out << c.Mesh << " " << c.Seed << ", " << c.Refinements << " refinements, " << c.Ranks
       << " ranks";
}

class CrossingRanks : public ::testing::TestWithParam<CrossingRanksCase>
{
};

} // namespace

/// Along one axis with three or more ranks, each rank has one or two base cells. The case of
/// three ranks adds one without cells.
TEST_P(CrossingRanks, SameMesh)
{
  const CrossingRanksCase& c = this->GetParam();
  const std::string name = c.Mesh;
  const bool isTies = name == "ties", isNoise = isTies || name == "labels";
  const MeshCase shape = MakeMeshCase(isNoise ? "sphere 8" : name);
  const CartesianGrid box = MakeUnitGrid(
    c.Base[0] << c.Refinements, c.Base[1] << c.Refinements, c.Base[2] << c.Refinements);
  const CartesianGrid& grid = isNoise ? box : shape.Grid;
  const FractionField field = isNoise ? MakeNoise(grid, isTies, c.Seed) : shape.Fractions;
  MeshOptions options = CrossingOptions(c.Refinements);
  options.MeshVoid = true;
  options.Levels.Families = isNoise
    ? MakeRandomFamilies(grid, c.Refinements, c.Refinements == 3 ? .05 : .1, c.Seed + 4)
    : RefineBelow(grid, c.Refinements, .5);
  std::vector<IndexBox> boxes = CutBaseBox(grid, c.Refinements, c.Ranks, c.Axis);
  if (c.Ranks == 3)
  {
    boxes.insert(boxes.begin() + 1, IndexBox());
  }
  CompareWithSerial(grid, field, { boxes }, options);
}

INSTANTIATE_TEST_SUITE_P(Cases, CrossingRanks,
  ::testing::Values(CrossingRanksCase{ "ball and plate", 1, { { 1, 1, 1 } }, 2, -1, 0 },
    CrossingRanksCase{ "ball and plate", 2, { { 1, 1, 1 } }, 8, -1, 0 },
    CrossingRanksCase{ "half sphere", 1, { { 1, 1, 1 } }, 3, 0, 0 },
    CrossingRanksCase{ "labels", 1, { { 4, 4, 5 } }, 8, -1, 3 },
    CrossingRanksCase{ "labels", 1, { { 3, 4, 5 } }, 5, 2, 7 },
    CrossingRanksCase{ "labels", 2, { { 3, 2, 4 } }, 4, 2, 3 },
    CrossingRanksCase{ "ties", 1, { { 5, 4, 4 } }, 3, 0, 5 },
    CrossingRanksCase{ "ties", 2, { { 3, 3, 4 } }, 2, -1, 5 },
    CrossingRanksCase{ "ties", 2, { { 3, 2, 4 } }, 4, 2, 9 },
    CrossingRanksCase{ "ties", 2, { { 3, 3, 2 } }, 8, -1, 11 },
    CrossingRanksCase{ "ties", 3, { { 3, 2, 3 } }, 3, 2, 3 },
    CrossingRanksCase{ "ties", 3, { { 2, 2, 3 } }, 2, 2, 4 }));

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
