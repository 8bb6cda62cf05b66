/// Tetrahedra with coarser cells away from interfaces: valid, conforming, and equal to the
/// uniform grid's mesh at interfaces.
#include "RankMeshes.h"
#include "RefinedChecks.h"
#include "Sweep.h"

#include "Octree/RefinedGrid.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double SmallestAngle = 15.0; // degrees, transitions without interfaces

MeshOptions OptionsOf(TetMethod method, int refinements)
{
  MeshOptions options;
  options.Method = method;
  options.Levels.Refinements = refinements;
  return options;
}

/// Returns the largest distance between points of equal ids, or a huge
/// value if a point lacks a partner.
double LargestDistance(
  const std::map<Index, std::array<double, 3>>& a, const std::map<Index, std::array<double, 3>>& b)
{
  double largest = a.size() == b.size() ? 0.0 : 1e300;
  for (const auto& point : a)
  {
    const auto other = b.find(point.first);
    for (int i = 0; i < 3; ++i)
    {
      const double apart = other == b.end() ? 1e300 : std::fabs(point.second[i] - other->second[i]);
      largest = std::max(largest, apart);
    }
  }
  return largest;
}

void ExpectValid(const Mesh& mesh)
{
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(FindFragmentProblem(mesh), "");
  EXPECT_GT(SmallestCornerDeterminant(mesh), 0.0);
}

/// Expects that the elements fill the whole domain if the void is meshed too.
void ExpectFull(const Mesh& mesh, const CartesianGrid& grid, int materials)
{
  double volume = 0.0, box = 1.0;
  for (int m = 0; m <= materials; ++m)
  {
    volume += MeasureVolume(mesh, m);
  }
  for (int a = 0; a < 3; ++a)
  {
    box *= grid.Coordinates(a).back() - grid.Coordinates(a).front();
  }
  EXPECT_NEAR(volume, box, 1e-9 * box);
}

struct CoarseCase
{
  TetMethod Method;
  std::string Name;
  int Refinements;
  bool MeshVoid;
};

void PrintTo(const CoarseCase& c, std::ostream* out)
{
  *out << NameOf(c.Method) << ", " << c.Name << ", " << c.Refinements << " refinements";
}

class CoarsenedTets : public ::testing::TestWithParam<CoarseCase>
{
};

std::vector<CoarseCase> ListCases()
{
  std::vector<CoarseCase> cases;
  for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice, TetMethod::TetGen })
  {
    if (method == TetMethod::TetGen && !HasTetGen())
    {
      continue;
    }
    cases.push_back({ method, "sphere 16", 1, true });
    cases.push_back({ method, "half sphere", 2, true });
    cases.push_back({ method, "ball of 3 sectors", 2, true });
    if (method != TetMethod::TetGen)
    {
      cases.push_back({ method, "sphere 8", 1, true });
      cases.push_back({ method, "sphere 32", 1, false });
      cases.push_back({ method, "ball and plate", 3, true });
      cases.push_back({ method, "torus", 2, true });
      cases.push_back({ method, "plate 5 thick", 3, true });
    }
  }
  return cases;
}

} // namespace

TEST_P(CoarsenedTets, InterfacesAreThoseOfTheUniformMesh)
{
  const CoarseCase& p = this->GetParam();
  const MeshCase c = MakeMeshCase(p.Name);
  Runtime runtime;
  MeshReport report, fineReport;
  MeshOptions options = OptionsOf(p.Method, p.Refinements);
  options.MeshVoid = p.MeshVoid;
  const Mesh mesh = MakeTetMesh(c.Grid, c.Fractions, options, runtime, report);
  options.Levels = LevelPlan();
  const Mesh fine = MakeTetMesh(c.Grid, c.Fractions, options, runtime, fineReport);
  ExpectValid(mesh);
  if (p.MeshVoid)
  {
    ExpectFull(mesh, c.Grid, c.Fractions.NumberOfMaterials());
  }
  // Lattice sums the initial volumes over other tets; energies in single
  // precision amplify the difference.
  EXPECT_LE(LargestDistance(InterfacePoints(mesh), InterfacePoints(fine)),
    p.Method == TetMethod::Lattice ? 1e-6 : 0.0);
  EXPECT_EQ(report.NumberOfFragments, fineReport.NumberOfFragments);
  EXPECT_EQ(report.NumberOfSurfaces, fineReport.NumberOfSurfaces);
  EXPECT_EQ(report.NumberOfCurves, fineReport.NumberOfCurves);
  EXPECT_EQ(report.NumberOfVertices, fineReport.NumberOfVertices);
  EXPECT_EQ(report.TargetVolume, fineReport.TargetVolume);
  for (int m = 1; m < static_cast<int>(report.MeshVolume.size()); ++m)
  {
    EXPECT_NEAR(report.MeshVolume[m] / fineReport.MeshVolume[m], 1.0, 1e-10);
    EXPECT_NEAR(MeasureVolume(mesh, m) / report.MeshVolume[m], 1.0, 1e-9);
  }
  if (p.Method != TetMethod::TetGen)
  {
    EXPECT_GE(
      report.MinimumDihedralAngle, std::min(SmallestAngle, fineReport.MinimumDihedralAngle));
  }
  std::printf("%-8s %-18s %d refinements: %8zu tets of %8zu, %7lld transition hexes, dihedral "
              "%.1f-%.1f (%.1f-%.1f), %lld parts rejected\n",
    NameOf(p.Method).c_str(), c.Name.c_str(), p.Refinements, mesh.ElementIds.size(),
    fine.ElementIds.size(), static_cast<long long>(report.TransitionCells),
    report.MinimumDihedralAngle, report.MaximumDihedralAngle, fineReport.MinimumDihedralAngle,
    fineReport.MaximumDihedralAngle, static_cast<long long>(report.RefusedParts));
}

