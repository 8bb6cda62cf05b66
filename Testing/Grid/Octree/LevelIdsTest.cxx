/// Ids of points and elements of refined grids.
#include "Octree/LevelIds.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Slots = 16;

/// A grid of 16^3 cells with two refinements, finest in the lowest corner.
struct TwoLevels
{
  static LevelPlan MakePlan()
  {
    LevelPlan plan;
    plan.Refinements = 2;
    plan.Families = { {}, { 0 } }; // the lowest family of level 1
    return plan;
  }

  const CartesianGrid Grid = MakeUnitGrid(16);
  Runtime Run;
  const RefinedGrid Levels{ Grid, MakePlan(), {}, Run.Group() };
  const OctreeKeys& Lattice = Levels.Lattice();

  /// Calls body(level, node or cell) for all nodes or cells of all levels.
  template <class Body>
  void ForAll(Index more, const Body& body) const
  {
    for (int level = 0; level <= 2; ++level)
    {
      const Index n = (4 << level) + more;
      ForCells({ {}, { { n, n, n } } }, [&](const Index3& p) { body(level, p); });
    }
  }
};

} // namespace

TEST(LevelIds, NodesOfFineCellsHaveTheIdsOfTheFinestGrid)
{
  const TwoLevels c;
  const Index nodes = 17 * 17 * 17;
  std::set<Index> ids, keys;
  Index fine = 0;
  c.ForAll(1,
    [&](int level, const Index3& p)
    {
      const Index key = c.Lattice.LatticeKey(level, p);
      const Index id = PointId(c.Levels, key, Slots);
      const Index3 node{ { p[0] << (2 - level), p[1] << (2 - level), p[2] << (2 - level) } };
      const bool isFine = node[0] <= 4 && node[1] <= 4 && node[2] <= 4;
      ASSERT_EQ(IsCoarsePoint(c.Levels, id, Slots), !isFine);
      ASSERT_TRUE(IsLatticePoint(c.Levels, id, Slots));
      if (isFine)
      {
        ASSERT_EQ(id, (node[0] + 17 * (node[1] + 17 * node[2])) * Slots + 1);
      }
      else
      {
        ASSERT_GT(id, nodes * Slots);
        ASSERT_EQ(NodeOfCoarsePoint(c.Levels, id, Slots), node);
      }
      ASSERT_EQ(KeyOfPoint(c.Levels, id, Slots), key);
      fine += ids.insert(id).second && isFine;
      keys.insert(key);
    });
  EXPECT_EQ(ids.size(), keys.size());
  EXPECT_EQ(static_cast<Index>(keys.size()), nodes); // every node of a level is one of the finest
  EXPECT_EQ(fine, 5 * 5 * 5);
  EXPECT_FALSE(IsLatticePoint(c.Levels, 2, Slots));
}

TEST(LevelIds, HexesFollowTheFinestCells)
{
  const TwoLevels c;
  std::set<Index> ids;
  std::size_t count = 0;
  c.ForAll(0,
    [&](int level, const Index3& p)
    {
      for (int slot : { 0, 1, 342 })
      {
        const Index key = c.Lattice.HexKey(level, p, slot);
        const Index id = ElementId(c.Levels, key, 7, 3);
        ASSERT_TRUE(IsCoarseElement(c.Levels, id, 7));
        const OctreeKeys::LevelIndex cell = CellOfCoarseElement(c.Levels, id, 7);
        ASSERT_EQ(cell.Level, level);
        ASSERT_EQ(cell.At, p);
        ASSERT_EQ(cell.Slot, slot);
        ids.insert(id);
        ++count;
      }
    });
  EXPECT_EQ(ids.size(), count);
  EXPECT_FALSE(IsCoarseElement(c.Levels, 16 * 16 * 16 * 7, 7));
}

/// The points of tets: nodes, their copies, then centres of coarse hexes. No two have one id.
TEST(LevelIds, CentresFollowAllPoints)
{
  const TwoLevels c;
  Index largest = 0, smallest = std::numeric_limits<Index>::max(), lastCentre = 0;
  c.ForAll(1,
    [&](int level, const Index3& p)
    {
      const Index key = c.Lattice.NodeKey(level, p, 26);
      largest = std::max(largest, CoarsePointId(c.Levels, key, Slots, Slots - 1));
    });
  std::set<Index> tets;
  std::size_t count = 0;
  c.ForAll(0,
    [&](int level, const Index3& p)
    {
      const Index key = c.Lattice.HexKey(level, p, 342);
      const Index centre = CentreId(c.Levels, key, Slots);
      smallest = std::min(smallest, CentreId(c.Levels, c.Lattice.HexKey(level, p, 0), Slots));
      lastCentre = std::max(lastCentre, centre);
      ASSERT_TRUE(IsCoarseCentre(c.Levels, centre, Slots));
      ASSERT_EQ(CellOfCoarseCentre(c.Levels, centre, Slots).At, p);
      const Index3 upper = NodeOfCoarsePoint(c.Levels, centre, Slots);
      ASSERT_EQ(upper[1], (p[1] + 1) << (2 - level));
      for (Index tet : { Index(0), TetsOfCell - 1 })
      {
        const Index id = TetId(c.Levels, key, tet, TetIds.ElementSlots);
        ASSERT_TRUE(IsCoarseTet(c.Levels, id, TetIds.ElementSlots));
        ASSERT_EQ(CellOfCoarseTet(c.Levels, id, TetIds.ElementSlots).At, p);
        ASSERT_EQ(CellOfCoarseTet(c.Levels, id, TetIds.ElementSlots).Level, level);
        tets.insert(id);
        ++count;
      }
    });
  EXPECT_EQ(tets.size(), count);
  EXPECT_LT(largest, smallest);
  EXPECT_FALSE(IsCoarseCentre(c.Levels, largest, Slots));
  EXPECT_EQ(EndOfPointIds(c.Levels, Slots), lastCentre + 1);
  Runtime runtime;
  const RefinedGrid uniform(c.Grid, runtime.Group());
  EXPECT_EQ(EndOfPointIds(uniform, Slots), 17 * 17 * 17 * Slots + 1);
}
