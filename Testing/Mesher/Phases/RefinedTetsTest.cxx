/// Tetrahedra with coarser cells away from interfaces: valid, conforming, and equal to the
/// uniform grid's mesh at interfaces.
#include "RankMeshes.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double SmallestAngle = 45.0 - 1e-9; // degrees, tets of coarser cells
constexpr double LargestShift = 0.1;          // of interface points of Lattice, in cells

MeshOptions OptionsOf(TetMethod method, int refinements)
{
  MeshOptions options;
  options.Method = method;
  options.Levels.Refinements = refinements;
  return options;
}

/// Returns the largest distance between points of equal ids, or a huge value if a point lacks a
/// partner.
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

/// The method that has fewer layers of finest cells than points that move have around them.
class CoarsenedLattice : public CoarsenedTets
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

std::vector<CoarseCase> ListLatticeCases()
{
  std::vector<CoarseCase> cases = ListCases();
  std::erase_if(cases, [](const CoarseCase& c) { return c.Method != TetMethod::Lattice; });
  return cases;
}

std::string NameOfCase(const ::testing::TestParamInfo<CoarseCase>& info)
{
  std::string name = NameOf(info.param.Method) + "_" + info.param.Name + "_" +
    std::to_string(info.param.Refinements) + (info.param.MeshVoid ? "_void" : "");
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// A mesh with levels and the uniform one, with their reports.
struct TetMeshes
{
  Mesh Coarse, Fine;
  MeshReport Report, FineReport;
};

/// Makes both meshes, and expects that they are valid and have the same parts.
TetMeshes MakeMeshes(const CoarseCase& p, const MeshCase& c, int fineLayers)
{
  TetMeshes made;
  Runtime runtime;
  MeshOptions options = OptionsOf(p.Method, p.Refinements);
  options.MeshVoid = p.MeshVoid;
  options.Levels.FineLayers = fineLayers;
  made.Coarse = MakeTetMesh(c.Grid, c.Fractions, options, runtime, made.Report);
  options.Levels = LevelPlan();
  made.Fine = MakeTetMesh(c.Grid, c.Fractions, options, runtime, made.FineReport);
  ExpectValid(made.Coarse);
  if (p.MeshVoid)
  {
    ExpectFull(made.Coarse, c.Grid, c.Fractions.NumberOfMaterials());
  }
  EXPECT_EQ(made.Report.NumberOfFragments, made.FineReport.NumberOfFragments);
  EXPECT_EQ(made.Report.NumberOfSurfaces, made.FineReport.NumberOfSurfaces);
  EXPECT_EQ(made.Report.NumberOfCurves, made.FineReport.NumberOfCurves);
  EXPECT_EQ(made.Report.NumberOfVertices, made.FineReport.NumberOfVertices);
  return made;
}

} // namespace

TEST_P(CoarsenedTets, InterfacesAreThoseOfTheUniformMesh)
{
  const CoarseCase& p = this->GetParam();
  const MeshCase c = MakeMeshCase(p.Name);
  const TetMeshes made = MakeMeshes(p, c, p.Method == TetMethod::Lattice ? 3 : 2);
  const auto& [mesh, fine, report, fineReport] = made;
  // Lattice sums the initial volumes over other tets; energies in single
  // precision amplify the difference.
  EXPECT_LE(LargestDistance(InterfacePoints(mesh), InterfacePoints(fine)),
    p.Method == TetMethod::Lattice ? 1e-6 : 0.0);
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
  std::printf("%-8s %-18s %d refinements: %8zu tets of %8zu, %7lld transition cells, dihedral "
              "%.1f-%.1f (%.1f-%.1f), %lld parts rejected\n",
    NameOf(p.Method).c_str(), c.Name.c_str(), p.Refinements, mesh.ElementIds.size(),
    fine.ElementIds.size(), static_cast<long long>(report.TransitionCells),
    report.MinimumDihedralAngle, report.MaximumDihedralAngle, fineReport.MinimumDihedralAngle,
    fineReport.MaximumDihedralAngle, static_cast<long long>(report.RefusedParts));
}

