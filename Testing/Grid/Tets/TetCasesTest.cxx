/// Manufactured shapes as tetrahedra: angles, distance to the true interface, volume, topology.
#include "MeshCases.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct TetCase
{
  TetMethod Method;
  std::string Name;
  double SmallestAngle, LargestAngle; // dihedral, degrees
  double LargestDistance, RmsDistance;
};

void PrintTo(const TetCase& c, std::ostream* out)
{
  *out << NameOf(c.Method) << " " << c.Name;
}

constexpr TetMethod Lattice = TetMethod::Lattice, Cells = TetMethod::Cells,
                    Filled = TetMethod::TetGen;

std::vector<TetCase> ListTetCases()
{
  std::vector<TetCase> cases{
    { Lattice, "sphere 8", 38.0, 124.5, .065, .032 },
    { Lattice, "sphere 16", 37.5, 128.5, .060, .0184 },
    { Lattice, "sphere 32", 35.5, 128.5, .056, .0144 },
    { Lattice, "two spheres, gap .3", 34.5, 134.5, .330, .0250 },
    { Lattice, "plate 2 thick", 32.0, 138.0, .130, .0167 },
    { Lattice, "plate 5 thick", 32.0, 138.5, .110, .0166 },
    { Lattice, "torus", 33.5, 135.5, .130, .0190 },
    { Lattice, "gyroid", 31.5, 137.0, .445, .0253 },
    { Lattice, "cut cylinder", 32.5, 134.5, .215, .0225 },
    { Lattice, "half sphere", 34.5, 133.0, .105, .0260 },
    { Lattice, "ball and plate", 32.5, 132.5, .336, .0151 },
    { Lattice, "ball of 3 sectors", 31.5, 136.5, .204, .0191 },
    { Lattice, "polycrystal", 29.4, 141.5, .480, .0400 },
    { Cells, "sphere 16", 32.0, 134.5, .362, .0511 },
    { Cells, "sphere 32", 32.5, 134.5, .418, .0527 },
    { Cells, "gyroid", 31.5, 135.5, .409, .0607 },
    { Cells, "ball and plate", 31.5, 139.5, .406, .0612 },
    { Cells, "ball of 3 sectors", 30.5, 139.5, .514, .0760 },
    { Cells, "polycrystal", 29.5, 141.5, .461, .1146 },
  };
  if (HasTetGen())
  {
    for (const char* name : { "sphere 16", "ball of 3 sectors", "12 grains" })
    {
      cases.push_back({ Filled, name, 8.0, 165.0, 1.0, .15 });
    }
  }
  return cases;
}

class TetCases : public ::testing::TestWithParam<TetCase>
{
};

} // namespace

TEST_P(TetCases, ReachesItsFigures)
{
  const TetCase& bounds = this->GetParam();
  const MeshCase c =
    bounds.Name == "12 grains" ? MakePolycrystalCase(12, 14) : MakeMeshCase(bounds.Name);
  MeshOptions options;
  options.Method = bounds.Method;
  Runtime runtime;
  const MeshFigures figures = MeasureCase(c, options, runtime, MakeTetMesh);
  std::printf("%s", FormatTetFigures(bounds.Method, bounds.Name, figures).c_str());
  const Mesh& mesh = figures.Result;
  const MeshReport& report = figures.Report;
  EXPECT_EQ(mesh.Corners, 4);
  EXPECT_GT(SmallestCornerDeterminant(mesh), 0.0);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(FindFragmentProblem(mesh), "");
  EXPECT_GE(report.MinimumDihedralAngle, bounds.SmallestAngle);
  EXPECT_LE(report.MaximumDihedralAngle, bounds.LargestAngle);
  EXPECT_LE(figures.Distance.Largest, bounds.LargestDistance);
  EXPECT_LE(figures.Distance.RootMeanSquare, bounds.RmsDistance);
  EXPECT_LE(figures.VolumeError, 1e-3);
  EXPECT_EQ(report.RefusedParts, 0);
  for (std::size_t m = 0; m < report.MeshVolume.size(); ++m)
  {
    EXPECT_NEAR(MeasureVolume(mesh, static_cast<int>(m)), report.MeshVolume[m],
      1e-14 * c.Grid.Owned().NumberOfCells())
      << "material " << m;
  }
  Index angles = 0;
  for (Index count : report.DihedralAngles)
  {
    angles += count;
  }
  EXPECT_EQ(angles, 6 * static_cast<Index>(figures.Elements));
}

