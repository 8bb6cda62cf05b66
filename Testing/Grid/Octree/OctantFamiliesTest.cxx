/// Sets of families: closure under the rules, keys that map back.
#include "Base/Vector3.h"
#include "MeshChecks.h"
#include "Octree/OctreeKeys.h"
#include "RefinedChecks.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

bool Has(const OctantFamilies& sets, int level, Index i, Index j, Index k)
{
  return sets.HasFamily(level, { { i, j, k } });
}

/// Counts pairs of families on a diagonal of a plane without any of the five around its middle.
Index CountNonManifoldEdges(const OctantFamilies& sets, int level)
{
  Index edges = 0;
  for (Index key : sets.Keys(level))
  {
    const Index3 p = sets.Lattice().FamilyOfKey(level, key);
    for (int n = 0; n < 6; ++n)
    {
      const int b = (n / 2 + 1) % 3, c = (n / 2 + 2) % 3;
      const Index s = n % 2 ? 1 : -1;
      const auto has = [&](Index u, Index v)
      {
        Index3 q = p;
        q[b] += u;
        q[c] += v * s;
        return sets.HasFamily(level, q);
      };
      edges += has(2, 2) && !has(1, 1) && !has(0, 1) && !has(1, 0) && !has(2, 1) && !has(1, 2);
    }
  }
  return edges;
}

/// Counts missing neighbours of families: cells among the 18 that the level below does not refine.
Index CountBareFamilies(const OctantFamilies& sets, int level)
{
  Index bare = 0;
  for (Index key : sets.Keys(level))
  {
    const Index3 p = sets.Lattice().FamilyOfKey(level, key);
    for (int n = 0; n < 27; ++n)
    {
      const Index3 q{ { p[0] + n % 3 - 1, p[1] + n / 3 % 3 - 1, p[2] + n / 9 - 1 } };
      const bool corner = q[0] != p[0] && q[1] != p[1] && q[2] != p[2];
      bare += !corner && sets.Lattice().HasCell(level - 1, q) && !sets.IsRefined(level - 1, q);
    }
  }
  return bare;
}

} // namespace

TEST(OctantFamilies, FillsANonManifoldEdge)
{
  const RefinedCase c = MakeFamilyCase("non-manifold", { { 12, 12, 12 } },
    [](const Index3& q) {
      return q == Index3{ { 1, 1, 3 } } || q == Index3{ { 3, 3, 3 } };
    });
  const OctantFamilies sets(*c.Lattice, c.Requested);
  EXPECT_EQ(sets.Keys(0).size(), 3u);
  EXPECT_TRUE(Has(sets, 0, 2, 2, 3));
  EXPECT_EQ(sets.Report(0).Requested, 2);
  EXPECT_EQ(sets.Report(0).NonManifold, 1);
  EXPECT_EQ(sets.Report(0).Rounds, 1);
}

TEST(OctantFamilies, AddsTheBalance)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  const OctreeKeys lattice(grid, 2);
  const OctantFamilies sets(lattice, { {}, { lattice.FamilyKey(1, { { 5, 5, 5 } }) } });
  // The rule covers cell (5,5,5) and its neighbours except corners: families 2 and 3
  // along each axis without (3,3,3).
  EXPECT_EQ(sets.Keys(0).size(), 7u);
  EXPECT_FALSE(Has(sets, 0, 3, 3, 3));
  EXPECT_EQ(sets.Report(0).Balance, 7);
  EXPECT_EQ(sets.Report(1).Balance + sets.Report(1).NonManifold, 0);
}

TEST(OctantFamilies, AreClosed)
{
  for (unsigned seed : ListSeeds(40))
  {
    const int levels = 1 + seed % 3;
    const Index n = levels == 1 ? 22 : levels == 2 ? 13 : 7;
    const RefinedCase c = MakeRandomCase({ { n, n + 2, n } }, levels, 0.01 * (1 + seed % 9), seed);
    auto requested = c.Requested;
    std::mt19937 random(seed);
    for (auto& keys : requested)
    {
      keys.insert(keys.end(), keys.begin(), keys.begin() + keys.size() / 2);
      std::shuffle(keys.begin(), keys.end(), random);
    }
    const OctantFamilies sets(*c.Lattice, c.Requested), shuffled(*c.Lattice, requested);
    for (int level = 0; level < levels; ++level)
    {
      EXPECT_EQ(CountNonManifoldEdges(sets, level), 0);
      EXPECT_EQ(level > 0 ? CountBareFamilies(sets, level) : 0, 0);
      EXPECT_TRUE(sets.Keys(level) == shuffled.Keys(level));
      const OctantFamilies::LevelReport& r = sets.Report(level);
      EXPECT_EQ(
        static_cast<Index>(sets.Keys(level).size()), r.Requested + r.Balance + r.NonManifold);
      for (Index key : c.Requested[level])
      {
        EXPECT_TRUE(sets.HasFamily(level, c.Lattice->FamilyOfKey(level, key)));
      }
    }
  }
}

