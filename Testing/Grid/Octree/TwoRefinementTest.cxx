/// Meshes across levels are conforming, exact where refined, positive, of good
/// shape, and the same in every part.
#include "Octree/TwoRefinement.h"
#include "Fractions/RefineCells.h"
#include "MeshChecks.h"
#include "RankFields.h"
#include "RefinedChecks.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Counts one hex per cell of the grid, and seven more for each refined cell.
Index CountIdealHexes(const OctantFamilies& sets)
{
  const OctreeKeys& lattice = sets.Lattice();
  Index count = lattice.Base().Global().NumberOfCells();
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    for (Index key : sets.Keys(level))
    {
      const Index3 q = lattice.FamilyOfKey(level, key);
      for (int n = 0; n < 8; ++n)
      {
        const Index3 cell{ { 2 * q[0] + (n & 1), 2 * q[1] + (n >> 1 & 1), 2 * q[2] + (n >> 2) } };
        count += 7 * lattice.HasCell(level, cell);
      }
    }
  }
  return count;
}

double SecondsSince(const std::chrono::steady_clock::time_point& start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string DescribeSets(const OctantFamilies& sets)
{
  std::string text;
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    const OctantFamilies::LevelReport& r = sets.Report(level);
    text += (level ? " " : "") + std::to_string(sets.Keys(level).size()) + " (" +
      std::to_string(r.Requested) + "+" + std::to_string(r.Balance) + "+" +
      std::to_string(r.NonManifold) + ")";
  }
  return text;
}

void PrintHeader()
{
  std::printf("| families | padded (asked+balance+non-manifold) | hexes | ideal | ratio | "
              "transition | inverted "
              "| sweeps | SJ start | min | p1 | mean | s to make, smooth |\n");
}

/// Returns the transition hexes as a mesh.
Mesh ToMesh(const RefinedMesh& refined)
{
  Mesh mesh;
  mesh.Points = Buffer<double>(refined.Points.size());
  std::copy(refined.Points.begin(), refined.Points.end(), mesh.Points.begin());
  std::vector<Index> elements, ids;
  for (Index h = 0; h < refined.NumberOfHexes(); ++h)
  {
    if (refined.IsTransition[h])
    {
      ids.push_back(refined.HexKeys[h]);
      elements.insert(
        elements.end(), refined.Hexes.begin() + 8 * h, refined.Hexes.begin() + 8 * h + 8);
    }
  }
  mesh.Elements = Buffer<Index>(elements.size());
  std::copy(elements.begin(), elements.end(), mesh.Elements.begin());
  mesh.ElementIds = Buffer<Index>(ids.size());
  std::copy(ids.begin(), ids.end(), mesh.ElementIds.begin());
  return mesh;
}

/// Makes and checks the mesh of a case. smallest: scaled Jacobian after smoothing, 0 if only
/// corners must stay positive. checkTopology: false for large meshes.
void CheckCase(
  const RefinedCase& c, double smallest = 0.5, bool print = true, bool checkTopology = true)
{
  SCOPED_TRACE(c.Name);
  const auto begin = std::chrono::steady_clock::now();
  const OctantFamilies sets(*c.Lattice, c.Requested);
  RefinedMesh mesh = MakeRefinedMesh(sets);
  const double makeSeconds = SecondsSince(begin);
  const WholeMesh start = AddUntouchedCells(*c.Lattice, mesh);
  if (checkTopology)
  {
    EXPECT_EQ(FindTopologyProblem(*c.Grid, start), "");
    EXPECT_EQ(FindChildProblem(sets, start), "");
  }
  const double startMinimum = MeasureTransitions(mesh).Minimum;
  Runtime runtime;
  const auto middle = std::chrono::steady_clock::now();
  const TransitionReport report = SmoothTransitions(*c.Lattice, mesh, runtime);
  const double smoothSeconds = SecondsSince(middle);
  EXPECT_TRUE(report.BadCells.empty());
  const WholeMesh end = AddUntouchedCells(*c.Lattice, mesh);
  EXPECT_GT(SmallestCornerDeterminant(*c.Grid, end), 0.0);
  EXPECT_TRUE(IsPositiveEverywhere(ToMesh(mesh)));
  EXPECT_EQ(FindChildProblem(sets, end), "");
  EXPECT_LT(std::fabs(VolumeError(*c.Grid, end)), 1e-12);
  const TransitionQuality q = MeasureTransitions(mesh);
  EXPECT_GE(q.Minimum, smallest);
  const Index ideal = CountIdealHexes(sets);
  if (print)
  {
    std::printf("| %s | %s | %zu | %lld | %.2f | %lld | %lld | %d | %.3f | %.3f | %.3f | %.3f | "
                "%.2f, %.2f |\n",
      c.Name.c_str(), DescribeSets(sets).c_str(), end.Hexes.size(), static_cast<long long>(ideal),
      static_cast<double>(end.Hexes.size()) / static_cast<double>(ideal),
      static_cast<long long>(q.Hexes), static_cast<long long>(report.InvertedHexes),
      report.UntangleSweeps, startMinimum, q.Minimum, q.FirstPercentile, q.Mean, makeSeconds,
      smoothSeconds);
  }
}

