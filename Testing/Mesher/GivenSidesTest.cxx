/// Sides of interfaces from the surfaces of bodies.
#include "Geometry/GivenSides.h"

#include "Base/DisjointSets.h"
#include "Geometry/DivideInterfaces.h"
#include "Geometry/FacetValues.h"
#include "Parts/PartCases.h"
#include "Report/Sets/MeshSets.h"
#include "State/ViewMesh.h"
#include "SurfaceCases.h"
#include "SurfaceRuns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Method
{
  const char* Name;
  ElementKind Elements;
  TetMethod Tets;
};

constexpr Method Methods[] = { { "Hexes", ElementKind::Hexes, TetMethod::Lattice },
  { "Lattice", ElementKind::Tets, TetMethod::Lattice },
  { "Cells", ElementKind::Tets, TetMethod::Cells } };

MesherOptions OptionsOf(const Method& method)
{
  MesherOptions options;
  options.Elements = method.Elements;
  options.Method = method.Tets;
  return options;
}

SurfaceCase MakeBracket()
{
  return { { { 24, 24, 20 } },
    { { Turned(BracketBody("bracket", 14.3, 4.2, 9.1), { { 9.7, 5.2, 2.3 } }) } } };
}

SurfaceCase MakePlate()
{
  return { { { 28, 28, 20 } },
    { { Turned(PlateBody("plate", 2, 2, 9.0, 2.5, 3.6, 48), { { 12.3, 4.1, 2.6 } }) } } };
}

/// Returns the areas of named surfaces; those of one name are added.
std::map<std::string, double> AreasByName(const GeometryTables& tables)
{
  std::map<std::string, double> areas;
  for (std::size_t s = 0; s < tables.PatchNames.size(); ++s)
  {
    areas[tables.PatchNames[s]] += tables.SurfaceAreas[s];
  }
  return areas;
}

/// Returns the number of pieces of all surfaces: of facets joined over common edges.
std::size_t CountPieces(const MergedMesh& mesh)
{
  std::vector<Index> sets = MakeSets(mesh.Facets.size());
  std::map<std::array<Index, 3>, Index> firsts; // of a surface and an edge or diagonal: a facet
  Index number = 0;
  for (const auto& [points, values] : mesh.Facets)
  {
    for (int c = 0; c < 4; ++c)
    {
      for (int d = c + 1; d < 4; ++d)
      {
        const Index a = std::min(points[c], points[d]), b = std::max(points[c], points[d]);
        if (a > 0 && a < b)
        {
          Join(sets, number,
            firsts.emplace(std::array<Index, 3>{ { values[0], a, b } }, number).first->second);
        }
      }
    }
    ++number;
  }
  std::size_t pieces = 0;
  for (Index f = 0; f < number; ++f)
  {
    pieces += FindRoot(sets, f) == f;
  }
  return pieces;
}

/// Expects a surface of one piece per patch.
/// @return largest relative error of the area of a patch
double ExpectPatches(const SurfaceCase& c, const SurfaceMesh& made)
{
  const BodySurface& body = c.Surfaces.Bodies[0];
  const GeometryTables& tables = made.Merged.Tables;
  EXPECT_EQ(tables.SurfaceAreas.size(), body.PatchNames.size());
  EXPECT_EQ(CountPieces(made.Merged), body.PatchNames.size());
  std::map<std::string, double> areas = AreasByName(tables);
  const std::vector<double> exact = AreasOfPatches(body);
  double largest = 0.0;
  for (std::size_t p = 0; p < exact.size(); ++p)
  {
    largest = std::max(largest, std::fabs(areas[body.PatchNames[p]] / exact[p] - 1.0));
  }
  return largest;
}

class GivenSides : public ::testing::TestWithParam<Method>
{
};

TEST_P(GivenSides, OfABracket)
{
  const SurfaceCase c = MakeBracket();
  EXPECT_LT(ExpectPatches(c, MeshSurfaces(c, OptionsOf(GetParam()))), 0.02);
}

TEST_P(GivenSides, OfAPlateWithHoles)
{
  const SurfaceCase c = MakePlate();
  EXPECT_LT(ExpectPatches(c, MeshSurfaces(c, OptionsOf(GetParam()))), 0.04);
}

TEST_P(GivenSides, OfASlice)
{
  const SurfaceCase c{ { { 28, 28, 20 } },
    { { Turned(SliceBody("slice", 13.0, 7.0, 60), { { 12.3, 6.1, 2.6 } }) } } };
  EXPECT_LT(ExpectPatches(c, MeshSurfaces(c, OptionsOf(GetParam()))), 0.02);
}

TEST_P(GivenSides, AreEqualOnRanks)
{
  for (const SurfaceCase& c : { MakeBracket(), MakePlate() })
  {
    const SurfaceMesh alone = MeshSurfaces(c, OptionsOf(GetParam()));
    for (int ranks : { 2, 3, 8 })
    {
      const SurfaceMesh made = MeshSurfaces(c, OptionsOf(GetParam()), ranks);
      EXPECT_EQ(FindGeometryDifference(made.Merged, alone.Merged), "") << ranks;
      EXPECT_EQ(made.Merged.Tables.PatchNames, alone.Merged.Tables.PatchNames);
    }
  }
}

