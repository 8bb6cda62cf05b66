/// Overlaps of elements with cells, compared with bodies cut plane by plane; whole meshes are
/// compared with the cells that they fill.
#include "State/Transfer/Overlaps.h"
#include "State/Transfer/RegularTets.h"

#include "Base/ConvexClip.h"
#include "Base/HexNumbering.h"
#include "Base/Vector3.h"
#include "MeshCases.h"
#include "RandomDraw.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Body
{
  double Volume = 0.0;
  Vector3 Moment{};
};

/// A mesh built element by element.
class ElementList
{
public:
  explicit ElementList(int corners) : Corners(corners) {}

  void Add(const std::vector<Vector3>& points)
  {
    this->Points.insert(this->Points.end(), points.begin(), points.end());
  }

  Mesh AsMesh() const
  {
    Mesh mesh;
    mesh.Corners = this->Corners;
    mesh.Points = Buffer<double>(3 * this->Points.size());
    mesh.Elements = Buffer<Index>(this->Points.size());
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      std::copy(this->Points[p].begin(), this->Points[p].end(), mesh.Points.data() + 3 * p);
      mesh.Elements[p] = static_cast<Index>(p);
    }
    return mesh;
  }

  /// Returns the tets of an element. A hex is divided from its mean to the triangles of its faces.
  std::vector<std::array<Vector3, 4>> TetsOf(Index element) const
  {
    const Vector3* x = this->Points.data() + this->Corners * element;
    if (this->Corners == 4)
    {
      return { { x[0], x[1], x[2], x[3] } };
    }
    Vector3 middle{};
    for (int c = 0; c < 8; ++c)
    {
      middle = middle + 0.125 * x[c];
    }
    std::vector<std::array<Vector3, 4>> tets;
    for (const auto& face : FaceCorners)
    {
      Vector3 mean{};
      for (int c : face)
      {
        mean = mean + 0.25 * x[VtkCorner[c]];
      }
      for (int e = 0; e < 4; ++e)
      {
        tets.push_back({ x[VtkCorner[face[e]]], x[VtkCorner[face[(e + 1) % 4]]], mean, middle });
      }
    }
    return tets;
  }

private:
  int Corners;
  std::vector<Vector3> Points;
};

ConvexPiece PieceOf(const std::array<Vector3, 4>& tet)
{
  ConvexPiece piece;
  const bool turned = Dot(tet[1] - tet[0], Cross(tet[2] - tet[0], tet[3] - tet[0])) < 0.0;
  for (const auto& face : { std::array<int, 3>{ 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } })
  {
    for (int c = 0; c < 3; ++c)
    {
      piece.Points.push_back(tet[face[turned ? 2 - c : c]]);
    }
    piece.Ends.push_back(piece.Points.size());
  }
  return piece;
}

Body Measure(const ConvexPiece& piece)
{
  Body body;
  std::size_t first = 0;
  for (std::size_t end : piece.Ends)
  {
    for (std::size_t i = first + 1; i + 1 < end; ++i)
    {
      const Vector3 &o = piece.Points[0], &a = piece.Points[first], &b = piece.Points[i],
                    &c = piece.Points[i + 1];
      const double volume = Dot(a - o, Cross(b - o, c - o)) / 6.0;
      body.Volume += volume;
      body.Moment = body.Moment + 0.25 * volume * (o + a + b + c);
    }
    first = end;
  }
  return body;
}

/// Cuts tets with the planes of the cell.
Body CutByHand(
  const std::vector<std::array<Vector3, 4>>& tets, const CartesianGrid& grid, const Index3& cell)
{
  Body sum;
  for (const auto& tet : tets)
  {
    ConvexPiece piece = PieceOf(tet), inside, outside;
    std::vector<Vector3> section;
    for (int a = 0; a < 3; ++a)
    {
      Vector3 normal{};
      for (int side : { 0, 1 })
      {
        normal[a] = side == 0 ? -1.0 : 1.0;
        ClipPiece(piece, { normal, normal[a] * grid.Coordinates(a)[cell[a] + side] }, inside,
          outside, section);
        std::swap(piece, inside);
      }
    }
    const Body part = Measure(piece);
    sum.Volume += part.Volume;
    sum.Moment = sum.Moment + part.Moment;
  }
  return sum;
}