/// Returns the families of a case in a grid of other widths.
RefinedCase Stretch(RefinedCase c, const Vector3& widths, double growth)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    double at = 0.3, width = widths[a];
    for (Index i = 0; i <= c.Grid->Global().Upper[a]; ++i, at += width, width *= growth)
    {
      x[a].push_back(at);
    }
  }
  char name[96];
  std::snprintf(
    name, sizeof name, ", %g x %g x %g, growth %g", widths[0], widths[1], widths[2], growth);
  c.Name += name;
  const int levels = c.Lattice->NumberOfRefinements();
  c.Grid = std::make_shared<CartesianGrid>(x);
  c.Lattice = std::make_shared<OctreeKeys>(*c.Grid, levels);
  return c;
}

IndexBox MakeBox(Index low, Index high)
{
  return { { { low, low, low } }, { { high, high, high } } };
}

/// Returns an empty string, or how a part differs from the whole mesh in
/// the hexes of a box of base cells.
std::string CompareParts(
  const OctreeKeys& lattice, const RefinedMesh& whole, const RefinedMesh& part, const IndexBox& box)
{
  const auto list = [&](const RefinedMesh& mesh)
  {
    std::map<Index, std::vector<double>> hexes; // key: point keys and coordinates
    for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
    {
      const OctreeKeys::LevelIndex place = lattice.HexOfKey(mesh.HexKeys[h]);
      const int l = place.Level;
      if (!box.Contains({ { place.At[0] >> l, place.At[1] >> l, place.At[2] >> l } }))
      {
        continue;
      }
      std::vector<double>& values = hexes[mesh.HexKeys[h]];
      values.push_back(mesh.IsTransition[h]);
      for (int c = 0; c < 8; ++c)
      {
        const Index p = mesh.Hexes[8 * h + c];
        values.push_back(static_cast<double>(mesh.PointKeys[p]));
        values.push_back(mesh.DomainSides[p]);
        values.insert(values.end(), mesh.Points.begin() + 3 * p, mesh.Points.begin() + 3 * p + 3);
      }
    }
    return hexes;
  };
  const auto expected = list(whole), made = list(part);
  if (expected.size() != made.size())
  {
    return "other hexes";
  }
  for (const auto& hex : expected)
  {
    const auto same = made.find(hex.first);
    if (same == made.end() || same->second != hex.second)
    {
      return same == made.end() ? "other keys" : "other points";
    }
  }
  return "";
}

} // namespace

TEST(TwoRefinement, Shapes)
{
  PrintHeader();
  for (const RefinedCase& c : MakeShapeCases())
  {
    CheckCase(c);
  }
}

TEST(TwoRefinement, RandomFamilies)
{
  const double chances[] = { 0.02, 0.05, 0.1, 0.3, 0.5, 0.7 };
  for (unsigned seed : ListSeeds(50))
  {
    const Index n = seed % 2 ? 8 : 7;
    CheckCase(MakeRandomCase({ { n, 8, n + 1 } }, 1, chances[seed % 6], seed), 0.5, false);
  }
}

TEST(TwoRefinement, SeveralLevels)
{
  PrintHeader();
  CheckCase(MakeShellCase(16, 1));
  CheckCase(MakeShellCase(12, 2));
  CheckCase(MakeRandomCase({ { 8, 7, 8 } }, 2, 0.03, 1));
  CheckCase(MakeRandomCase({ { 9, 8, 7 } }, 3, 0.001, 2));
}

