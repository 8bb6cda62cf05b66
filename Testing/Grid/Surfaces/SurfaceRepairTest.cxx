/// Steps of the repair of surfaces, and bodies.
#include "LooseTriangles.h"
#include "Ranks/Errors.h"
#include "Surfaces/InputSurfaces.h"
#include "Surfaces/NestedParts.h"
#include "Surfaces/OrientTriangles.h"
#include "Surfaces/PatchTriangles.h"
#include "Surfaces/RepeatedTriangles.h"
#include "Surfaces/SplitEdges.h"
#include "Surfaces/SurfaceEdges.h"
#include "Surfaces/WeldPoints.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

PatchTriangles Sort(const LooseTriangles& input)
{
  std::vector<PatchTriangle> triangles;
  for (const PointTriangle& t : input.Triangles)
  {
    triangles.push_back({ t, 0 });
  }
  return SortTriangles(input.Points, triangles);
}

TEST(SurfaceRepair, SortsTriangles)
{
  const PatchTriangles cube = Sort(Separate(MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } })));
  EXPECT_EQ(cube.Points.size(), 8u);
  EXPECT_EQ(cube.Triangles.size(), 12u);
  for (const PatchTriangle& triangle : cube.Triangles)
  {
    EXPECT_EQ(triangle.Corners[0], triangle.Sorted()[0]);
  }
  EXPECT_EQ(FormatPlace({ { 0, 1.0 / 3.0, -1e10 } }), "(0, 0.333333, -1e+10)");
}

TEST(SurfaceRepair, FindsEdges)
{
  PatchTriangles cube = Sort(MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } }));
  const std::vector<TriangleSide> sides = SortSides(cube);
  EXPECT_EQ(sides.size(), 36u);
  EXPECT_TRUE(FindOddEdges(sides).empty());
  EXPECT_NO_THROW(CheckEdges(cube, sides));
  cube.Triangles.pop_back();
  EXPECT_EQ(FindOddEdges(SortSides(cube)).size(), 3u);
  EXPECT_THROW(CheckEdges(cube, SortSides(cube)), InputError);
}

TEST(SurfaceRepair, FindsClosePairsAcrossCells)
{
  std::vector<Vector3> points{ { { 0, 0, 0 } }, { { 100, 100, 100 } } };
  std::vector<Index> chosen{ 0, 1 };
  for (int i = 0; i < 400; ++i) // pairs 0.01 apart, everywhere in the cells of the search
  {
    for (double more : { 0.0, 0.01 })
    {
      points.push_back({ { 0.137 * i + 0.03 + more, 50.0 + 0.0021 * i, 0.211 * i } });
      chosen.push_back(static_cast<Index>(chosen.size()));
    }
  }
  std::set<std::pair<Index, Index>> found;
  ForClosePairs(points, chosen, 0.011, [&](Index a, Index b) { found.insert({ a, b }); });
  EXPECT_EQ(found.size(), 400u);
  EXPECT_EQ(found.count({ 2, 3 }), 1u);
  PatchTriangles apart = Sort(Separate(MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } })));
  EXPECT_EQ(WeldPoints(0.1, FindOddEdges(SortSides(apart)), apart), 0);
  EXPECT_DOUBLE_EQ(FindDiagonal(apart.Points), std::sqrt(3.0));
}

TEST(SurfaceRepair, DropsRepeatedTriangles)
{
  const LooseTriangles box = MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } });
  PatchTriangles twice = Sort(Join(box, box));
  const DroppedTriangles repeated = DropRepeated(twice);
  EXPECT_EQ(repeated.Repeated, 12);
  EXPECT_EQ(twice.Triangles.size(), 12u);
  for (bool isTurned : { false, true })
  {
    PatchTriangles walls = Sort(Join(box, MakeBox({ { 1, 0, 0 } }, { { 2, 1, 1 } }, isTurned)));
    const DroppedTriangles dropped = DropRepeated(walls);
    EXPECT_EQ(dropped.Repeated, 0);
    EXPECT_EQ(dropped.BackToBack, 4);
    EXPECT_EQ(walls.Triangles.size(), 20u);
  }
}

TEST(SurfaceRepair, DividesEdges)
{
  LooseTriangles flat{ { { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 1, 1, 0 } }, { { 1, 0, 0 } },
                         { { 1, -1, 0 } } },
    { { { 0, 1, 2 } }, { { 0, 4, 3 } }, { { 3, 4, 1 } } } };
  PatchTriangles surface = Sort(flat);
  EXPECT_EQ(SplitOpenEdges(1e-6, surface), 1);
  EXPECT_EQ(surface.Triangles.size(), 4u);
  EXPECT_EQ(FindOddEdges(SortSides(surface)).size(), 4u);
}

TEST(SurfaceRepair, FindsPartsAndCavities)
{
  const PatchTriangles surface = Sort(Join(MakeBox({ { 0, 0, 0 } }, { { 4, 4, 4 } }),
    Join(MakeBox({ { 1, 1, 1 } }, { { 2, 2, 2 } }), MakeBox({ { 5, 0, 0 } }, { { 6, 1, 1 } }))));
  const SurfaceParts parts = FindParts(surface, SortSides(surface));
  EXPECT_EQ(parts.Count, 3);
  EXPECT_EQ(FindCavities(surface, parts, 1e-6), (std::vector<bool>{ false, true, false }));
}

TEST(MakeBody, DropsPatchesWithoutTriangles)
{
  const LooseTriangles box = MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } });
  std::vector<int> patches(12, 3);
  patches[0] = patches[1] = 1; // x = 0
  std::string note = "before";
  const BodySurface body = MakeBody(
    "a", box.Points, box.Triangles, patches, { "none", "low", "also none", "rest" }, &note);
  EXPECT_EQ(body.Name, "a");
  EXPECT_EQ(body.PatchNames, (std::vector<std::string>{ "low", "rest" }));
  EXPECT_EQ(note, "");
  for (std::size_t t = 0; t < body.Patches.size(); ++t)
  {
    double most = 0.0;
    for (Index p : body.Boundary.Triangles[t])
    {
      most = std::max(most, body.Boundary.Points[p][0]);
    }
    EXPECT_EQ(body.Patches[t], most > 0.0 ? 1 : 0);
  }
  EXPECT_THROW(MakeBody("a", box.Points, box.Triangles, patches, { "one" }), InputError);
  EXPECT_THROW(MakeBody("a", box.Points, box.Triangles, { 0 }), InputError);
}

} // namespace
