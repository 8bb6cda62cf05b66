/// Intersections of facets: which facets intersect, on one rank and several, and pairs of boxes.
#include "Smoothing/Intersections.h"

#include "Base/BoxTree.h"
#include "Base/Vector3.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Flags = std::vector<unsigned char>;
using Corners = std::array<int, 4>;

/// Points in their current and in their start positions, and facets next to void.
struct Sheet
{
  std::vector<Vector3> Points, Starts;
  std::vector<Corners> Facets; // of triangles: the last corner twice

  /// Adds a facet with points of its own.
  void Add(const std::vector<Vector3>& corners)
  {
    Corners facet;
    for (std::size_t c = 0; c < 4; ++c)
    {
      facet[c] = static_cast<int>(this->Points.size() + std::min(c, corners.size() - 1));
    }
    this->Facets.push_back(facet);
    this->Points.insert(this->Points.end(), corners.begin(), corners.end());
  }
};

/// Returns the mesh of the facets with number = rank modulo ranks. Stores the start positions,
/// which are different, in `starts`.
ActiveMesh MakeActive(const Sheet& sheet, std::vector<Vector3>& starts, int rank = 0, int ranks = 1)
{
  ActiveMesh mesh;
  mesh.X = sheet.Points;
  mesh.MeshPoint.resize(sheet.Points.size());
  std::iota(mesh.MeshPoint.begin(), mesh.MeshPoint.end(), 0);
  for (std::size_t p = 0; p < sheet.Points.size(); ++p)
  {
    starts.push_back({ { static_cast<double>(p), 0.0, 0.0 } });
  }
  mesh.MeshPoints = starts[0].data();
  for (std::size_t f = rank; f < sheet.Facets.size(); f += ranks)
  {
    mesh.Facets.push_back({ sheet.Facets[f], { { 1, 0 } } });
  }
  return mesh;
}

Flags FlagsOf(const Sheet& sheet)
{
  std::vector<Vector3> starts;
  Runtime runtime;
  return FindIntersections(MakeActive(sheet, starts), runtime);
}

Index CountIntersecting(const Sheet& sheet)
{
  const Flags flags = FlagsOf(sheet);
  return std::count(flags.begin(), flags.end(), 1);
}

/// Returns the six quads of a cube, or 12 triangles.
Sheet MakeCube(bool hasTriangles)
{
  Sheet cube;
  for (int c = 0; c < 8; ++c)
  {
    cube.Points.push_back({ { 1.0 * (c & 1), 1.0 * (c >> 1 & 1), 1.0 * (c >> 2) } });
  }
  for (const Corners& q :
    { Corners{ { 0, 2, 6, 4 } }, Corners{ { 1, 3, 7, 5 } }, Corners{ { 0, 1, 5, 4 } },
      Corners{ { 2, 3, 7, 6 } }, Corners{ { 0, 1, 3, 2 } }, Corners{ { 4, 5, 7, 6 } } })
  {
    if (hasTriangles)
    {
      cube.Facets.push_back({ { q[0], q[1], q[2], q[2] } });
      cube.Facets.push_back({ { q[0], q[2], q[3], q[3] } });
    }
    else
    {
      cube.Facets.push_back(q);
    }
  }
  return cube;
}

std::vector<Vector3> Square(double x, double y, double z)
{
  return { { { x, y, z } }, { { x + 1, y, z } }, { { x + 1, y + 1, z } }, { { x, y + 1, z } } };
}

/// Returns whether an edge of one triangle passes through the other.
bool DoEdgesCross(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  const auto volume = [](const Vector3& o, const Vector3& x, const Vector3& y, const Vector3& z)
  { return Dot(x - o, Cross(y - o, z - o)); };
  bool cross = false;
  for (int e = 0; e < 3; ++e)
  {
    const Vector3 &p = a[e], &q = a[(e + 1) % 3];
    const double first = volume(p, q, b[0], b[1]), second = volume(p, q, b[1], b[2]),
                 third = volume(p, q, b[2], b[0]);
    cross = cross ||
      (volume(p, b[0], b[1], b[2]) * volume(q, b[0], b[1], b[2]) < 0.0 &&
        (first > 0.0) == (second > 0.0) && (first > 0.0) == (third > 0.0));
  }
  return cross;
}

Sheet MakeRandomSheet(unsigned seed)
{
  RandomDraw draw(seed);
  Sheet sheet;
  for (int f = 0; f < 60; ++f)
  {
    const Vector3 at = draw.Vector(0.0, 4.0);
    std::vector<Vector3> corners;
    for (int c = 0; c < (f % 2 == 0 ? 3 : 4); ++c)
    {
      corners.push_back(at + draw.Vector(0.0, 1.0));
    }
    sheet.Add(corners);
  }
  return sheet;
}

} // namespace