/// Angles deteriorate with the aspect ratio of cells; every corner stays positive.
TEST(TwoRefinement, OtherCells)
{
  PrintHeader();
  const RefinedCase random = MakeRandomCase({ { 12, 12, 12 } }, 1, 0.1, 3);
  CheckCase(Stretch(random, { { 1.0, 1.5, 1.0 } }, 1.0), 0.45);
  CheckCase(Stretch(random, { { 1.0, 2.0, 3.0 } }, 1.0), 0.2);
  CheckCase(Stretch(random, { { 0.1, 0.1, 0.1 } }, 1.05), 0.3);
  CheckCase(Stretch(random, { { 0.1, 0.2, 0.1 } }, 1.2), 0.0);
}

TEST(TwoRefinement, RefinesAsRefineCellsDoes)
{
  const RefinedCase c =
    Stretch(MakeFamilyCase("all", { { 5, 4, 3 } }, [](const Index3&) { return true; }),
      { { 0.1, 0.7, 0.3 } }, 1.1);
  const OctreeKeys lattice(*c.Grid, 2);
  Runtime runtime;
  RefinedCells cells{ *c.Grid, FractionField(*c.Grid, 1) };
  for (int level = 1; level <= 2; ++level)
  {
    cells = RefineCells(cells.Grid, cells.Fractions, runtime);
    for (int a = 0; a < 3; ++a)
    {
      for (Index i = 0; i <= lattice.Cells(level, a); ++i)
      {
        ASSERT_EQ(lattice.Coordinate(level, a, i), cells.Grid.Coordinates(a)[i]);
      }
    }
  }
}

/// A rank makes the same hexes of its cells as the whole mesh; untangling
/// reads two families around.
TEST(TwoRefinement, PartsAreThoseOfTheWhole)
{
  Runtime runtime;
  for (unsigned seed : ListSeeds(12))
  {
    const int levels = 1 + seed % 2;
    const RefinedCase c = MakeRandomCase(
      { { 14, 14, 14 } }, levels, (levels == 1 ? 0.05 : 0.01) * (1 + seed % 5), seed);
    const OctantFamilies sets(*c.Lattice, c.Requested);
    RefinedMesh whole = MakeRefinedMesh(sets);
    for (const IndexBox& box : { MakeBox(6, 8), MakeBox(0, 5), MakeBox(5, 14), MakeBox(7, 8) })
    {
      ASSERT_EQ(CompareParts(*c.Lattice, whole, MakeRefinedMesh(sets, box), box), "");
    }
    SmoothTransitions(*c.Lattice, whole, runtime, false);
    RefinedMesh part = MakeRefinedMesh(sets, MakeBox(2, 12));
    SmoothTransitions(*c.Lattice, part, runtime, false);
    EXPECT_EQ(CompareParts(*c.Lattice, whole, part, MakeBox(6, 8)), "") << "seed " << seed;
  }
}

TEST(TwoRefinement, UntouchedCellsAreTheRest)
{
  const RefinedCase c = MakeRandomCase({ { 10, 9, 8 } }, 1, 0.05, 4);
  const OctantFamilies sets(*c.Lattice, c.Requested);
  const IndexBox box{ { { 2, 0, 3 } }, { { 10, 5, 7 } } };
  const RefinedMesh mesh = MakeRefinedMesh(sets, box);
  Index untouched = 0, expected = 0;
  ForUntouchedCells(*c.Grid, box, mesh,
    [&](const Index3& cell)
    {
      ++untouched;
      EXPECT_FALSE(sets.IsTouched(0, cell));
    });
  for (Index n = 0; n < box.NumberOfCells(); ++n)
  {
    const Index3 cell{ { 2 + n % 8, n / 8 % 5, 3 + n / 40 } };
    expected += !sets.IsTouched(0, cell);
  }
  EXPECT_EQ(untouched, expected);
  EXPECT_GT(untouched, 0);
}

