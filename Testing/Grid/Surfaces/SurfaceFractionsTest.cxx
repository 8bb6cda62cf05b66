/**
 * Volume fractions of solids inside closed surfaces, compared with a sum over all triangles in one
 * cell at a time.
 */
#include "Surfaces/SurfaceFractions.h"

#include "Base/ThreadRuntime.h"
#include "Base/Vector3.h"
#include "RandomDraw.h"
#include "SurfaceCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using NodeLists = std::array<std::vector<double>, 3>;
using Polygon = std::vector<Vector3>;

/// Returns the part of a polygon with sign * x[axis] <= sign * value.
Polygon Clip(const Polygon& polygon, int axis, double value, double sign)
{
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double heightA = sign * (a[axis] - value), heightB = sign * (b[axis] - value);
    if (heightA <= 0.0)
    {
      part.push_back(a);
    }
    if ((heightA <= 0.0) != (heightB <= 0.0))
    {
      part.push_back(a + heightA / (heightA - heightB) * (b - a));
    }
  }
  return part;
}

/// Returns the integral of depth(x) over the projection of a polygon to the yz plane.
template <class Depth>
double Integrate(const Polygon& polygon, const Depth& depth)
{
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    const Vector3 &a = polygon[0], &b = polygon[i], &c = polygon[i + 1];
    sum += 0.5 * Cross(b - a, c - a)[0] * depth((a[0] + b[0] + c[0]) / 3.0);
  }
  return sum;
}

/// Returns the fraction of a solid in a box: each triangle adds the volume in its shadow.
double ReferenceFraction(const ClosedSurface& surface, const Vector3& lower, const Vector3& upper)
{
  const Vector3 width = upper - lower;
  double sum = 0.0;
  for (const Triangle& triangle : PlaceTriangles(surface))
  {
    Polygon part(triangle.begin(), triangle.end());
    for (int axis = 1; axis < 3; ++axis)
    {
      part = Clip(Clip(part, axis, lower[axis], -1.0), axis, upper[axis], 1.0);
    }
    sum += Integrate(Clip(Clip(part, 0, lower[0], -1.0), 0, upper[0], 1.0),
      [&](double x) { return x - lower[0]; });
    sum += Integrate(Clip(part, 0, upper[0], -1.0), [&](double) { return width[0]; });
  }
  return sum / (width[0] * width[1] * width[2]);
}

NodeLists UniformNodes(const Index3& counts, const Vector3& lower, const Vector3& upper)
{
  NodeLists nodes;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= counts[a]; ++i)
    {
      nodes[a].push_back(lower[a] + static_cast<double>(i) / counts[a] * (upper[a] - lower[a]));
    }
  }
  return nodes;
}

/// Returns nodes with random distances.
NodeLists RandomNodes(RandomDraw& draw, Index count)
{
  NodeLists nodes;
  for (std::vector<double>& x : nodes)
  {
    x.push_back(draw.Between(-1.0, -0.8));
    for (Index i = 0; i < count; ++i)
    {
      x.push_back(x.back() + draw.Scale(0.03, 0.6));
    }
  }
  return nodes;
}

IndexBox AllCells(const NodeLists& nodes)
{
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    cells.Upper[a] = static_cast<Index>(nodes[a].size()) - 1;
  }
  return cells;
}

IndexBox DrawPart(const IndexBox& all, RandomDraw& draw)
{
  IndexBox part;
  for (int a = 0; a < 3; ++a)
  {
    part.Lower[a] = draw.Whole(0, static_cast<int>(all.Upper[a]) - 1);
    part.Upper[a] = draw.Whole(static_cast<int>(part.Lower[a]) + 1, static_cast<int>(all.Upper[a]));
  }
  return part;
}

InputSurfaces BodiesOf(const std::vector<ClosedSurface>& surfaces)
{
  InputSurfaces input;
  for (const ClosedSurface& surface : surfaces)
  {
    input.Bodies.push_back({ "body", surface, {}, {} });
  }
  return input;
}