/// Numbers of faces of side sets, and of points of node sets, by name.
struct SetSizes
{
  std::map<std::string, std::size_t> Faces, Points;
  bool Has(const std::string& name) const { return this->Faces.count(name) > 0; }
};

SetSizes CountSets(const MesherInput& input, const MesherOptions& options, Runtime& runtime)
{
  const MesherResult result = RunMesher(input, options, runtime);
  const MeshSets sets =
    FindMeshSets(ViewMesh(result.TheMesh, result.State, result.Fields), runtime.Group());
  SetSizes sizes;
  for (const SideSet& set : sets.SideSets)
  {
    sizes.Faces[set.Name] = set.Sides.size();
  }
  for (const NodeSet& set : sets.NodeSets)
  {
    sizes.Points[set.Name] = set.Points.size();
  }
  return sizes;
}

SetSizes CountSets(const SurfaceCase& c, const MesherOptions& options = {})
{
  Runtime serial;
  return CountSets(MakeSurfaceInput(c, serial.Group()), options, serial);
}

BodySurface MakeBox(const std::string& name, const Vector3& lower, const Vector3& upper)
{
  const ClosedSurface box = BoxSurface(lower, upper);
  std::vector<int> patches;
  for (const Triangle& t : PlaceTriangles(box))
  {
    const Vector3 normal = Unit(Cross(t[1] - t[0], t[2] - t[0]));
    patches.push_back(normal[0] < -0.5 ? 0 : normal[0] > 0.5 ? 1 : 2);
  }
  return MakeBody(
    name, box.Points, box.Triangles, patches, { name + "_start", name + "_end", name + "_walls" });
}

TEST(GivenSideSets, HaveTheNamesOfPatches)
{
  const SurfaceCase c = MakeBracket();
  const SetSizes sizes = CountSets(c);
  std::size_t faces = 0;
  for (const std::string& name : c.Surfaces.Bodies[0].PatchNames)
  {
    ASSERT_TRUE(sizes.Has(name)) << name;
    faces += sizes.Faces.at(name);
    EXPECT_GT(sizes.Points.at(name), sizes.Faces.at(name)) << name; // rectangles of quadrilaterals
  }
  EXPECT_EQ(faces, sizes.Faces.at("bracket_to_Void"));
  EXPECT_EQ(sizes.Faces.size(), 2u + c.Surfaces.Bodies[0].PatchNames.size()); // and the skin
}

TEST(GivenSideSets, SidesWithoutNamesHaveNumbers)
{
  SurfaceCase c = MakeBracket();
  c.Surfaces.Bodies[0] = WithoutPatches(c.Surfaces.Bodies[0]);
  const SetSizes sizes = CountSets(c);
  for (int surface = 1; surface <= 8; ++surface)
  {
    EXPECT_TRUE(sizes.Has("bracket_to_Void_" + std::to_string(surface))) << surface;
  }
  EXPECT_EQ(sizes.Faces.size(), 10u);
}

TEST(GivenSideSets, OneSideIsTheInterface)
{
  const ClosedSurface ball = SphereSurface({ { 8.1, 7.8, 8.3 } }, 4.7, 20);
  const SetSizes sizes =
    CountSets({ { { 16, 16, 16 } }, { { MakeBody("ball", ball.Points, ball.Triangles) } } });
  EXPECT_EQ(sizes.Faces.size(), 2u);
  EXPECT_TRUE(sizes.Has("ball_to_Void"));
}

TEST(GivenSideSets, FragmentsShareThePatchesOfTheirBody)
{
  const BodySurface first = MakeBox("part", { { 3.3, 3.4, 3.2 } }, { { 8.1, 9.7, 9.3 } });
  const BodySurface second = MakeBox("part", { { 11.2, 3.4, 3.2 } }, { { 16.4, 9.7, 9.3 } });
  const ClosedSurface both = Together(first.Boundary, second.Boundary);
  std::vector<int> patches = first.Patches;
  patches.insert(patches.end(), second.Patches.begin(), second.Patches.end());
  const SurfaceCase c{ { { 20, 13, 13 } },
    { { MakeBody("part", both.Points, both.Triangles, patches, first.PatchNames) } } };
  const SurfaceMesh made = MeshSurfaces(c, MesherOptions());
  EXPECT_EQ(made.Merged.Tables.PatchNames,
    (std::vector<std::string>{
      "part_start", "part_end", "part_walls", "part_start", "part_end", "part_walls" }));
  const SetSizes sizes = CountSets(c);
  EXPECT_EQ(sizes.Faces.size(), 5u);
  EXPECT_EQ(
    sizes.Faces.at("part_start") + sizes.Faces.at("part_end") + sizes.Faces.at("part_walls"),
    sizes.Faces.at("part_to_Void"));
}

