/// Surfaces, curves and vertices of known shapes, and which of them bound each other.
#include "Base/Vector3.h"
#include "GeometryChecks.h"
#include "SharpCases.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Pairs = std::vector<GeometryTables::Pair>;

struct Elements
{
  MeshMaker Make;
  TetMethod Method;
};

/// Makes hexahedra, or tetrahedra by each method of this build.
class GeometryOf : public ::testing::TestWithParam<Elements>
{
protected:
  MergedMesh Make(const CartesianGrid& grid, const FractionField& field, MeshOptions options = {})
  {
    options.Method = this->GetParam().Method;
    const RankMesh made = MakeAlone(grid, field, options, this->GetParam().Make);
    this->Report = made.Reports[0];
    EXPECT_EQ(FindGeometryProblem(made.Merged), "");
    return made.Merged;
  }

  MergedMesh Make(const std::string& name)
  {
    const MeshCase c = MakeMeshCase(name);
    return this->Make(c.Grid, c.Fractions);
  }

  void ExpectCounts(int volumes, int surfaces, int curves, int vertices) const
  {
    EXPECT_EQ(this->Report.NumberOfFragments, volumes);
    EXPECT_EQ(this->Report.NumberOfSurfaces, surfaces);
    EXPECT_EQ(this->Report.NumberOfCurves, curves);
    EXPECT_EQ(this->Report.NumberOfVertices, vertices);
  }

  MeshReport Report;
};

/// Counts how often each number occurs in a column.
std::map<int, int> Count(const Pairs& pairs, int column)
{
  std::map<int, int> counts;
  for (const auto& pair : pairs)
  {
    ++counts[pair[column]];
  }
  return counts;
}

/// Returns whether each number from 1 to `many` occurs `often` times, and no other number.
bool EachOccurs(const Pairs& pairs, int column, int many, int often)
{
  std::map<int, int> expected;
  for (int number = 1; number <= many; ++number)
  {
    expected[number] = often;
  }
  return Count(pairs, column) == expected;
}

} // namespace

TEST_P(GeometryOf, BoxThatFillsTheDomain)
{
  for (const Index3& cells : { Index3{ { 1, 1, 1 } }, Index3{ { 1, 4, 3 } } })
  {
    const CartesianGrid grid = MakeUnitGrid(cells[0], cells[1], cells[2]);
    const MergedMesh mesh = this->Make(grid, MakeLabels(grid, 1, [](const Index3&) { return 1; }));
    this->ExpectCounts(1, 6, 12, 8);
    const GeometryTables& tables = mesh.Tables;
    EXPECT_TRUE(EachOccurs(tables.SurfaceCurves, 0, 6, 4));
    EXPECT_TRUE(EachOccurs(tables.SurfaceCurves, 1, 12, 2));
    EXPECT_TRUE(EachOccurs(tables.CurveVertices, 0, 12, 2));
    EXPECT_TRUE(EachOccurs(tables.CurveVertices, 1, 8, 3));
    EXPECT_EQ(tables.CurveEnds, std::vector<int>(12, 2));
    const std::vector<int>& sides = tables.SurfaceSides;
    EXPECT_EQ(std::set<int>(sides.begin(), sides.end()), (std::set<int>{ 0, 1, 2, 3, 4, 5 }));
    EXPECT_EQ(tables.SurfaceVolumes, Pairs(6, { { 0, 1 } }));
    EXPECT_EQ(
      mesh.CurveEdges.size(), static_cast<std::size_t>(4 * (cells[0] + cells[1] + cells[2])));
  }
}

/// Without the option SharpEdges one surface encloses the volume, even of a shape with sharp edges.
TEST_P(GeometryOf, CubeInsideTheDomain)
{
  const CartesianGrid grid = MakeUnitGrid(6);
  const IndexBox cube{ { { 2, 2, 2 } }, { { 4, 4, 4 } } };
  const MergedMesh mesh = this->Make(
    grid, MakeLabels(grid, 1, [&](const Index3& p) { return cube.Contains(p) ? 1 : 0; }));
  this->ExpectCounts(1, 1, 0, 0);
  EXPECT_EQ(mesh.Tables.SurfaceVolumes, Pairs({ { { 0, 1 } } }));
  EXPECT_EQ(mesh.Tables.SurfaceSides, std::vector<int>{ -1 });
  EXPECT_TRUE(mesh.CurveEdges.empty() && mesh.Vertices.empty());
}

TEST_P(GeometryOf, HalfABallHasAClosedCurve)
{
  const MergedMesh mesh = this->Make("half sphere");
  this->ExpectCounts(1, 2, 1, 0); // the side on the domain boundary and the rest
  EXPECT_EQ(mesh.Tables.CurveEnds, std::vector<int>{ 0 });
  EXPECT_EQ(mesh.Tables.SurfaceCurves, Pairs({ { { 1, 1 } }, { { 2, 1 } } }));
  EXPECT_TRUE(mesh.Tables.CurveVertices.empty());
}