std::vector<double> FractionsIn(
  const NodeLists& nodes, const IndexBox& cells, const ClosedSurface& surface, int threads = 1)
{
  ThreadRuntime runtime(threads);
  const std::vector<Buffer<double>> found =
    FractionsOfSurfaces(nodes, cells, BodiesOf({ surface }), runtime);
  return std::vector<double>(found[0].begin(), found[0].end());
}

ClosedSurface Turned(ClosedSurface surface, const Vector3& axis, double angle)
{
  const Vector3 n = Unit(axis);
  for (Vector3& p : surface.Points)
  {
    p =
      std::cos(angle) * p + std::sin(angle) * Cross(n, p) + (1.0 - std::cos(angle)) * Dot(n, p) * n;
  }
  return surface;
}

/// Compares all cells with the reference. Returns the number of cells that are neither 0 nor 1.
int ExpectReference(const NodeLists& nodes, const ClosedSurface& surface)
{
  const IndexBox cells = AllCells(nodes);
  const std::vector<double> found = FractionsIn(nodes, cells, surface);
  int cut = 0;
  for (Index i = 0; i < cells.NumberOfCells(); ++i)
  {
    const Index3 cell = CellInBox(cells, i);
    Vector3 lower, upper;
    for (int a = 0; a < 3; ++a)
    {
      lower[a] = nodes[a][cell[a]];
      upper[a] = nodes[a][cell[a] + 1];
    }
    EXPECT_NEAR(found[i], ReferenceFraction(surface, lower, upper), 1e-12) << TextOf(cell);
    cut += found[i] != 0.0 && found[i] != 1.0;
  }
  return cut;
}

double VolumeOf(const NodeLists& nodes, const std::vector<double>& fractions)
{
  const IndexBox cells = AllCells(nodes);
  double sum = 0.0;
  for (Index i = 0; i < cells.NumberOfCells(); ++i)
  {
    const Index3 c = CellInBox(cells, i);
    double volume = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      volume *= nodes[a][c[a] + 1] - nodes[a][c[a]];
    }
    sum += fractions[i] * volume;
  }
  return sum;
}

} // namespace