/// By default, points at interfaces have neighbours in larger cells.
TEST_P(CoarsenedLattice, FewestLayersHardlyChangeInterfaces)
{
  const CoarseCase& p = this->GetParam();
  const MeshCase c = MakeMeshCase(p.Name);
  const TetMeshes made = MakeMeshes(p, c, LevelPlan().FineLayers);
  const auto& [mesh, fine, report, fineReport] = made;
  const double moved = LargestDistance(InterfacePoints(mesh), InterfacePoints(fine));
  EXPECT_LT(moved, LargestShift * c.Grid.MeanWidth());
  for (int m = 1; m < static_cast<int>(report.MeshVolume.size()); ++m)
  {
    EXPECT_NEAR(report.MeshVolume[m] / fineReport.MeshVolume[m], 1.0, 1e-6);
    EXPECT_NEAR(MeasureVolume(mesh, m) / report.MeshVolume[m], 1.0, 1e-9);
  }
  EXPECT_GE(
    report.MinimumDihedralAngle, std::min(SmallestAngle, fineReport.MinimumDihedralAngle - 1.0));
  std::printf("%-8s %-18s %d refinements: %8zu tets of %8zu, dihedral %.1f-%.1f (%.1f-%.1f), "
              "shift %.4f cells, %lld parts rejected\n",
    NameOf(p.Method).c_str(), c.Name.c_str(), p.Refinements, mesh.ElementIds.size(),
    fine.ElementIds.size(), report.MinimumDihedralAngle, report.MaximumDihedralAngle,
    fineReport.MinimumDihedralAngle, fineReport.MaximumDihedralAngle, moved / c.Grid.MeanWidth(),
    static_cast<long long>(report.RefusedParts));
}

INSTANTIATE_TEST_SUITE_P(Cases, CoarsenedTets, ::testing::ValuesIn(ListCases()), NameOfCase);
INSTANTIATE_TEST_SUITE_P(
  Cases, CoarsenedLattice, ::testing::ValuesIn(ListLatticeCases()), NameOfCase);

TEST(RefinedTets, AllFamiliesGiveTheUniformMesh)
{
  const CartesianGrid grid = MakeUnitGrid(12, 10, 8);
  const IndexBox block{ { { 2, 3, 1 } }, { { 7, 6, 5 } } };
  std::mt19937 engine(3);
  const FractionField field = MakeLabels(grid, 2,
    [&](const Index3& p) { return block.Contains(p) ? static_cast<int>(engine() % 3) : 0; });
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

/// 12 grains, about 20 cells across.
TEST(RefinedTets, GrainsHaveHalfTheTets)
{
  const Index n = 48;
  const CartesianGrid grid = MakeUnitGrid(n);
  std::mt19937 engine(1);
  std::vector<Vector3> seeds(12);
  for (Vector3& seed : seeds)
  {
    for (double& x : seed)
    {
      x = static_cast<double>(engine()) / 4294967296.0 * static_cast<double>(n);
    }
  }
  const FractionField field = MakeLabels(grid, static_cast<int>(seeds.size()),
    [&](const Index3& p)
    {
      const auto distance = [&p](const Vector3& seed)
      {
        double square = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          square += std::pow(static_cast<double>(p[a]) + 0.5 - seed[a], 2);
        }
        return square;
      };
      const auto nearest = std::min_element(seeds.begin(), seeds.end(),
        [&](const Vector3& a, const Vector3& b) { return distance(a) < distance(b); });
      return 1 + static_cast<int>(nearest - seeds.begin());
    });
  Runtime runtime;
  MeshReport report, fineReport;
  const Mesh mesh = MakeTetMesh(grid, field, OptionsOf(TetMethod::Lattice, 3), runtime, report);
  const Mesh fine = MakeTetMesh(grid, field, OptionsOf(TetMethod::Lattice, 0), runtime, fineReport);
  ExpectValid(mesh);
  ExpectFull(mesh, grid, static_cast<int>(seeds.size()));
  EXPECT_LT(2 * mesh.ElementIds.size(), fine.ElementIds.size());
  EXPECT_GE(report.MinimumDihedralAngle, 30.0);
  EXPECT_LE(report.MaximumDihedralAngle, 140.0);
  for (std::size_t m = 1; m < report.MeshVolume.size(); ++m)
  {
    EXPECT_NEAR(report.MeshVolume[m] / report.TargetVolume[m], 1.0, 1e-6);
  }
  std::printf("grains: %zu tets of %zu, dihedral %.2f-%.2f (%.2f-%.2f)\n", mesh.ElementIds.size(),
    fine.ElementIds.size(), report.MinimumDihedralAngle, report.MaximumDihedralAngle,
    fineReport.MinimumDihedralAngle, fineReport.MaximumDihedralAngle);
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
