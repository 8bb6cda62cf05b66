/**
 * TetGenFill fills closed surfaces of many kinds, keeps their triangles, and rejects invalid ones.
 */
#include "TetGen/TetGenFill.h"

#include "Base/Runtime.h"
#include "Base/Vector3.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <thread>

using namespace vfm;

namespace
{

const double Pi = 3.14159265358979323846;

double Same(const Vector3&)
{
  return 0.0; // no requested size
}

SizeFunction Constant(double size)
{
  return [size](const Vector3&) { return size; };
}

/// Adds the quad a b c d, counterclockwise from outside, as two triangles.
void AddQuad(TetGenPart& part, int a, int b, int c, int d, bool other = false)
{
  if (other)
  {
    part.Triangles.push_back({ { a, b, d } });
    part.Triangles.push_back({ { b, c, d } });
  }
  else
  {
    part.Triangles.push_back({ { a, b, c } });
    part.Triangles.push_back({ { a, c, d } });
  }
}

using Cell = std::array<int, 3>;

/// Returns the boundary of unit cubes, which may touch at edges and corners. The parity of cell and
/// side selects the diagonal of each quad.
TetGenPart BoundaryOfCells(const std::set<Cell>& cells, double width = 1.0)
{
  TetGenPart part;
  std::map<Cell, int> points;
  for (const Cell& cell : cells)
  {
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, isUpper = side % 2;
      Cell neighbour = cell;
      neighbour[axis] += isUpper ? 1 : -1;
      if (cells.count(neighbour))
      {
        continue;
      }
      int quad[4];
      for (int k = 0; k < 4; ++k)
      {
        Cell corner = cell;
        corner[axis] += isUpper;
        corner[isUpper ? u : v] += k == 1 || k == 2;
        corner[isUpper ? v : u] += k >= 2;
        const auto found = points.emplace(corner, static_cast<int>(part.Points.size()));
        if (found.second)
        {
          part.Points.push_back({ { width * corner[0], width * corner[1], width * corner[2] } });
        }
        quad[k] = found.first->second;
      }
      AddQuad(
        part, quad[0], quad[1], quad[2], quad[3], (cell[0] + cell[1] + cell[2] + side) % 2 != 0);
    }
  }
  return part;
}

/// Returns the unit cube with n x n squares per side.
TetGenPart Cube(int n)
{
  std::set<Cell> cells;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        cells.insert({ { i, j, k } });
      }
    }
  }
  return BoundaryOfCells(cells, 1.0 / n);
}

/// Returns a sphere: an icosahedron whose triangles are cut in four `cuts` times.
TetGenPart Ball(int cuts, double radius, const Vector3& centre = {})
{
  TetGenPart part;
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  part.Points = { { { -1, g, 0 } }, { { 1, g, 0 } }, { { -1, -g, 0 } }, { { 1, -g, 0 } },
    { { 0, -1, g } }, { { 0, 1, g } }, { { 0, -1, -g } }, { { 0, 1, -g } }, { { g, 0, -1 } },
    { { g, 0, 1 } }, { { -g, 0, -1 } }, { { -g, 0, 1 } } };
  part.Triangles = { { { 0, 11, 5 } }, { { 0, 5, 1 } }, { { 0, 1, 7 } }, { { 0, 7, 10 } },
    { { 0, 10, 11 } }, { { 1, 5, 9 } }, { { 5, 11, 4 } }, { { 11, 10, 2 } }, { { 10, 7, 6 } },
    { { 7, 1, 8 } }, { { 3, 9, 4 } }, { { 3, 4, 2 } }, { { 3, 2, 6 } }, { { 3, 6, 8 } },
    { { 3, 8, 9 } }, { { 4, 9, 5 } }, { { 2, 4, 11 } }, { { 6, 2, 10 } }, { { 8, 6, 7 } },
    { { 9, 8, 1 } } };
  for (int cut = 0; cut < cuts; ++cut)
  {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b)
    {
      const auto found = middles.emplace(
        std::make_pair(std::min(a, b), std::max(a, b)), static_cast<int>(part.Points.size()));
      if (found.second)
      {
        part.Points.push_back(Unit(part.Points[a] + part.Points[b]));
      }
      return found.first->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : part.Triangles)
    {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.push_back({ { t[0], ab, ca } });
      finer.push_back({ { t[1], bc, ab } });
      finer.push_back({ { t[2], ca, bc } });
      finer.push_back({ { ab, bc, ca } });
    }
    part.Triangles = finer;
  }
  for (Vector3& p : part.Points)
  {
    p = centre + radius * Unit(p);
  }
  return part;
}