TEST(SurfaceFractions, EqualTheSumOverTrianglesInEachCell)
{
  RandomDraw draw(3);
  const NodeLists uniform = UniformNodes({ { 9, 8, 7 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  for (int i = 0; i < 6; ++i)
  {
    const ClosedSurface box =
      BoxSurface(draw.Vector(-0.8, -0.1), draw.Vector(0.1, 0.8), draw.Whole(1, 4));
    EXPECT_GT(ExpectReference(uniform, box), 50);
    EXPECT_GT(ExpectReference(uniform, Turned(box, draw.Vector(-1, 1), draw.Between(0, 3))), 50);
    EXPECT_GT(ExpectReference(RandomNodes(draw, 8), Turned(box, draw.Vector(-1, 1), 1.0)), 20);
  }
  const ClosedSurface ball = SphereSurface({ { 0.01, 0.02, 0.03 } }, 0.7, 16); // 960 triangles
  EXPECT_GT(ExpectReference(uniform, ball), 100);
  EXPECT_GT(ExpectReference(RandomNodes(draw, 8), ball), 50);
  const ClosedSurface hollow = Together(ball, Reversed(SphereSurface({ { 0, 0, 0 } }, 0.4, 8)));
  EXPECT_GT(ExpectReference(uniform, hollow), 100);
}

/// Faces, edges and corners of the box lie on planes of the grid.
TEST(SurfaceFractions, CellsWithoutSurfaceInsideAreExactlyFullOrEmpty)
{
  const NodeLists nodes = UniformNodes({ { 10, 10, 10 } }, { { 0, 0, 0 } }, { { 1, 1, 1 } });
  const auto at = [&](Index i, Index j, Index k) {
    return Vector3{ { nodes[0][i], nodes[1][j], nodes[2][k] } };
  };
  const IndexBox inner{ { { 2, 3, 1 } }, { { 7, 9, 8 } } };
  for (int parts : { 1, 3, 7 })
  {
    const std::vector<double> found =
      FractionsIn(nodes, AllCells(nodes), BoxSurface(at(2, 3, 1), at(7, 9, 8), parts));
    for (Index i = 0; i < 1000; ++i)
    {
      const Index3 cell = CellInBox(AllCells(nodes), i);
      EXPECT_EQ(found[i], inner.Contains(cell) ? 1.0 : 0.0) << TextOf(cell);
    }
  }
}

/// Faces of boxes differ from planes of the grid by rounding.
TEST(SurfaceFractions, FacesNextToPlanesLeaveNoSlivers)
{
  RandomDraw draw(8);
  for (int run = 0; run < 50; ++run)
  {
    const NodeLists nodes = RandomNodes(draw, 7);
    const IndexBox inner{ { { 1, 2, 1 } }, { { 5, 4, 6 } } };
    Vector3 lower, upper;
    for (int a = 0; a < 3; ++a)
    {
      lower[a] = nodes[a][inner.Lower[a]] * (1.0 + draw.Whole(-3, 3) * 0x1p-52);
      upper[a] = nodes[a][inner.Upper[a]] * (1.0 + draw.Whole(-3, 3) * 0x1p-52);
    }
    const std::vector<double> found =
      FractionsIn(nodes, AllCells(nodes), BoxSurface(lower, upper, 1 + run % 5));
    for (Index i = 0; i < AllCells(nodes).NumberOfCells(); ++i)
    {
      const Index3 cell = CellInBox(AllCells(nodes), i);
      EXPECT_EQ(found[i], inner.Contains(cell) ? 1.0 : 0.0) << TextOf(cell);
    }
  }
}

TEST(SurfaceFractions, SolidsFarFromTheOrigin)
{
  const Vector3 far{ { 1e6, -2e6, 3e6 } };
  NodeLists nodes = UniformNodes({ { 9, 9, 9 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  ClosedSurface box =
    Turned(BoxSurface({ { -0.7, -0.6, -0.5 } }, { { 0.6, 0.7, 0.8 } }, 5), { { 1, 2, 3 } }, 0.7);
  const std::vector<double> near = FractionsIn(nodes, AllCells(nodes), box);
  for (int a = 0; a < 3; ++a)
  {
    for (double& x : nodes[a])
    {
      x += far[a];
    }
  }
  for (Vector3& point : box.Points)
  {
    point = point + far;
  }
  const std::vector<double> found = FractionsIn(nodes, AllCells(nodes), box);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], near[i], 1e-7) << i;
    EXPECT_TRUE(near[i] != 1.0 || found[i] == 1.0) << i;
  }
}

TEST(SurfaceFractions, SolidsMayExtendBeyondTheGrid)
{
  RandomDraw draw(5);
  const NodeLists nodes = UniformNodes({ { 6, 5, 7 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  for (int side = 0; side < 6; ++side)
  {
    Vector3 centre = draw.Vector(-0.1, 0.1);
    centre[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
    EXPECT_GT(ExpectReference(nodes, SphereSurface(centre, 0.6, 8)), 20) << "side " << side;
    Vector3 lower{ { -0.5, -0.4, -0.3 } }, upper{ { 0.3, 0.4, 0.5 } };
    (side % 2 == 0 ? lower : upper)[side / 2] *= 1e3;
    EXPECT_GT(ExpectReference(nodes, BoxSurface(lower, upper)), 20) << "side " << side;
    Vector3 outside{ { 0, 0, 0 } };
    outside[side / 2] = side % 2 == 0 ? -3.0 : 3.0;
    EXPECT_EQ(
      VolumeOf(nodes, FractionsIn(nodes, AllCells(nodes), SphereSurface(outside, 1.9, 8))), 0.0)
      << "side " << side;
  }
  const ClosedSurface around = BoxSurface({ { -9, -8, -7 } }, { { 7, 8, 9 } });
  EXPECT_EQ(ExpectReference(nodes, around), 0);
  EXPECT_EQ(FractionsIn(nodes, AllCells(nodes), around), std::vector<double>(210, 1.0));
}

TEST(SurfaceFractions, DependOnNeitherBoxNorThreads)
{
  const NodeLists nodes = UniformNodes({ { 31, 37, 29 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  const ClosedSurface surface = Together(
    Turned(BoxSurface({ { -0.7, -0.6, -1.5 } }, { { 0.6, 0.7, 0.8 } }, 3), { { 1, 2, 3 } }, 0.7),
    Reversed(SphereSurface({ { 0, 0.01, 0 } }, 0.5, 12)));
  const IndexBox all = AllCells(nodes);
  const std::vector<double> whole = FractionsIn(nodes, all, surface);
  EXPECT_EQ(whole, FractionsIn(nodes, all, surface, 2));
  EXPECT_EQ(whole, FractionsIn(nodes, all, surface, 7));
  RandomDraw draw(1);
  for (int i = 0; i < 20; ++i)
  {
    const IndexBox part = DrawPart(all, draw);
    const std::vector<double> found = FractionsIn(nodes, part, surface);
    for (Index n = 0; n < part.NumberOfCells(); ++n)
    {
      EXPECT_EQ(found[n], whole[IndexInBox(all, CellInBox(part, n))]);
    }
  }
  EXPECT_TRUE(FractionsIn(nodes, {}, surface).empty());
}

TEST(SurfaceFractions, VolumesAreExact)
{
  const ClosedSurface ball =
    Turned(SphereSurface({ { 0.3, -0.2, 0.1 } }, 0.5, 20), { { 1, 2, 3 } }, 0.3);
  for (Index n : { 5, 23, 64 })
  {
    const NodeLists nodes = UniformNodes({ { n, n, n } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
    EXPECT_NEAR(
      VolumeOf(nodes, FractionsIn(nodes, AllCells(nodes), ball)), MeasureVolume(ball), 1e-13);
  }
}

/// One body whose parts overlap: the overlap counts once.
TEST(SurfaceFractions, OverlapsOfOneBodyCountOnce)
{
  const NodeLists nodes = UniformNodes({ { 20, 20, 20 } }, { { 0, 0, 0 } }, { { 20, 20, 20 } });
  const ClosedSurface both = Together(BoxSurface({ { 2, 2, 2 } }, { { 12, 12, 12 } }),
    BoxSurface({ { 6.5, 4.5, 4.5 } }, { { 18, 10, 10 } }));
  const std::vector<double> found = FractionsIn(nodes, AllCells(nodes), both);
  EXPECT_NEAR(VolumeOf(nodes, found), 1000.0 + 6.0 * 5.5 * 5.5, 1e-11);
}

TEST(SurfaceFractions, HugeAndTinyTrianglesAreFinite)
{
  const auto tetrahedron = [](double length)
  {
    return CloseSurface(
      { { { 0, 0, 0 } }, { { length, 0, 0 } }, { { 0, length, 0 } }, { { 0, 0, length } } },
      { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 0, 3, 2 } } });
  };
  const NodeLists unit = UniformNodes({ { 3, 3, 3 } }, { { 0, 0, 0 } }, { { 1, 1, 1 } });
  EXPECT_EQ(VolumeOf(unit, FractionsIn(unit, AllCells(unit), tetrahedron(1e-310))), 0.0);
  EXPECT_EQ(FractionsIn(unit, AllCells(unit), tetrahedron(1e60)), std::vector<double>(27, 1.0));
  const NodeLists large = UniformNodes({ { 1, 1, 1 } }, { { 0, 0, 0 } }, { { 1e60, 1e60, 1e60 } });
  EXPECT_NEAR(FractionsIn(large, AllCells(large), tetrahedron(1e60))[0], 1.0 / 6.0, 1e-14);
}

/// Returns the fractions of several bodies.
std::vector<std::vector<double>> FractionsOf(const NodeLists& nodes, const IndexBox& cells,
  const std::vector<ClosedSurface>& bodies, int threads = 1)
{
  ThreadRuntime runtime(threads);
  std::vector<std::vector<double>> lists;
  for (const Buffer<double>& found : FractionsOfSurfaces(nodes, cells, BodiesOf(bodies), runtime))
  {
    lists.emplace_back(found.begin(), found.end());
  }
  return lists;
}

/// Returns the fractions of each body alone, limited to what the earlier ones leave.
std::vector<std::vector<double>> LimitedFractions(
  const NodeLists& nodes, const IndexBox& cells, const std::vector<ClosedSurface>& bodies)
{
  Runtime runtime;
  std::vector<Buffer<double>> limited;
  for (const ClosedSurface& body : bodies)
  {
    limited.push_back(std::move(FractionsOfSurfaces(nodes, cells, BodiesOf({ body }), runtime)[0]));
  }
  LimitSums(limited, runtime);
  std::vector<std::vector<double>> lists;
  for (const Buffer<double>& values : limited)
  {
    lists.emplace_back(values.begin(), values.end());
  }
  return lists;
}

/// Walls of a block that is divided by planes at random places: parts that touch in whole faces.
TEST(SurfaceFractions, PartsInContactFillTheirCells)
{
  RandomDraw draw(9);
  const NodeLists nodes = RandomNodes(draw, 12);
  std::vector<ClosedSurface> parts;
  const Vector3 axis{ { 1, 2, 3 } };
  for (int i = 0; i < 10; ++i)
  {
    const double begin = -5.0 + i, end = i < 9 ? begin + 1.0 : 30.0;
    const ClosedSurface box = BoxSurface({ { begin, -20, -20 } }, { { end, 20, 20 } }, i + 1);
    parts.push_back(Turned(box, axis, 0.7));
    for (Vector3& point : parts.back().Points)
    {
      point = 0.1 * point;
    }
  }
  const IndexBox cells = AllCells(nodes);
  const std::vector<std::vector<double>> found = FractionsOf(nodes, cells, parts);
  EXPECT_EQ(found, LimitedFractions(nodes, cells, parts));
  int shared = 0;
  for (Index i = 0; i < cells.NumberOfCells(); ++i)
  {
    double sum = 0.0;
    int present = 0;
    for (const std::vector<double>& values : found)
    {
      sum += values[i];
      present += values[i] > 0.0;
    }
    EXPECT_LE(sum, 1.0 + 1e-15);
    shared += present > 1 && sum > 1.0 - 1e-12;
  }
  EXPECT_GT(shared, 50);
}

/// A pin in a hole of other segments: they overlap in some places and leave gaps in others.
TEST(SurfaceFractions, LaterBodiesGiveWay)
{
  const NodeLists nodes = UniformNodes({ { 12, 20, 20 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  const IndexBox cells = AllCells(nodes);
  const ClosedSurface pin = TubeSurface({ { -0.7, 0, 0 } }, 1.4, 0.5, 0.2, 11);
  const ClosedSurface sleeve = TubeSurface({ { -0.7, 0, 0 } }, 1.4, 0.8, 0.5, 17);
  const ClosedSurface around = BoxSurface({ { -0.9, -0.9, -0.9 } }, { { 0.9, 0.9, 0.9 } });
  const std::vector<double> alone[3] = { FractionsIn(nodes, cells, pin),
    FractionsIn(nodes, cells, sleeve), FractionsIn(nodes, cells, around) };
  const std::vector<std::vector<double>> found = FractionsOf(nodes, cells, { pin, sleeve, around });
  int less = 0;
  for (Index i = 0; i < cells.NumberOfCells(); ++i)
  {
    const double rest = 1.0 - alone[0][i];
    EXPECT_EQ(found[0][i], alone[0][i]);
    EXPECT_LE(found[1][i], std::min(alone[1][i], rest) + 1e-15);
    EXPECT_NEAR(found[2][i], std::min(alone[2][i], rest - found[1][i]), 1e-12);
    less += found[1][i] < std::min(alone[1][i], rest) - 1e-3;
  }
  EXPECT_GT(less, 10);
  // The box is around the others, so the three fill it.
  EXPECT_NEAR(VolumeOf(nodes, found[0]), MeasureVolume(pin), 1e-12);
  EXPECT_NEAR(VolumeOf(nodes, found[0]) + VolumeOf(nodes, found[1]) + VolumeOf(nodes, found[2]),
    MeasureVolume(around), 1e-10);
}

/// No cell has both boundaries.
TEST(SurfaceFractions, InclusionsLeaveTheRest)
{
  const NodeLists nodes = UniformNodes({ { 12, 20, 20 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  const std::vector<ClosedSurface> bodies{ SphereSurface({ { 0.03, 0.1, 0 } }, 0.4, 8),
    BoxSurface({ { -0.87, -0.89, -0.82 } }, { { 0.87, 0.93, 0.92 } }) };
  EXPECT_EQ(
    FractionsOf(nodes, AllCells(nodes), bodies), LimitedFractions(nodes, AllCells(nodes), bodies));
}

/// Boundaries of both bodies cut the same cells, on faces that lie in one plane.
TEST(SurfaceFractions, OverlapsWithFlushSidesHaveNoCoat)
{
  for (double offset : { 0.0, 0.03, 0.1, 0.25, 0.37, 0.5, 0.77, 0.999 })
  {
    const double at = -0.5 - 0.2 * offset; // cells of 0.2
    const NodeLists nodes = UniformNodes(
      { { 21, 18, 16 } }, { { at, at, at - 1.0 } }, { { at + 4.2, at + 3.6, at + 2.2 } });
    const ClosedSurface first = BoxSurface({ { 0, 0, 0 } }, { { 1, 1, 1 } });
    const ClosedSurface second = BoxSurface({ { 0.5, 0, 0 } }, { { 3, 1, 1 } }, 3);
    for (double angle : { 0.0, 0.3 })
    {
      const std::vector<std::vector<double>> found = FractionsOf(nodes, AllCells(nodes),
        { Turned(first, { { 1, 2, 3 } }, angle), Turned(second, { { 1, 2, 3 } }, angle) });
      EXPECT_NEAR(VolumeOf(nodes, found[0]), 1.0, 1e-12);
      EXPECT_NEAR(VolumeOf(nodes, found[1]), 2.0, 0.01) << offset << " " << angle;
    }
  }
}

TEST(SurfaceFractions, OfTwoEqualBodiesTheSecondGetsNothing)
{
  RandomDraw draw(4);
  for (int run = 0; run < 10; ++run)
  {
    const NodeLists nodes = RandomNodes(draw, 10);
    const ClosedSurface ball = SphereSurface(draw.Vector(-0.2, 0.2), 0.6, 9);
    const ClosedSurface box =
      Turned(BoxSurface(draw.Vector(-0.6, -0.2), draw.Vector(0.2, 0.6)), draw.Vector(-1, 1), run);
    for (const ClosedSurface& body : { ball, box })
    {
      const std::vector<std::vector<double>> found =
        FractionsOf(nodes, AllCells(nodes), { body, body });
      EXPECT_EQ(found[1], std::vector<double>(found[1].size(), 0.0));
    }
  }
}

/// Two bodies that cross at an angle, and one inside of the other near its boundary.
TEST(SurfaceFractions, OverlapsOfSpheres)
{
  for (Index n : { 12, 20, 33 })
  {
    const NodeLists nodes = UniformNodes({ { n, n, n } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
    const double r = 0.55, d = 0.6; // distance of the centres along (1, 2, 2) / 3
    const ClosedSurface one = SphereSurface({ { -0.1, -0.2, -0.2 } }, r, 40);
    const ClosedSurface other = SphereSurface({ { 0.1, 0.2, 0.2 } }, r, 40);
    const double lens = M_PI / 12.0 * (4.0 * r + d) * (2.0 * r - d) * (2.0 * r - d);
    const std::vector<std::vector<double>> found =
      FractionsOf(nodes, AllCells(nodes), { one, other });
    EXPECT_NEAR(MeasureVolume(other) - VolumeOf(nodes, found[1]), lens, 0.01 * lens) << n;
    const ClosedSurface inner = SphereSurface({ { 0.25, 0.2, 0.2 } }, 0.39, 12);
    const std::vector<std::vector<double>> nested =
      FractionsOf(nodes, AllCells(nodes), { inner, other });
    EXPECT_NEAR(VolumeOf(nodes, nested[1]), MeasureVolume(other) - MeasureVolume(inner), 1e-4);
  }
}

TEST(SurfaceFractions, OverlapsDependOnNeitherBoxNorThreads)
{
  const NodeLists nodes = UniformNodes({ { 21, 37, 19 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  const std::vector<ClosedSurface> bodies{
    Turned(BoxSurface({ { -0.7, -0.6, -1.5 } }, { { 0.6, 0.7, 0.8 } }, 3), { { 1, 2, 3 } }, 0.7),
    SphereSurface({ { 0.4, 0.01, 0 } }, 0.6, 12),
    BoxSurface({ { -0.7, -0.6, -0.4 } }, { { 1.6, 0.8, 0.8 } })
  };
  const IndexBox all = AllCells(nodes);
  const std::vector<std::vector<double>> whole = FractionsOf(nodes, all, bodies);
  EXPECT_EQ(whole, FractionsOf(nodes, all, bodies, 3));
  RandomDraw draw(2);
  for (int i = 0; i < 20; ++i)
  {
    const IndexBox part = DrawPart(all, draw);
    const std::vector<std::vector<double>> found = FractionsOf(nodes, part, bodies);
    for (Index n = 0; n < part.NumberOfCells(); ++n)
    {
      for (int b = 0; b < 3; ++b)
      {
        EXPECT_EQ(found[b][n], whole[b][IndexInBox(all, CellInBox(part, n))]);
      }
    }
  }
}

TEST(SurfaceFractions, DependNotOnTheOrderOfTriangles)
{
  const NodeLists nodes = UniformNodes({ { 21, 22, 23 } }, { { -1, -1, -1 } }, { { 1, 1, 1 } });
  const ClosedSurface ball = SphereSurface({ { 0.01, 0.02, 0.03 } }, 0.7, 12);
  const auto fractions = [&nodes](const ClosedSurface& surface)
  {
    return FractionsIn(
      nodes, AllCells(nodes), MakeBody("ball", surface.Points, surface.Triangles).Boundary);
  };
  const std::vector<double> first = fractions(ball);
  RandomDraw draw(6);
  for (int run = 0; run < 5; ++run)
  {
    ClosedSurface other = ball;
    std::mt19937 engine(draw.Seed());
    std::shuffle(other.Triangles.begin(), other.Triangles.end(), engine);
    for (PointTriangle& t : other.Triangles)
    {
      std::rotate(t.begin(), t.begin() + draw.Whole(0, 2), t.end());
    }
    EXPECT_NE(other.Triangles, ball.Triangles);
    EXPECT_EQ(fractions(other), first);
  }
}