TEST_P(GeometryOf, SectorsMeetInAnAxis)
{
  const GeometryTables tables = this->Make("ball of 3 sectors").Tables;
  // 3 outer surfaces and 3 between; 3 meridians and the axis; the poles
  this->ExpectCounts(3, 6, 4, 2);
  EXPECT_TRUE(EachOccurs(tables.VolumeSurfaces, 0, 3, 3));
  EXPECT_TRUE(EachOccurs(tables.SurfaceCurves, 0, 6, 2));
  EXPECT_TRUE(EachOccurs(tables.SurfaceCurves, 1, 4, 3));
  EXPECT_EQ(tables.CurveEnds, std::vector<int>(4, 2));
  EXPECT_TRUE(EachOccurs(tables.CurveVertices, 1, 2, 4));
  std::map<int, int> between; // surfaces between two volumes per curve
  for (const auto& pair : tables.SurfaceCurves)
  {
    const auto& volumes = tables.SurfaceVolumes[pair[0] - 1];
    between[pair[1]] += volumes[0] > 0 && volumes[1] > 0;
  }
  std::multiset<int> counts;
  for (const auto& curve : between)
  {
    counts.insert(curve.second);
  }
  EXPECT_EQ(counts, (std::multiset<int>{ 1, 1, 1, 3 }));
}

/// Each grain is a polyhedron: vertices - curves + surfaces is 2.
TEST_P(GeometryOf, GrainsArePolyhedra)
{
  const MeshCase c = MakePolycrystalCase(5, 16);
  const GeometryTables tables = this->Make(c.Grid, c.Fractions).Tables;
  EXPECT_EQ(tables.CurveEnds, std::vector<int>(tables.CurveEnds.size(), 2));
  std::map<int, std::set<int>> surfaces, curves, vertices; // by volume, surface and curve
  for (const auto& [pairs, of] : { std::pair(&tables.VolumeSurfaces, &surfaces),
         std::pair(&tables.SurfaceCurves, &curves), std::pair(&tables.CurveVertices, &vertices) })
  {
    for (const auto& pair : *pairs)
    {
      (*of)[pair[0]].insert(pair[1]);
    }
  }
  EXPECT_EQ(surfaces.size(), 5u);
  for (const auto& grain : surfaces)
  {
    std::set<int> itsCurves, itsVertices;
    for (int surface : grain.second)
    {
      itsCurves.insert(curves[surface].begin(), curves[surface].end());
    }
    for (int curve : itsCurves)
    {
      itsVertices.insert(vertices[curve].begin(), vertices[curve].end());
    }
    EXPECT_EQ(itsVertices.size() + grain.second.size(), itsCurves.size() + 2)
      << "grain " << grain.first;
  }
}

/// With SharpEdges each smooth side is a surface; plane sides have a normal.
TEST_P(GeometryOf, SidesOfSolidsWithEdges)
{
  struct Solid
  {
    const char* Name;
    int Cells, Surfaces, Curves, Vertices;
    std::size_t Planes;
  };
  for (const Solid& solid : { Solid{ "cube A", 16, 6, 12, 8, 6 },
         Solid{ "cylinder", 16, 3, 2, 0, 2 }, Solid{ "L", 24, 8, 18, 12, 8 } })
  {
    const SharpCase c = MakeSharpCase(solid.Name, solid.Cells);
    MeshOptions options;
    options.SharpEdges = SharpEdgeMode::On;
    const GeometryTables tables = this->Make(c.Grid, c.Fractions, options).Tables;
    this->ExpectCounts(1, solid.Surfaces, solid.Curves, solid.Vertices);
    EXPECT_EQ(tables.CurveEnds, std::vector<int>(solid.Curves, solid.Vertices > 0 ? 2 : 0));
    double area = 0.0;
    std::vector<Vector3> normals;
    for (int s = 0; s < solid.Surfaces; ++s)
    {
      EXPECT_EQ(tables.SurfaceParts[s], s + 1);
      area += tables.SurfaceAreas[s];
      if (Norm(tables.SurfaceNormals[s]) > .8)
      {
        normals.push_back(tables.SurfaceNormals[s]);
        EXPECT_LT(c.Distance(tables.SurfaceCentroids[s]), .3) << solid.Name;
      }
    }
    EXPECT_EQ(normals.size(), solid.Planes) << solid.Name;
    std::printf("%-10s %d surfaces, %d curves, %d vertices, area %.1f\n", solid.Name,
      static_cast<int>(this->Report.NumberOfSurfaces),
      static_cast<int>(this->Report.NumberOfCurves),
      static_cast<int>(this->Report.NumberOfVertices), area);
  }
}

INSTANTIATE_TEST_SUITE_P(Geometry, GeometryOf,
  ::testing::Values(Elements{ MakeHexMesh, TetMethod::Cells },
    Elements{ MakeTetMesh, TetMethod::Cells }, Elements{ MakeTetMesh, TetMethod::Lattice },
    Elements{ MakeTetMesh, HasTetGen() ? TetMethod::TetGen : TetMethod::Cells }),
  [](const ::testing::TestParamInfo<Elements>& info)
  {
    return info.param.Make == MakeHexMesh
      ? "Hexes"
      : NameOf(info.param.Method) + "_" + std::to_string(info.index);
  });