INSTANTIATE_TEST_SUITE_P(Cases, CoarsenedTets, ::testing::ValuesIn(ListCases()),
  [](const ::testing::TestParamInfo<CoarseCase>& info)
  {
    std::string name = NameOf(info.param.Method) + "_" + info.param.Name + "_" +
      std::to_string(info.param.Refinements) + (info.param.MeshVoid ? "_void" : "");
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

namespace
{

/// Returns random labels in a box of cells and one label around it.
FractionField MakeRandomBlock(
  const CartesianGrid& grid, const IndexBox& block, int materials, int around, unsigned seed)
{
  std::mt19937 engine(seed);
  return MakeLabels(grid, materials,
    [&](const Index3& p)
    { return block.Contains(p) ? static_cast<int>(engine() % (materials + 1)) : around; });
}

struct Worst
{
  double Angle = 180.0, Determinant = 1e300;
  Index Transitions = 0;
  std::size_t Tets = 0;
};

void CheckRandom(TetMethod method, int refinements, unsigned seed, Worst& worst)
{
  SCOPED_TRACE(NameOf(method) + ", seed " + std::to_string(seed));
  const Index base = refinements == 1 ? 9 : 5, factor = Index(1) << refinements;
  const CartesianGrid grid =
    MakeUnitGrid(base * factor, (base - seed % 2) * factor, (base + seed / 2 % 2) * factor);
  const Index at = seed % 3 == 0 ? 0 : 5 + seed % 7;
  const IndexBox block{ { { at, at, 3 } }, { { at + 3, at + 2, 6 } } };
  const FractionField field = MakeRandomBlock(grid, block, 2, 1, seed);
  MeshOptions options = OptionsOf(method, refinements);
  options.MeshVoid = true;
  const double chances[] = { 0.02, 0.1, 0.3 };
  options.Levels.Families = MakeRandomFamilies(grid, refinements, chances[seed % 3], seed);
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeTetMesh(grid, field, options, runtime, report);
  ExpectValid(mesh);
  ExpectFull(mesh, grid, 2);
  worst.Angle = std::min(worst.Angle, report.MinimumDihedralAngle);
  worst.Determinant = std::min(worst.Determinant, SmallestCornerDeterminant(mesh));
  worst.Transitions += report.TransitionCells;
  worst.Tets += mesh.ElementIds.size();
}

void PrintWorst(const char* name, const Worst& worst)
{
  std::printf("%s: %zu tets, %lld transition hexes, smallest dihedral angle %.1f, smallest "
              "determinant %.2e\n",
    name, worst.Tets, static_cast<long long>(worst.Transitions), worst.Angle, worst.Determinant);
}

} // namespace

TEST(RefinedTets, RandomFamiliesAreValid)
{
  for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice })
  {
    for (int refinements : { 1, 2 })
    {
      Worst worst;
      for (unsigned seed : ListSeeds(refinements == 1 ? 6 : 3))
      {
        CheckRandom(method, refinements, seed, worst);
      }
      PrintWorst((NameOf(method) + ", " + std::to_string(refinements)).c_str(), worst);
      EXPECT_GE(worst.Angle, SmallestAngle);
    }
  }
}

TEST(RefinedTets, AllFamiliesGiveTheUniformMesh)
{
  const CartesianGrid grid = MakeUnitGrid(12, 10, 8);
  const IndexBox block{ { { 2, 3, 1 } }, { { 7, 6, 5 } } };
  const FractionField field = MakeRandomBlock(grid, block, 2, 0, 3);
  for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice })
  {
    MeshOptions options = OptionsOf(method, 1);
    options.MeshVoid = true;
    options.Levels.Families = MakeRandomFamilies(grid, 1, 1.0, 1);
    Runtime runtime;
    MeshReport report;
    const Mesh mesh = MakeTetMesh(grid, field, options, runtime, report);
    options.Levels = LevelPlan();
    EXPECT_TRUE(AreEqual(mesh, MakeTetMesh(grid, field, options, runtime, report)))
      << NameOf(method);
  }
}