/// Adds a surface, with reversed triangles if it is a hole.
void Append(TetGenPart& part, const TetGenPart& other, bool isHole)
{
  const int first = static_cast<int>(part.Points.size());
  part.Points.insert(part.Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& t : other.Triangles)
  {
    part.Triangles.push_back(
      { { first + t[0], first + t[isHole ? 2 : 1], first + t[isHole ? 1 : 2] } });
  }
}

/// Rotates about a tilted axis.
void Rotate(TetGenPart& part, double angle)
{
  const Vector3 axis = Unit({ { 1.0, 2.0, 3.0 } });
  for (Vector3& p : part.Points)
  {
    p = std::cos(angle) * p + std::sin(angle) * Cross(axis, p) +
      (1.0 - std::cos(angle)) * Dot(axis, p) * axis;
  }
}

double Det(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return Dot(Cross(b - a, c - a), d - a);
}

double VolumeInside(const TetGenPart& part)
{
  double volume = 0.0;
  const Vector3 o = part.Points[0];
  for (const auto& t : part.Triangles)
  {
    volume += Det(o, part.Points[t[0]], part.Points[t[1]], part.Points[t[2]]) / 6.0;
  }
  return volume;
}

/// Dihedral angles and mean edge length.
struct Shape
{
  double Smallest = 180.0, Largest = 0.0, MeanEdge = 0.0;
};

Shape Measure(const TetGenFill& fill)
{
  Shape shape;
  std::set<std::pair<int, int>> edges;
  for (const auto& t : fill.Tets)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        int others[2], n = 0;
        for (int k = 0; k < 4; ++k)
        {
          if (k != i && k != j)
          {
            others[n++] = k;
          }
        }
        const Vector3 a = fill.Points[t[i]], e = Unit(fill.Points[t[j]] - a);
        Vector3 u = fill.Points[t[others[0]]] - a, v = fill.Points[t[others[1]]] - a;
        u = Unit(u - Dot(u, e) * e);
        v = Unit(v - Dot(v, e) * e);
        const double angle = std::atan2(Norm(Cross(u, v)), Dot(u, v)) * 180.0 / Pi;
        shape.Smallest = std::min(shape.Smallest, angle);
        shape.Largest = std::max(shape.Largest, angle);
        edges.emplace(std::min(t[i], t[j]), std::max(t[i], t[j]));
      }
    }
  }
  for (const auto& e : edges)
  {
    shape.MeanEdge += Norm(fill.Points[e.first] - fill.Points[e.second]) / edges.size();
  }
  return shape;
}

/// Checks a filling independently of TetGenFill. Faces are oriented triples
/// with the smallest corner first.
void ExpectFilled(const TetGenPart& part, const TetGenFill& fill)
{
  ASSERT_EQ(fill.Refusal, "");
  ASSERT_GE(fill.Points.size(), part.Points.size());
  EXPECT_TRUE(std::equal(part.Points.begin(), part.Points.end(), fill.Points.begin()));
  std::map<std::array<int, 3>, int> open;
  const auto turned = [](int a, int b, int c)
  {
    std::array<int, 3> face{ { a, b, c } };
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  };
  double volume = 0.0;
  for (const auto& t : fill.Tets)
  {
    const double det =
      Det(fill.Points[t[0]], fill.Points[t[1]], fill.Points[t[2]], fill.Points[t[3]]);
    EXPECT_GT(det, 0.0);
    volume += det / 6.0;
    const int faces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    for (const auto& f : faces)
    {
      const auto opposite = open.find(turned(t[f[2]], t[f[1]], t[f[0]]));
      if (opposite != open.end())
      {
        open.erase(opposite);
      }
      else
      {
        EXPECT_EQ(++open[turned(t[f[0]], t[f[1]], t[f[2]])], 1);
      }
    }
  }
  EXPECT_EQ(open.size(), part.Triangles.size());
  for (const auto& t : part.Triangles)
  {
    EXPECT_EQ(open.count(turned(t[0], t[1], t[2])), 1u);
  }
  EXPECT_NEAR(volume, VolumeInside(part), 1e-9 * volume);
}