std::vector<Index> AllElements(const Mesh& mesh)
{
  std::vector<Index> elements(mesh.Elements.size() / mesh.Corners);
  for (std::size_t e = 0; e < elements.size(); ++e)
  {
    elements[e] = static_cast<Index>(e);
  }
  return elements;
}

/// Compares each part with the same part from CutByHand; no other part may exist.
void CompareWithHand(const ElementList& list, const CartesianGrid& grid)
{
  Runtime runtime;
  const Mesh mesh = list.AsMesh();
  const std::vector<Index> elements = AllElements(mesh);
  const Overlaps overlaps = FindOverlaps(mesh, elements, grid, runtime);
  ASSERT_EQ(overlaps.Offsets.size(), elements.size() + 1);
  ASSERT_EQ(overlaps.Offsets.back(), static_cast<Index>(overlaps.Parts.size()));
  double worst = 0.0, worstMoment = 0.0;
  for (Index e : elements)
  {
    const double whole = VolumeOfElement(mesh, e), size = std::cbrt(whole);
    const auto tets = list.TetsOf(e);
    Index at = overlaps.Offsets[e];
    double sum = 0.0;
    ForCells(grid.Local(),
      [&](const Index3& cell)
      {
        const Body expected = CutByHand(tets, grid, cell);
        OverlapPart part;
        if (at < overlaps.Offsets[e + 1] &&
          overlaps.Parts[at].Cell == IndexInBox(grid.Local(), cell))
        {
          part = overlaps.Parts[at++];
          EXPECT_GT(part.Volume, 0.0);
        }
        sum += part.Volume;
        worst = std::max(worst, std::fabs(part.Volume - expected.Volume) / whole);
        worstMoment = std::max(
          worstMoment, Norm(part.Volume * part.Centroid - expected.Moment) / (whole * size));
        for (int a = 0; part.Volume > 0.0 && a < 3; ++a)
        {
          EXPECT_GE(part.Centroid[a], grid.Coordinates(a)[cell[a]]);
          EXPECT_LE(part.Centroid[a], grid.Coordinates(a)[cell[a] + 1]);
        }
      });
    EXPECT_EQ(at, overlaps.Offsets[e + 1]) << "not ascending, or a cell twice, of element " << e;
    EXPECT_NEAR(sum, whole, 1e-14 * whole);
  }
  EXPECT_LT(worst, 3e-14);
  EXPECT_LT(worstMoment, 3e-13); // coordinates are several times the element size
}

/// Returns a box of the given size whose corners are moved by up to `share` of it.
std::vector<Vector3> DrawHex(RandomDraw& random, const Vector3& lower, double size, double share)
{
  std::vector<Vector3> points(8);
  for (int c = 0; c < 8; ++c)
  {
    const Vector3 unit{ { double(c & 1), double(c >> 1 & 1), double(c >> 2) } };
    points[VtkCorner[c]] = lower + size * (unit + random.Vector(-share, share));
  }
  return points;
}

std::vector<Vector3> DrawTet(RandomDraw& random, const Vector3& lower, double size)
{
  std::vector<Vector3> points(4);
  double volume = 0.0;
  while (volume < 0.02)
  {
    std::generate(points.begin(), points.end(), [&] { return random.Vector(0.0, 1.0); });
    volume = Dot(points[1] - points[0], Cross(points[2] - points[0], points[3] - points[0]));
  }
  for (Vector3& x : points)
  {
    x = lower + size * x;
  }
  return points;
}

/// Checks that the elements fill each cell and the parts fill each element.
void ExpectFilled(const Mesh& mesh, const CartesianGrid& grid, double tolerance)
{
  Runtime runtime;
  const std::vector<Index> elements = AllElements(mesh);
  const Overlaps overlaps = FindOverlaps(mesh, elements, grid, runtime);
  std::vector<double> filled(grid.Local().NumberOfCells(), 0.0);
  double worstElement = 0.0, worstCell = 0.0;
  for (Index e : elements)
  {
    double sum = 0.0;
    for (Index p = overlaps.Offsets[e]; p < overlaps.Offsets[e + 1]; ++p)
    {
      sum += overlaps.Parts[p].Volume;
      filled[overlaps.Parts[p].Cell] += overlaps.Parts[p].Volume;
    }
    const double whole = VolumeOfElement(mesh, e);
    worstElement = std::max(worstElement, std::fabs(sum - whole) / whole);
  }
  ForCells(grid.Local(),
    [&](const Index3& cell)
    {
      const double volume = grid.CellVolume(cell);
      worstCell =
        std::max(worstCell, std::fabs(filled[IndexInBox(grid.Local(), cell)] - volume) / volume);
    });
  std::printf("largest error of cells %.2g, of elements %.2g\n", worstCell, worstElement);
  EXPECT_LT(worstCell, tolerance);
  EXPECT_LT(worstElement, 5e-14);
}

} // namespace