/// Points of one colour must not share a hex, unless they stem from one lattice node.
TEST(TwoRefinement, ColoursAreIndependent)
{
  for (const RefinedCase& c : { MakeRandomCase({ { 14, 14, 14 } }, 1, 0.15, 5),
         MakeRandomCase({ { 10, 9, 10 } }, 2, 0.03, 6) })
  {
    const OctantFamilies sets(*c.Lattice, c.Requested);
    const RefinedMesh mesh = MakeRefinedMesh(sets);
    std::vector<Index> place(mesh.NumberOfPoints(), -1);
    for (const RefinedMesh::FreePoint& point : mesh.FreePoints)
    {
      place[point.Point] = point.Anchor;
    }
    const auto colour = [&](Index p)
    { return CartesianGrid::Parities(c.Lattice->NodeOfKey(p).At); };
    for (Index at = 0; at < 64 * mesh.NumberOfHexes(); ++at)
    {
      const Index a = place[mesh.Hexes[at / 64 * 8 + at % 8]];
      const Index b = place[mesh.Hexes[at / 64 * 8 + at / 8 % 8]];
      if (a >= 0 && b >= 0 && a / OctreeKeys::NodeSlots != b / OctreeKeys::NodeSlots)
      {
        ASSERT_NE(colour(a), colour(b));
      }
    }
    EXPECT_GT(mesh.FreePoints.size(), 1000u);
  }
}

TEST(TwoRefinement, ThreadsChangeNothing)
{
  const RefinedCase c = MakeRandomCase({ { 10, 10, 10 } }, 1, 0.2, 7);
  const OctantFamilies sets(*c.Lattice, c.Requested);
  RefinedMesh one = MakeRefinedMesh(sets), three = one;
  Runtime serial;
  ThreadedRuntime threaded;
  SmoothTransitions(*c.Lattice, one, serial);
  SmoothTransitions(*c.Lattice, three, threaded);
  EXPECT_TRUE(one.Points == three.Points);
}

/// Ranks that each make their part get the same points, also in cells that are not cubes.
TEST(TwoRefinement, RanksChangeNothing)
{
  for (const RefinedCase& c :
    { MakeRandomCase({ { 12, 10, 11 } }, 1, 0.15, 8), MakeRandomCase({ { 8, 9, 10 } }, 2, 0.02, 9),
      Stretch(MakeRandomCase({ { 10, 10, 10 } }, 1, 0.1, 10), { { 1.0, 1.3, 0.7 } }, 1.03) })
  {
    const OctantFamilies sets(*c.Lattice, c.Requested);
    RefinedMesh whole = MakeRefinedMesh(sets);
    Runtime serial;
    const TransitionReport alone = SmoothTransitions(*c.Lattice, whole, serial);
    EXPECT_GT(alone.InvertedHexes, 0);
    for (int count : { 2, 3, 4, 8 })
    {
      std::vector<IndexBox> boxes = CutBox(c.Grid->Global(), count, count == 3 ? 0 : -1);
      boxes.push_back(IndexBox()); // a rank without cells
      std::vector<std::string> problems(boxes.size());
      RunOnRanks(static_cast<int>(boxes.size()),
        [&](Ranks& ranks)
        {
          const CartesianGrid grid = MakeRankGrid(*c.Grid, boxes[ranks.Rank()]);
          const OctreeKeys lattice(grid, c.Lattice->NumberOfRefinements());
          const OctantFamilies own(
            lattice, c.Requested, RefinedUnit::Family, grid.Extended(1), ranks);
          RefinedMesh part = MakeRefinedMesh(own, grid.Extended(1));
          RankRuntime runtime(ranks);
          const TransitionReport report = SmoothTransitions(lattice, part, runtime);
          problems[ranks.Rank()] = report.InvertedHexes == alone.InvertedHexes
            ? CompareParts(lattice, whole, part, grid.Owned())
            : "another count of inverted hexes";
        });
      for (const std::string& problem : problems)
      {
        EXPECT_EQ(problem, "") << count << " ranks";
      }
    }
  }
}

/// Prints the table of the documentation. Run with --gtest_also_run_disabled_tests
/// --gtest_filter='*Table'; takes minutes.
TEST(TwoRefinement, DISABLED_Table)
{
  PrintHeader();
  for (const RefinedCase& c : MakeShapeCases())
  {
    CheckCase(c);
  }
  for (double chance : { 0.1, 0.3, 0.5 })
  {
    CheckCase(MakeRandomCase({ { 24, 24, 24 } }, 1, chance, 1));
  }
  CheckCase(MakeRandomCase({ { 23, 23, 23 } }, 1, 0.3, 1));
  CheckCase(MakeRandomCase({ { 12, 12, 12 } }, 2, 0.04, 1));
  CheckCase(MakeShellCase(32, 1));
  CheckCase(MakeShellCase(16, 2));
  CheckCase(MakeShellCase(64, 1), 0.5, true, false);
  CheckCase(MakeShellCase(32, 2), 0.5, true, false);
  CheckCase(MakeShellCase(16, 3), 0.5, true, false);
}