/// Single cells: all requested cells and no more than the balance needs.
TEST(OctantFamilies, CellsAreBalanced)
{
  for (unsigned seed : ListSeeds(20))
  {
    const CartesianGrid grid = MakeUnitGrid(4, 3, 5);
    const OctreeKeys lattice(grid, 3);
    std::mt19937 random(seed);
    std::vector<std::vector<Index>> requested(3);
    std::array<std::set<Index3>, 3> expected;
    for (int level = 2; level >= 0; --level)
    {
      const IndexBox box = ChangeLevel(grid.Global(), level);
      ForCells(box,
        [&](const Index3& cell)
        {
          if (random() % 200 < 1 + seed % 4)
          {
            requested[level].push_back(lattice.FamilyKey(level + 1, cell));
            expected[level].insert(cell);
          }
        });
      for (const Index3& finer : level < 2 ? expected[level + 1] : std::set<Index3>())
      {
        for (int n = 0; n < 27; ++n)
        {
          const Index3 step = StepAround(n), near = CellAround(finer, n);
          if (step[0] * step[1] * step[2] == 0 && lattice.HasCell(level + 1, near))
          {
            expected[level].insert(ParentOfCell(near));
          }
        }
      }
    }
    const OctantFamilies sets(lattice, requested, RefinedUnit::Cell);
    for (int level = 0; level < 3; ++level)
    {
      EXPECT_EQ(sets.Keys(level).size(), expected[level].size());
      EXPECT_EQ(sets.Report(level).NonManifold, 0);
      ForCells(ChangeLevel(grid.Global(), level),
        [&](const Index3& cell)
        {
          bool isTouched = false;
          for (int n = 0; n < 27; ++n)
          {
            const Index3 step = StepAround(n);
            isTouched = isTouched ||
              (step[0] * step[1] * step[2] == 0 && expected[level].count(CellAround(cell, n)) > 0);
          }
          ASSERT_EQ(sets.IsRefined(level, cell), expected[level].count(cell) > 0);
          ASSERT_EQ(sets.IsTouched(level, cell), isTouched);
        });
    }
  }
}

TEST(OctreeKeys, KeysComeBack)
{
  const CartesianGrid grid = MakeUnitGrid(5, 7, 3);
  const OctreeKeys lattice(grid, 2);
  Index lastNode = -1, lastHex = -1;
  for (int level = 0; level <= 2; ++level)
  {
    for (Index k = 0; k <= lattice.Cells(level, 2); ++k)
    {
      for (Index j = 0; j <= lattice.Cells(level, 1); ++j)
      {
        for (Index i = 0; i <= lattice.Cells(level, 0); ++i)
        {
          const Index3 at{ { i, j, k } };
          const Index key = lattice.NodeKey(level, at, 26);
          ASSERT_EQ(lattice.NodeKey(level, at, 0), lastNode + 1);
          lastNode = key;
          const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
          ASSERT_TRUE(node.Level == level && node.At == at && node.Slot == 26);
          const OctreeKeys::LevelIndex lattice0 = lattice.NodeOfKey(lattice.LatticeKey(level, at));
          ASSERT_EQ(lattice.NodePoint(lattice0.Level, lattice0.At), lattice.NodePoint(level, at));
          if (lattice.HasCell(level, at))
          {
            ASSERT_EQ(lattice.HexKey(level, at, 0), lastHex + 1);
            lastHex = lattice.HexKey(level, at, 342);
            const OctreeKeys::LevelIndex hex = lattice.HexOfKey(lastHex);
            ASSERT_TRUE(hex.Level == level && hex.At == at && hex.Slot == 342);
          }
        }
      }
    }
  }
}

TEST(OctreeKeys, RefusesKeysThatDoNotFit)
{
  const CartesianGrid grid = MakeUnitGrid(1000);
  EXPECT_NO_THROW(OctreeKeys(grid, 7));
  EXPECT_THROW(OctreeKeys(grid, 8), InputError);
  EXPECT_THROW(OctreeKeys(grid, 60), InputError);
}

TEST(OctreeKeys, LatticeCoordinatesComeBack)
{
  const CartesianGrid grid({ { { 0.0, 1.0, 3.0 }, { -1.0, 0.5 }, { 2.0, 2.5, 2.75, 4.0 } } });
  const OctreeKeys lattice(grid, 1);
  const Vector3 x{ { 1.25, 0.5, 2.5 } };
  EXPECT_EQ(lattice.ToPoint(x), (Vector3{ { 1.5, -0.25, 3.375 } }));
  EXPECT_EQ(lattice.FromPoint(lattice.ToPoint(x)), x);
  EXPECT_EQ(lattice.ToPoint({ { 2.0, 1.0, 3.0 } }), (Vector3{ { 3.0, 0.5, 4.0 } }));
  EXPECT_EQ(lattice.FromPoint({ { 3.0, 0.5, 4.0 } }), (Vector3{ { 2.0, 1.0, 3.0 } }));
}