TetGenFill Fill(const TetGenPart& part, const SizeFunction& size = Same)
{
  return FillWithTetGen(part, TetGenOptions(), size);
}

void Print(const char* what, const TetGenFill& fill)
{
  const Shape shape = Measure(fill);
  std::printf("%s: %zu points, %zu tets, dihedral %.2f..%.2f, mean edge %.4g\n", what,
    fill.Points.size(), fill.Tets.size(), shape.Smallest, shape.Largest, shape.MeanEdge);
}

/// Returns cubes grown from one; each shares a face with an earlier one.
TetGenPart Jagged(unsigned seed)
{
  std::mt19937 random(seed);
  std::set<Cell> cells{ { { 0, 0, 0 } } };
  while (cells.size() < 60)
  {
    Cell cell = *std::next(cells.begin(), random() % cells.size());
    cell[random() % 3] += random() % 2 ? 1 : -1;
    cells.insert(cell);
  }
  return BoundaryOfCells(cells);
}

} // namespace

TEST(TetGenFill, CubeOfEverySize)
{
  for (const int n : { 1, 2, 4, 8 })
  {
    const TetGenPart part = Cube(n);
    const TetGenFill fill = Fill(part, Constant(1.0 / n));
    ExpectFilled(part, fill);
    EXPECT_TRUE(fill.Complete);
    Print("cube", fill);
  }
}

TEST(TetGenFill, RotatedAndFarCube)
{
  for (int i = 1; i < 10; ++i)
  {
    TetGenPart part = Cube(5);
    Rotate(part, 0.37 * i);
    for (Vector3& p : part.Points)
    {
      p = Vector3{ { 1e5, -2e5, 3e5 } } + 1e-3 * p;
    }
    ExpectFilled(part, Fill(part, Constant(0.2e-3)));
  }
}

TEST(TetGenFill, MeanEdgeIsAsWished)
{
  const TetGenPart part = Ball(3, 1.0); // edges of .15
  for (const double size : { 0.1, 0.15, 0.2 })
  {
    const TetGenFill fill = Fill(part, Constant(size));
    ExpectFilled(part, fill);
    Print("ball", fill);
    if (size <= 0.15)
    {
      EXPECT_NEAR(Measure(fill).MeanEdge, size, 0.15 * size);
    }
  }
}

TEST(TetGenFill, SizeMayGrow)
{
  const TetGenPart part = Ball(4, 1.0);
  const TetGenFill even = Fill(part, Constant(0.08)),
                   grown = Fill(part, [](const Vector3&p) { return .08 + .3 * (1 - Norm(p)); });
  ExpectFilled(part, even);
  ExpectFilled(part, grown);
  Print("even", even);
  Print("grown", grown);
  EXPECT_LT(2 * grown.Tets.size(), even.Tets.size());
  EXPECT_GT(Measure(even).Smallest, 15.0);
  EXPECT_GT(Measure(grown).Smallest, 15.0);
}

TEST(TetGenFill, BallWithHole)
{
  TetGenPart part = Ball(3, 1.0);
  Append(part, Ball(3, 0.5), true);
  const TetGenFill fill = Fill(part, Constant(0.15));
  ExpectFilled(part, fill);
  Print("shell", fill);
  // an island of the same region in the hole
  Append(part, Ball(2, 0.25), false);
  ExpectFilled(part, Fill(part, Constant(0.15)));
}