TEST(GivenSideSets, ContactsBelongToTheFirstBody)
{
  const SurfaceCase c{ { { 20, 14, 14 } },
    { { MakeBox("a", { { 3.3, 3.4, 3.2 } }, { { 9.6, 10.7, 10.3 } }),
      MakeBox("b", { { 9.6, 3.4, 3.2 } }, { { 16.4, 10.7, 10.3 } }) } } };
  const SetSizes sizes = CountSets(c);
  for (const char* name :
    { "a_start", "a_walls", "b_end", "b_walls", "a_end_a_to_b", "a_end_b_to_a", "a_to_b" })
  {
    EXPECT_TRUE(sizes.Has(name)) << name;
  }
  EXPECT_EQ(sizes.Faces.at("a_end_a_to_b"), sizes.Faces.at("a_to_b"));
  EXPECT_FALSE(sizes.Has("b_start"));
}

TEST(GivenSideSets, OnlyBodiesWithSurfacesHavePatches)
{
  const SurfaceCase c{ { { 20, 14, 14 } },
    { { MakeBox("a", { { 3.3, 3.4, 3.2 } }, { { 9.6, 10.7, 10.3 } }),
      MakeBox("b", { { 9.6, 3.4, 3.2 } }, { { 16.4, 10.7, 10.3 } }) } } };
  Runtime serial;
  MesherInput input = MakeSurfaceInput(c, serial.Group());
  input.Surfaces = std::make_shared<const InputSurfaces>(InputSurfaces{ { c.Surfaces.Bodies[1] } });
  const SetSizes sizes = CountSets(input, MesherOptions(), serial);
  for (const char* name : { "b_end", "b_walls", "b_start_a_to_b", "b_start_b_to_a" })
  {
    EXPECT_TRUE(sizes.Has(name)) << name;
  }
  EXPECT_FALSE(sizes.Has("a_start"));
  EXPECT_TRUE(sizes.Has("a_to_Void_1")); // from the edges of the fractions

  MesherOptions off;
  off.UseSurfaces = false;
  EXPECT_FALSE(CountSets(input, off, serial).Has("b_end"));
}

TEST(GivenSideSets, AnImageMayBeTurned)
{
  SurfaceCase c = MakeBracket();
  const GeometryTables own = MeshSurfaces(c, MesherOptions()).Merged.Tables;
  for (const std::array<double, 9>& axes :
    { std::array<double, 9>{ 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1 },
      { 0, 1, 0, 1, 0, 0, 0, 0, 1 } }) // turned, mirrored
  {
    c.Frame = MakeImageFrame(axes, { { 3, 1, 2 } }, "image");
    const GeometryTables turned = MeshSurfaces(c, MesherOptions()).Merged.Tables;
    EXPECT_EQ(turned.PatchNames, own.PatchNames);
    ASSERT_EQ(turned.SurfaceAreas.size(), own.SurfaceAreas.size());
    for (std::size_t s = 0; s < own.SurfaceAreas.size(); ++s)
    {
      EXPECT_NEAR(turned.SurfaceAreas[s] / own.SurfaceAreas[s], 1.0, 1e-6) << s;
    }
  }
}

/// A bar along x through a periodic domain.
SurfaceCase MakeBar()
{
  return { { { 12, 14, 14 } },
    { { WithoutPatches(MakeBox("bar", { { 0, 4.3, 3.2 } }, { { 12, 9.7, 10.4 } })) } } };
}

TEST_P(GivenSides, OfAPeriodicBar)
{
  MesherOptions options = OptionsOf(GetParam());
  options.Periodic = 1;
  const SurfaceMesh alone = MeshSurfaces(MakeBar(), options);
  const std::vector<int>& parts = alone.Merged.Tables.SurfaceParts;
  EXPECT_EQ(std::count_if(parts.begin(), parts.end(), [](int part) { return part > 0; }), 4);
  for (int ranks : { 2, 3 })
  {
    const SurfaceMesh made = MeshSurfaces(MakeBar(), options, ranks);
    EXPECT_EQ(FindGeometryDifference(made.Merged, alone.Merged), "") << ranks;
  }
}

TEST_P(GivenSides, OfARefinedBracket)
{
  const SurfaceCase c{ { { 16, 16, 14 } },
    { { Turned(BracketBody("bracket", 8.3, 2.9, 5.1), { { 6.7, 4.2, 2.3 } }) } } };
  MesherOptions options = OptionsOf(GetParam());
  options.Refinement = RefinementMode::Automatic;
  options.RefinementBoxes = { { { { 0, 0, 0 } }, { { 8, 16, 14 } }, 1.0 } };
  options.FineInterfaces = false;
  options.MaximumLevel = 1;
  const SurfaceMesh alone = MeshSurfaces(c, options);
  EXPECT_EQ(alone.Report.Levels.size(), 2u);
  EXPECT_LT(ExpectPatches(c, alone), 0.05);
  for (int ranks : { 2, 3 })
  {
    const SurfaceMesh made = MeshSurfaces(c, options, ranks);
    EXPECT_EQ(FindGeometryDifference(made.Merged, alone.Merged), "") << ranks;
  }
}

INSTANTIATE_TEST_SUITE_P(All, GivenSides, ::testing::ValuesIn(Methods),
  [](const ::testing::TestParamInfo<Method>& info) { return info.param.Name; });

} // namespace