INSTANTIATE_TEST_SUITE_P(All, TetCases, ::testing::ValuesIn(ListTetCases()),
  [](const ::testing::TestParamInfo<TetCase>& info)
  {
    std::string name = NameOf(info.param.Method) + "_" + info.param.Name;
    for (char& c : name)
    {
      c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    }
    return name;
  });

TEST(TetChecks, FindWhatIsWrong)
{
  const auto makeMesh = [](const std::vector<Index>& elements)
  {
    const double points[21] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, -1, 0, 0, 0, -1, -1 };
    const std::size_t used = *std::max_element(elements.begin(), elements.end()) + 1;
    Mesh mesh;
    mesh.Corners = 4;
    mesh.Points = Buffer<double>(3 * used);
    std::copy_n(points, 3 * used, mesh.Points.data());
    mesh.Elements = Buffer<Index>(elements.size());
    std::copy(elements.begin(), elements.end(), mesh.Elements.data());
    mesh.PointIds = Buffer<Index>(used);
    std::iota(mesh.PointIds.begin(), mesh.PointIds.end(), 1);
    mesh.ElementIds = Buffer<Index>(elements.size() / 4);
    std::iota(mesh.ElementIds.begin(), mesh.ElementIds.end(), 1);
    mesh.Material = Buffer<int>(elements.size() / 4, 1);
    mesh.Fragment = Buffer<int>(elements.size() / 4, 1);
    return mesh;
  };
  Mesh face = makeMesh({ 0, 1, 2, 3, 1, 2, 3, 4 });
  EXPECT_EQ(FindTopologyProblem(face), "");
  EXPECT_EQ(FindFragmentProblem(face), "");
  EXPECT_DOUBLE_EQ(SmallestCornerDeterminant(face), 1.0);
  EXPECT_DOUBLE_EQ(MeasureVolume(face, 1), 0.5);
  face.Fragment[1] = 2;
  EXPECT_NE(FindFragmentProblem(face), "");
  face.Material[1] = 2;
  EXPECT_EQ(FindFragmentProblem(face), "");
  face.Fragment[1] = 1;
  EXPECT_NE(FindFragmentProblem(face), "");
  face.ElementIds[1] = 1;
  EXPECT_NE(FindConformityProblem(face), "");
  const Mesh edge = makeMesh({ 0, 1, 2, 3, 0, 1, 4, 5 });
  EXPECT_EQ(FindConformityProblem(edge), "");
  EXPECT_EQ(CountBoundaryDefects(edge).at(1).OddEdges, 1);
  EXPECT_EQ(CountBoundaryDefects(edge).at(1).NonManifoldPoints, 0);
  EXPECT_NE(FindFragmentProblem(edge), "");
  const Mesh point = makeMesh({ 0, 1, 2, 3, 0, 4, 5, 6 });
  EXPECT_EQ(CountBoundaryDefects(point).at(1).OddEdges, 0);
  EXPECT_EQ(CountBoundaryDefects(point).at(1).NonManifoldPoints, 1);
  EXPECT_NE(FindConformityProblem(makeMesh({ 0, 1, 2, 3, 1, 2, 3, 4, 1, 2, 3, 5 })), "");
  EXPECT_NE(FindConformityProblem(makeMesh({ 0, 1, 2, 4 })), "");
}
