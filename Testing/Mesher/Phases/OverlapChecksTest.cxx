/// The check of overlaps finds elements that overlap, and none where they only touch.
#include "OverlapChecks.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns elements without common points, all of whose points lie next to unmeshed void.
Mesh MakeElements(int corners, const std::vector<Vector3>& points)
{
  Mesh mesh;
  mesh.Corners = corners;
  const Index count = static_cast<Index>(points.size());
  mesh.ResizePoints(count);
  mesh.ResizeElements(count / corners);
  for (Index p = 0; p < count; ++p)
  {
    mesh.SetPoint(p, points[p], p + 1);
    mesh.Elements[p] = p;
  }
  for (Index e = 0; e < count / corners; ++e)
  {
    mesh.ElementIds[e] = e + 1;
    mesh.Material[e] = 1;
  }
  const Index facets = count / mesh.CornersOfFacet() + 1; // all points
  mesh.Surfaces.Points = Buffer<Index>(mesh.CornersOfFacet() * facets, count - 1);
  std::iota(mesh.Surfaces.Points.data(), mesh.Surfaces.Points.data() + count, Index(0));
  mesh.Surfaces.SurfaceId = Buffer<int>(facets, 1);
  mesh.Surfaces.MaterialPair = Buffer<int>(2 * facets, 0);
  mesh.Surfaces.DomainSide = Buffer<int>(facets, -1);
  return mesh;
}

/// Adds a unit cube in VTK's order. Its lower and upper faces are saddles of this height.
void AddCube(const Vector3& lower, double saddle, std::vector<Vector3>& points)
{
  const double x[4] = { 0, 1, 1, 0 }, y[4] = { 0, 0, 1, 1 };
  for (int c = 0; c < 8; ++c)
  {
    points.push_back({ { lower[0] + x[c % 4], lower[1] + y[c % 4],
      lower[2] + c / 4 + (c % 2 == 0 ? saddle : 0.0) } });
  }
}

double DepthOfCubes(const Vector3& second, double saddle = 0.0)
{
  std::vector<Vector3> points;
  AddCube({ { 0, 0, 0 } }, saddle, points);
  AddCube(second, saddle, points);
  return FindElementOverlaps(MakeElements(8, points)).Depth;
}

double DepthOfTets(const Vector3& shift)
{
  std::vector<Vector3> points{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  for (int c = 0; c < 4; ++c)
  {
    points.push_back(
      { { points[c][0] + shift[0], points[c][1] + shift[1], points[c][2] + shift[2] } });
  }
  return FindElementOverlaps(MakeElements(4, points)).Depth;
}

} // namespace

TEST(OverlapChecks, CubesThatTouchDoNotOverlap)
{
  EXPECT_EQ(DepthOfCubes({ { 1, 0, 0 } }), 0.0);
  EXPECT_EQ(DepthOfCubes({ { 1, 1, 0.5 } }), 0.0);
  EXPECT_EQ(DepthOfCubes({ { 0, 0, 1 } }, 0.3), 0.0); // two saddles that fit
  EXPECT_EQ(DepthOfCubes({ { 3, 0, 0 } }), 0.0);
}

// Two hexes with a common edge, which are 1e4 times smaller than their distance from the origin.
TEST(OverlapChecks, FarFromTheOrigin)
{
  const std::vector<Vector3> points{
    { { 0.05383952354304021, -0.10168144058954863, -0.055993900298530908 } },
    { { 0.053841206976223563, -0.10167717610764518, -0.055976068510579936 } },
    { { 0.053841410148728466, -0.1016740960788854, -0.055974417161845154 } },
    { { 0.053838394567965443, -0.10168200140871832, -0.055994724157209373 } },
    { { 0.053837807263883722, -0.10168214600457851, -0.055667722321465149 } },
    { { 0.053838745761245033, -0.10168215074610766, -0.055667507587977408 } },
    { { 0.053839814865010681, -0.10168104701392194, -0.055663458629938441 } },
    { { 0.053833077815053525, -0.10168022044097265, -0.055665208854333521 } },
    { { 0.053838394567965443, -0.10168200140871832, -0.055994724157209373 } },
    { { 0.053844063041347472, -0.10167606866384321, -0.055989712949028235 } },
    { { 0.053842845623008041, -0.10167054250215056, -0.055989813607013258 } },
    { { 0.053837948392541635, -0.10168063411913016, -0.055992569481087121 } },
    { { 0.053841410148728466, -0.1016740960788854, -0.055974417161845154 } },
    { { 0.053848253596720033, -0.10168176082796782, -0.055979815341423697 } },
    { { 0.053846098615653828, -0.10167044450002276, -0.055976489747812636 } },
    { { 0.053841404726086187, -0.10167406589352633, -0.055974456918386345 } }
  };
  EXPECT_EQ(FindElementOverlaps(MakeElements(8, points)).Depth, 0.0);
}

TEST(OverlapChecks, CubesThatOverlap)
{
  EXPECT_NEAR(DepthOfCubes({ { 1 - 1e-6, 0.2, 0.1 } }), 1e-6, 1e-7);
  EXPECT_GT(DepthOfCubes({ { 0.3, 0.4, 0.5 } }), 0.05);
  EXPECT_GT(DepthOfCubes({ { 0, 0, 1 - 1e-3 } }, 0.3), 1e-4);
}

TEST(OverlapChecks, Tets)
{
  EXPECT_EQ(DepthOfTets({ { 0.5, 0.5, 0 } }), 0.0); // edge on edge
  EXPECT_EQ(DepthOfTets({ { 0, 0, 1 } }), 0.0);     // corner on corner
  EXPECT_GT(DepthOfTets({ { 0.1, 0.1, 0.1 } }), 0.1);
  EXPECT_GT(DepthOfTets({ { 0.5 - 1e-6, 0.5 - 1e-6, 0 } }), 1e-7);
}

TEST(OverlapChecks, CoincidentPoints)
{
  std::vector<Vector3> points;
  AddCube({ { 0, 0, 0 } }, 0.0, points);
  AddCube({ { 1, 0, 0 } }, 0.0, points);
  EXPECT_EQ(CountCoincidentPoints(MakeElements(8, points)), 4);
}