TEST(BoxTree, FindsEachPairOnce)
{
  for (int count : { 0, 1, 2, 17, 500 })
  {
    RandomDraw draw(count);
    std::vector<Bounds> boxes(count);
    for (Bounds& box : boxes)
    {
      box.Add(draw.Vector(0.0, 10.0));
      box.Add(box.Lower + Vector3{ { draw.Between(0.0, 2.0), draw.Between(0.0, 1.0), 0.0 } });
      box.Lower[2] = box.Upper[2] = draw.Whole(0, 4); // flat, many at equal height
    }
    Runtime runtime;
    std::vector<std::pair<Index, Index>> found;
    BoxTree(boxes, runtime)
      .ForPairs(
        runtime, [&](Index i, Index j) { found.emplace_back(std::min(i, j), std::max(i, j)); });
    std::sort(found.begin(), found.end());
    std::vector<std::pair<Index, Index>> expected;
    for (Index i = 0; i < count; ++i)
    {
      for (Index j = i + 1; j < count; ++j)
      {
        if (boxes[i].Touches(boxes[j]))
        {
          expected.emplace_back(i, j);
        }
      }
    }
    EXPECT_EQ(found, expected);
    EXPECT_TRUE(count < 500 || expected.size() > 100u);
  }
}

TEST(Intersections, AreOnlyWhereFacetsPassThroughEachOther)
{
  Sheet sheet;
  sheet.Add(Square(0, 0, 0));
  sheet.Add(Square(0.3, 0.3, 0.1));
  EXPECT_EQ(CountIntersecting(sheet), 0); // one above the other
  sheet.Points[6][2] = -0.01;
  EXPECT_EQ(CountIntersecting(sheet), 0); // a corner beside the other
  sheet.Points[4][2] = -0.1;
  EXPECT_EQ(CountIntersecting(sheet), 8);
  std::vector<Vector3> starts;
  ActiveMesh mesh = MakeActive(sheet, starts);
  mesh.Facets[0].Fragments = { { 1, 2 } }; // not next to void
  Runtime runtime;
  const Flags flags = FindIntersections(mesh, runtime);
  EXPECT_EQ(std::count(flags.begin(), flags.end(), 1), 0);
}

TEST(Intersections, AreFoundBetweenNeighbours)
{
  for (bool hasTriangles : { false, true })
  {
    Sheet cube = MakeCube(hasTriangles);
    EXPECT_EQ(CountIntersecting(cube), 0);
    cube.Points[7] = { { 0.6, 0.6, 0.6 } }; // still apart
    EXPECT_EQ(CountIntersecting(cube), 0);
    cube.Points[7] = { { 0.4, -0.3, 0.4 } }; // through the side y = 0
    EXPECT_GT(CountIntersecting(cube), 4);
  }
}

TEST(Intersections, AreWherePointsCoincide)
{
  Sheet sheet;
  sheet.Add(Square(0, 0, 0));
  sheet.Add(Square(1, 1, 0));
  EXPECT_EQ(CountIntersecting(sheet), 8);
  sheet.Facets[1][0] = 2; // the same point
  EXPECT_EQ(CountIntersecting(sheet), 0);
}

TEST(Intersections, OfTrianglesAreWhereTheirEdgesCross)
{
  RandomDraw draw(1);
  Index crossing = 0;
  for (int pair = 0; pair < 2000; ++pair)
  {
    std::vector<Vector3> a, b;
    for (int c = 0; c < 3; ++c)
    {
      a.push_back(draw.Vector(0.0, 1.0));
      b.push_back(draw.Vector(0.1, 1.1));
    }
    Sheet sheet;
    sheet.Add(a);
    sheet.Add(b);
    const bool expected = DoEdgesCross(a, b) || DoEdgesCross(b, a);
    EXPECT_EQ(CountIntersecting(sheet), expected ? 6 : 0) << pair;
    crossing += expected;
  }
  EXPECT_GT(crossing, 200);
}

/// Facets of several ranks cross too.
TEST(Intersections, AreTheSameOnAnyRanks)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    const Sheet sheet = MakeRandomSheet(seed);
    const Flags expected = FlagsOf(sheet);
    ASSERT_GT(std::count(expected.begin(), expected.end(), 1), 5);
    for (int count : { 2, 3 })
    {
      std::vector<Flags> found(count);
      RunOnRanks(count,
        [&](Ranks& ranks)
        {
          std::vector<Vector3> starts;
          RankRuntime runtime(ranks);
          found[ranks.Rank()] =
            FindIntersections(MakeActive(sheet, starts, ranks.Rank(), count), runtime);
        });
      for (std::size_t p = 0; p < expected.size(); ++p)
      {
        unsigned char flag = 0;
        for (const Flags& flags : found)
        {
          flag |= flags[p];
        }
        EXPECT_EQ(flag, expected[p]) << p;
      }
    }
  }
}