TEST(TetGenFill, CubesThatTouch)
{
  for (const Cell& second : { Cell{ { 1, 1, 0 } }, Cell{ { 1, 1, 1 } } })
  {
    const TetGenPart part = BoundaryOfCells({ { { 0, 0, 0 } }, second });
    ExpectFilled(part, Fill(part, Constant(0.5)));
  }
}

/// Holes touch each other or the outside at an edge or a corner.
TEST(TetGenFill, NonManifoldHoles)
{
  const std::vector<std::vector<Cell>> removed = { { { { 1, 1, 1 } }, { { 2, 2, 1 } } },
    { { { 1, 1, 1 } }, { { 2, 2, 2 } } }, { { { 0, 0, 1 } }, { { 1, 1, 1 } } },
    { { { 0, 0, 0 } }, { { 1, 1, 1 } } } };
  for (const auto& holes : removed)
  {
    std::set<Cell> cells;
    for (int i = 0; i < 64; ++i)
    {
      cells.insert({ { i % 4, i / 4 % 4, i / 16 } });
    }
    for (const Cell& hole : holes)
    {
      cells.erase(hole);
    }
    const TetGenPart part = BoundaryOfCells(cells);
    ExpectFilled(part, Fill(part, Constant(1.0)));
  }
}

TEST(TetGenFill, JaggedSurfaces)
{
  for (unsigned seed : vfm::testing::ListSeeds(20))
  {
    const TetGenPart part = Jagged(seed);
    const TetGenFill fill = Fill(part, Constant(1.0));
    ExpectFilled(part, fill);
    EXPECT_TRUE(fill.Complete);
  }
}

TEST(TetGenFill, UnusedPointsStay)
{
  TetGenPart part = Cube(2);
  part.Points.insert(part.Points.begin(), Vector3{ { 0.5, 0.5, 0.5 } });
  part.Points.push_back(part.Points[3]);
  for (auto& t : part.Triangles)
  {
    t = { { t[0] + 1, t[1] + 1, t[2] + 1 } };
  }
  ExpectFilled(part, Fill(part, Constant(0.5)));
}

namespace
{

void ExpectRejected(const char* name, const TetGenPart& part)
{
  const TetGenFill fill = Fill(part, Constant(0.5));
  std::printf("%s: %s\n", name, fill.Refusal.c_str());
  EXPECT_NE(fill.Refusal, "") << name;
  EXPECT_TRUE(fill.Tets.empty() && fill.Points.empty());
  const TetGenPart good = Cube(2);
  ExpectFilled(good, Fill(good, Constant(0.5)));
}

} // namespace

TEST(TetGenFill, RefusesNumbers)
{
  const TetGenPart cube = Cube(2);
  TetGenPart part;
  ExpectRejected("empty", part);
  part.Points = cube.Points;
  ExpectRejected("no triangles", part);
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), 1e308 })
  {
    part = cube;
    part.Points[3][1] = bad;
    part.Points[4][1] = -bad;
    ExpectRejected("not finite", part);
  }
  for (const int bad : { -1, 26, std::numeric_limits<int>::max() })
  {
    part = cube;
    part.Triangles[5][1] = bad;
    ExpectRejected("index", part);
  }
  part = cube;
  part.Triangles[5][1] = part.Triangles[5][0];
  ExpectRejected("corner twice", part);
}

TEST(TetGenFill, RefusesShapes)
{
  const TetGenPart cube = Cube(2);
  TetGenPart part = cube;
  for (Vector3& p : part.Points)
  {
    p[2] = 1.0;
  }
  ExpectRejected("flat", part);
  for (Vector3& p : part.Points)
  {
    p[2] = p[0] + p[1];
  }
  ExpectRejected("flat and tilted", part);
  part = cube;
  part.Triangles.pop_back();
  ExpectRejected("open", part);
  part = cube;
  std::swap(part.Triangles[0][0], part.Triangles[0][1]);
  ExpectRejected("one turned", part);
  part = TetGenPart();
  Append(part, cube, true);
  ExpectRejected("all turned", part);
  part = cube;
  part.Triangles.insert(part.Triangles.end(), cube.Triangles.begin(), cube.Triangles.end());
  ExpectRejected("duplicate triangles", part);
  Append(part = cube, cube, false);
  ExpectRejected("duplicate points", part);
}