TEST(RefinedTets, FewWhereLittleHappens)
{
  const Index n = 64;
  const CartesianGrid grid = MakeUnitGrid(n);
  const FractionField field = MakeLabels(grid, 1,
    [&](const Index3& p)
    {
      double square = 0.0;
      for (Index i : p)
      {
        const double x = static_cast<double>(i) + 0.5 - 0.5 * static_cast<double>(n);
        square += x * x;
      }
      return square < 49.0 ? 1 : 0;
    });
  for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice, TetMethod::TetGen })
  {
    if (method == TetMethod::TetGen && !HasTetGen())
    {
      continue;
    }
    MeshOptions options = OptionsOf(method, 3);
    options.MeshVoid = true;
    Runtime runtime;
    MeshReport report;
    const Mesh mesh = MakeTetMesh(grid, field, options, runtime, report);
    ExpectValid(mesh);
    ExpectFull(mesh, grid, 1);
    const Index uniform = 12 * n * n * n; // number of tets of Cells
    EXPECT_LT(4 * static_cast<Index>(mesh.ElementIds.size()), uniform);
    std::printf("%s: %zu tets, uniform %lld, dihedral %.1f-%.1f\n", NameOf(method).c_str(),
      mesh.ElementIds.size(), static_cast<long long>(uniform), report.MinimumDihedralAngle,
      report.MaximumDihedralAngle);
    for (const MeshReport::Level& level : report.Levels)
    {
      std::printf("  %lld families (%lld added), %lld cells\n",
        static_cast<long long>(level.Families), static_cast<long long>(level.AddedForBalance),
        static_cast<long long>(level.Cells));
    }
  }
}

TEST(RefinedTets, StretchedCells)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    double at = -1.0, width = 0.3 + 0.25 * a;
    for (int i = 0; i <= 24; ++i, at += width, width *= 1.03)
    {
      x[a].push_back(at);
    }
  }
  const CartesianGrid grid(x);
  const IndexBox block{ { { 10, 11, 9 } }, { { 13, 13, 12 } } };
  const FractionField field = MakeRandomBlock(grid, block, 2, 1, 5);
  for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice })
  {
    MeshOptions options = OptionsOf(method, 2);
    options.MeshVoid = true;
    options.Levels.Families = MakeRandomFamilies(grid, 2, 0.1, 5);
    Runtime runtime;
    MeshReport report;
    const Mesh mesh = MakeTetMesh(grid, field, options, runtime, report);
    ExpectValid(mesh);
    ExpectFull(mesh, grid, 2);
    options.Levels = LevelPlan();
    MeshReport fine;
    MakeTetMesh(grid, field, options, runtime, fine);
    std::printf("%s, cells 1:1.8:2.7: dihedral %.1f-%.1f (%.1f-%.1f)\n", NameOf(method).c_str(),
      report.MinimumDihedralAngle, report.MaximumDihedralAngle, fine.MinimumDihedralAngle,
      fine.MaximumDihedralAngle);
  }
}

TEST(RefinedTets, SameOnAnyNumberOfRanks)
{
  struct Case
  {
    int Refinements, Ranks;
  };
  const CartesianGrid grid = MakeUnitGrid(24, 16, 32);
  for (const Case& c : { Case{ 1, 2 }, { 1, 8 }, { 2, 2 }, { 2, 3 }, { 2, 8 }, { 3, 3 } })
  {
    const FractionField field = MakeBlockLabels(grid, c.Refinements, 3);
    for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice })
    {
      SCOPED_TRACE(std::to_string(c.Refinements) + " refinements on " + std::to_string(c.Ranks));
      MeshOptions options = OptionsOf(method, c.Refinements);
      options.MeshVoid = c.Ranks != 2;
      options.Levels.Families = MakeRandomFamilies(grid, c.Refinements, .02, 7);
      std::vector<IndexBox> boxes = CutBaseBox(grid, c.Refinements, c.Ranks);
      if (c.Ranks == 3)
      {
        boxes.insert(boxes.begin() + 1, IndexBox());
      }
      CompareWithSerial(grid, field, { boxes }, options, MakeTetMesh);
    }
  }
}

TEST(RefinedTets, SphereOnRanks)
{
  const MeshCase c = MakeMeshCase("sphere 16");
  for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice })
  {
    for (bool meshVoid : { false, true })
    {
      MeshOptions options = OptionsOf(method, 1);
      options.MeshVoid = meshVoid;
      CompareWithSerial(
        c.Grid, c.Fractions, { CutBaseBox(c.Grid, 1, meshVoid ? 3 : 8) }, options, MakeTetMesh);
    }
  }
}

TEST(RefinedTets, PartsOfTetGenMatch)
{
  if (!HasTetGen())
  {
    GTEST_SKIP() << "built without TetGen";
  }
  const MeshCase c = MakeMeshCase("half sphere");
  MeshOptions options = OptionsOf(TetMethod::TetGen, 2);
  options.MeshVoid = true;
  const RankMesh alone = MakeAlone(c.Grid, c.Fractions, options, MakeTetMesh);
  const RankMesh made =
    MakeOnRanks(c.Grid, c.Fractions, CutBaseBox(c.Grid, 2, 4), options, MakeTetMesh);
  const Mesh merged = made.Merged.Join();
  ExpectValid(merged);
  ExpectFull(merged, c.Grid, 1);
  EXPECT_EQ(CountDifferences(made.Merged.Facets, alone.Merged.Facets), 0u) << "facets";
}