TEST(Overlaps, OfRandomHexes)
{
  RandomDraw random(1);
  const CartesianGrid grid = MakeUnevenGrid(5);
  ElementList list(8);
  for (int i = 0; i < 60; ++i)
  {
    const double size = i % 3 == 0 ? 0.3 : (i % 3 == 1 ? 1.1 : 2.6);
    list.Add(DrawHex(random, random.Vector(0.5, 1.5), size, 0.12));
  }
  CompareWithHand(list, grid);
}

TEST(Overlaps, OfRandomTets)
{
  RandomDraw random(2);
  const CartesianGrid grid = MakeUnevenGrid(5);
  ElementList list(4);
  for (int i = 0; i < 300; ++i)
  {
    list.Add(DrawTet(random, random.Vector(0.0, 2.0), i % 3 == 0 ? 0.4 : (i % 3 == 1 ? 1.0 : 3.0)));
  }
  CompareWithHand(list, grid);
}

TEST(Overlaps, OfRegularTets)
{
  const CartesianGrid grid = MakeUnevenGrid(5);
  ElementList list(4);
  const auto centreOf = [&](const Index3& cell)
  { return 0.5 * (grid.NodePoint(cell) + grid.NodePoint(CornerOfCell(cell, 7))); };
  for (int a = 0; a < 3; ++a)
  {
    for (int b : { (a + 1) % 3, (a + 2) % 3 }) // axis of the edge
    {
      for (int side : { 0, 1 })
      {
        Index3 cell{ { 1, 2, 2 } }, begin{ { 2, 2, 2 } };
        cell[a] = 1;
        begin[a] = 2;
        begin[b] = cell[b];
        begin[3 - a - b] = cell[3 - a - b] + side;
        Index3 other = cell, end = begin;
        ++other[a];
        ++end[b];
        const Vector3 p = centreOf(cell), q = centreOf(other), x = grid.NodePoint(begin),
                      y = grid.NodePoint(end);
        const bool turned = Dot(q - p, Cross(x - p, y - p)) < 0.0;
        list.Add({ p, q, turned ? y : x, turned ? x : y });
        list.Add({ q, p, turned ? x : y, turned ? y : x });
      }
    }
  }
  // In one cell, all halves of its faces.
  const Index3 one{ { 1, 1, 1 } };
  for (int missing = 0; missing < 8; ++missing)
  {
    for (int a = 0; a < 3; ++a)
    {
      const int b = 1 << (a + 1) % 3, c = 1 << (a + 2) % 3;
      const Vector3 p = centreOf(one), x = grid.NodePoint(CornerOfCell(one, missing ^ b)),
                    y = grid.NodePoint(CornerOfCell(one, missing ^ c)),
                    z = grid.NodePoint(CornerOfCell(one, missing ^ b ^ c));
      const bool turned = Dot(x - p, Cross(y - p, z - p)) < 0.0;
      list.Add({ p, turned ? y : x, turned ? x : y, z });
    }
  }
  // Across an edge of one of the cells only, which is not regular.
  list.Add({ centreOf({ { 1, 1, 1 } }), centreOf({ { 2, 1, 1 } }), grid.NodePoint({ { 3, 1, 1 } }),
    grid.NodePoint({ { 3, 2, 1 } }) });
  Runtime runtime;
  const Mesh mesh = list.AsMesh();
  const std::vector<Index> elements = AllElements(mesh);
  for (Index e : elements)
  {
    ASSERT_GT(VolumeOfElement(mesh, e), 0.0);
  }
  const RegularTets regular(mesh, grid, runtime);
  const Overlaps overlaps = FindOverlaps(mesh, elements, grid, runtime);
  for (Index e : elements)
  {
    std::array<RegularPart, 2> parts;
    const int count = regular.Find(e, parts);
    ASSERT_EQ(count, e == elements.back() ? 0 : overlaps.Offsets[e + 1] - overlaps.Offsets[e]);
    for (int p = 0; p < count; ++p)
    {
      const OverlapPart& cut = overlaps.Parts[overlaps.Offsets[e] + p];
      const Index3 cell = CellInBox(grid.Local(), cut.Cell);
      const RegularShape& shape = RegularShapes[parts[p].Kind];
      EXPECT_EQ(parts[p].Cell, grid.Linear(cell));
      EXPECT_NEAR(grid.CellVolume(cell) * shape.Volume / 24.0, cut.Volume, 1e-14);
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_NEAR(centreOf(cell)[a] + grid.Width(a, cell[a]) * shape.Centroid[a] / 8.0,
          cut.Centroid[a], 1e-14);
      }
    }
  }
  CompareWithHand(list, grid);
}