TEST(TetGenFill, RefusesCrossings)
{
  const TetGenPart cube = Cube(2);
  for (int i = 0; i < 10; ++i)
  {
    TetGenPart part = cube, second = cube;
    Rotate(second, 0.2 * i);
    for (Vector3& p : second.Points)
    {
      p = 0.9 * p + Vector3{ { 0.3, 0.4, 0.2 + 0.05 * i } };
    }
    Append(part, second, i % 2 == 1);
    ExpectRejected("two crossing", part);
  }
  TetGenPart part = cube;
  Append(part, Ball(1, 0.6, { { 0.5, 0.5, 0.5 } }), true);
  ExpectRejected("hole through the surface", part);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  for (int i = 0; i < 20; ++i)
  {
    part = Ball(2, 1.0);
    for (Vector3& p : part.Points)
    {
      p = p + Vector3{ { shift(random), shift(random), shift(random) } };
    }
    // may be filled or rejected, but must not crash
    const TetGenFill fill = Fill(part, Constant(0.3));
    if (fill.Refusal.empty())
    {
      ExpectFilled(part, fill);
    }
  }
}

TEST(TetGenFill, SizeFunctionMayMisbehave)
{
  const TetGenPart part = Ball(1, 1.0);
  for (const double size : { std::nan(""), -1.0, std::numeric_limits<double>::infinity() })
  {
    ExpectFilled(part, Fill(part, Constant(size)));
  }
  ExpectFilled(part, Fill(part, nullptr));
  const TetGenFill limited = Fill(part, Constant(1e-3));
  ExpectFilled(part, limited);
  EXPECT_FALSE(limited.Complete);
  EXPECT_NE(
    Fill(part, [](const Vector3&) -> double { throw std::runtime_error("no"); }).Refusal, "");
  EXPECT_THROW(Fill(part, [](const Vector3&) -> double { throw Aborted(); }), Aborted);
  ExpectFilled(part, Fill(part, Constant(0.3)));
}

TEST(TetGenFill, ProgressAndAbort)
{
  const TetGenPart part = Ball(3, 1.0);
  std::vector<double> told;
  const TetGenFill fill = FillWithTetGen(
    part, TetGenOptions(), Constant(0.08), [&](double fraction) { told.push_back(fraction); });
  ExpectFilled(part, fill);
  std::printf("%zu tets, %zu reports of progress\n", fill.Tets.size(), told.size());
  EXPECT_GT(told.size(), 4U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_TRUE(told.front() > 0.0 && told.back() <= 1.0);
  for (const double when : { told.front(), told[told.size() / 2], told.back() })
  {
    const auto stop = [when](double fraction)
    {
      if (fraction >= when)
      {
        throw Aborted();
      }
    };
    EXPECT_THROW(FillWithTetGen(part, TetGenOptions(), Constant(0.08), stop), Aborted);
  }
  EXPECT_EQ(Fill(part, Constant(0.08)).Tets, fill.Tets);
}

TEST(TetGenFill, ThreadsDoNotMatter)
{
  const TetGenPart parts[2] = { Ball(3, 1.0), Jagged(7) };
  const double sizes[2] = { 0.15, 1.0 };
  TetGenFill alone[2], together[2][4];
  for (int i = 0; i < 2; ++i)
  {
    alone[i] = Fill(parts[i], Constant(sizes[i]));
    ASSERT_EQ(alone[i].Refusal, "");
  }
  const auto work = [&](int i)
  {
    for (TetGenFill& fill : together[i])
    {
      fill = Fill(parts[i], Constant(sizes[i]));
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  for (int i = 0; i < 2; ++i)
  {
    for (const TetGenFill& fill : together[i])
    {
      EXPECT_EQ(fill.Points, alone[i].Points);
      EXPECT_EQ(fill.Tets, alone[i].Tets);
    }
  }
}