TEST(Overlaps, OfElementsWithCornersOnPlanes)
{
  RandomDraw random(3);
  const CartesianGrid grid = MakeUnitGrid(4);
  ElementList hexes(8), tets(4);
  for (int i = 0; i < 60; ++i)
  {
    std::vector<Vector3> hex = DrawHex(random, { { 1.0, 1.0, 1.0 } }, 1.0 + i % 2, 0.2);
    for (Vector3& x : hex)
    {
      for (double& component : x)
      {
        component = random.Between(0.0, 1.0) < 0.6 ? std::round(component) : component;
      }
    }
    hexes.Add(hex);
    std::vector<Vector3> tet = DrawTet(random, { { 0.0, 0.0, 0.0 } }, 4.0);
    for (Vector3& x : tet)
    {
      x[i % 3] = std::round(x[i % 3]);
    }
    if (Dot(tet[1] - tet[0], Cross(tet[2] - tet[0], tet[3] - tet[0])) > 0.1)
    {
      tets.Add(tet);
    }
  }
  CompareWithHand(hexes, grid);
  CompareWithHand(tets, grid);
}

TEST(Overlaps, OfManyCells)
{
  RandomDraw random(4);
  ElementList hexes(8), tets(4);
  hexes.Add(DrawHex(random, { { 2.0, 2.0, 2.0 } }, 8.0, 0.15));
  tets.Add(DrawTet(random, { { 1.0, 1.0, 1.0 } }, 10.0));
  CompareWithHand(hexes, MakeUnitGrid(12));
  CompareWithHand(tets, MakeUnitGrid(12));
}

TEST(Overlaps, ABoxIsItsCellBitForBit)
{
  const CartesianGrid grid = MakeUnevenGrid(4);
  ElementList list(8);
  const Index3 lower{ { 1, 2, 1 } };
  for (Index size : { 1, 2 })
  {
    std::vector<Vector3> points(8);
    for (int c = 0; c < 8; ++c)
    {
      const Index3 step = CornerOfCell({ { 0, 0, 0 } }, c);
      points[VtkCorner[c]] = grid.NodePoint(
        { { lower[0] + size * step[0], lower[1] + size * step[1], lower[2] + size * step[2] } });
    }
    list.Add(points);
  }
  Runtime runtime;
  const Overlaps overlaps = FindOverlaps(list.AsMesh(), { 0, 1 }, grid, runtime);
  ASSERT_EQ(overlaps.Offsets, (std::vector<Index>{ 0, 1, 9 }));
  for (const OverlapPart& part : overlaps.Parts)
  {
    const Index3 cell = CellInBox(grid.Local(), part.Cell);
    EXPECT_EQ(part.Volume, grid.CellVolume(cell));
    const Index3 upper = CornerOfCell(cell, 7);
    EXPECT_EQ(part.Centroid, 0.5 * (grid.NodePoint(cell) + grid.NodePoint(upper)));
  }
}

TEST(Overlaps, LargeOffsetsCostNoDigits)
{
  RandomDraw random(5);
  ElementList here(8), there(8);
  const double far = 1048576.0;
  for (int i = 0; i < 20; ++i)
  {
    std::vector<Vector3> points = DrawHex(random, { { 1.0, 1.0, 1.0 } }, 1.3, 0.15);
    for (Vector3& x : points)
    {
      for (double& component : x)
      {
        // values on a grid of 2^-20 stay exact far away
        component = std::ldexp(std::round(std::ldexp(component, 20)), -20);
      }
    }
    here.Add(points);
    for (Vector3& x : points)
    {
      x = x + Vector3{ { far, -far, 2.0 * far } };
    }
    there.Add(points);
  }
  std::array<std::vector<double>, 3> x = MakeUnitGrid(4).Coordinates();
  const std::array<double, 3> offset{ { far, -far, 2.0 * far } };
  for (int a = 0; a < 3; ++a)
  {
    for (double& coordinate : x[a])
    {
      coordinate += offset[a];
    }
  }
  Runtime runtime;
  const Mesh meshHere = here.AsMesh(), meshThere = there.AsMesh();
  const Overlaps a = FindOverlaps(meshHere, AllElements(meshHere), MakeUnitGrid(4), runtime);
  const Overlaps b = FindOverlaps(meshThere, AllElements(meshThere), CartesianGrid(x), runtime);
  ASSERT_EQ(a.Parts.size(), b.Parts.size());
  for (std::size_t p = 0; p < a.Parts.size(); ++p)
  {
    EXPECT_EQ(a.Parts[p].Cell, b.Parts[p].Cell);
    EXPECT_EQ(a.Parts[p].Volume, b.Parts[p].Volume);
  }
}

TEST(Overlaps, AdjacentMaterialGoesToTheRim)
{
  ElementList list(4);
  list.Add({ { { -1.5, 0.2, 0.2 } }, { { 0.5, 0.2, 0.2 } }, { { -1.5, 0.9, 0.2 } },
    { { -1.5, 0.2, 0.9 } } });
  list.Add(
    { { { 7.5, 9.2, 2.2 } }, { { 8.5, 9.2, 2.2 } }, { { 7.5, 9.9, 2.2 } }, { { 7.5, 9.2, 2.9 } } });
  const CartesianGrid grid = MakeUnitGrid(3);
  const Mesh mesh = list.AsMesh();
  Runtime runtime;
  const Overlaps overlaps = FindOverlaps(mesh, { 0, 1 }, grid, runtime);
  ASSERT_EQ(overlaps.Offsets, (std::vector<Index>{ 0, 1, 2 }));
  const Index3 cells[2] = { { { 0, 0, 0 } }, { { 2, 2, 2 } } };
  for (int e : { 0, 1 })
  {
    EXPECT_EQ(overlaps.Parts[e].Cell, IndexInBox(grid.Local(), cells[e]));
    EXPECT_NEAR(overlaps.Parts[e].Volume, VolumeOfElement(mesh, e), 1e-15);
  }
}

TEST(Overlaps, EachElementHasItsOwn)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(c.Grid, c.Fractions, MeshOptions(), runtime, report);
  std::vector<Index> elements = AllElements(mesh);
  const Overlaps all = FindOverlaps(mesh, elements, c.Grid, runtime);
  std::reverse(elements.begin(), elements.end());
  const Overlaps reversed = FindOverlaps(mesh, elements, c.Grid, runtime);
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    const Index first = all.Offsets[elements[i]], count = all.Offsets[elements[i] + 1] - first;
    ASSERT_EQ(reversed.Offsets[i + 1] - reversed.Offsets[i], count);
    for (Index p = 0; p < count; ++p)
    {
      const OverlapPart &a = all.Parts[first + p], &b = reversed.Parts[reversed.Offsets[i] + p];
      ASSERT_EQ(a.Cell, b.Cell);
      ASSERT_EQ(a.Volume, b.Volume);
      ASSERT_EQ(a.Centroid, b.Centroid);
    }
  }
}

TEST(OverlapsOfMeshes, FillCells)
{
  const MeshCase c = MakeMeshCase("sphere 16");
  MeshOptions options;
  options.MeshVoid = true;
  Runtime runtime;
  MeshReport report;
  std::array<std::vector<double>, 3> coarser, finer;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = c.Grid.Coordinates(a);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      if (i % 3 == 0 || i + 1 == x.size())
      {
        coarser[a].push_back(x[i]);
      }
      finer[a].push_back(x[i]);
      if (i + 1 < x.size())
      {
        finer[a].push_back(0.3 * x[i] + 0.7 * x[i + 1]);
      }
    }
  }
  const auto expect = [&](const Mesh& mesh)
  {
    ExpectFilled(mesh, c.Grid, 1e-14);
    ExpectFilled(mesh, CartesianGrid(coarser), 1e-14);
    ExpectFilled(mesh, CartesianGrid(finer), 5e-13); // some cells have a fortieth of the volume
  };
  expect(MakeHexMesh(c.Grid, c.Fractions, options, runtime, report));
  for (TetMethod method : { TetMethod::Lattice, TetMethod::Cells })
  {
    options.Method = method;
    expect(MakeTetMesh(c.Grid, c.Fractions, options, runtime, report));
  }
}
