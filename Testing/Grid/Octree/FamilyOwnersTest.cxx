/// Families on several ranks: each holds those near its part, the same as on one rank.
#include "Octree/FamilyOwners.h"
#include "MeshChecks.h"
#include "Octree/OctantFamilies.h"
#include "RankFields.h"
#include "Sweep.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Levels = 3;

/// Returns the part of a rank of a grid that repeats along some axes.
CartesianGrid MakePart(
  const Index3& cells, const std::array<bool, 3>& repeats, const IndexBox& owned)
{
  return CartesianGrid::Covering(
    MakeUnitGrid(cells[0], cells[1], cells[2]).Coordinates(), owned, repeats, Seam::Free, 3);
}

/// Returns random families whose first cells are in the domain.
std::vector<std::vector<Index>> DrawFamilies(
  const OctreeKeys& lattice, RefinedUnit unit, double chance, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::vector<Index>> families(lattice.NumberOfRefinements());
  for (int level = 0; level < lattice.NumberOfRefinements(); ++level)
  {
    const int own = level + (unit == RefinedUnit::Cell);
    ForCells(ChangeLevel(ChangeLevel(lattice.Base().Domain(), own), -1),
      [&](const Index3& family)
      {
        if (random() < chance * 4294967296.0)
        {
          families[level].push_back(lattice.FamilyKey(own, family));
        }
      });
  }
  return families;
}

/// Returns the families whose first cells a rank owns.
std::vector<std::vector<Index>> OwnedOf(const std::vector<std::vector<Index>>& families,
  const OctreeKeys& lattice, int halvings, const IndexBox& owned)
{
  std::vector<std::vector<Index>> result(families.size());
  for (std::size_t i = 0; i < families.size(); ++i)
  {
    const int level = static_cast<int>(i) + halvings;
    std::copy_if(families[i].begin(), families[i].end(), std::back_inserter(result[i]),
      [&](Index key) {
        return ChangeLevel(owned, level).Contains(ChildOfCell(lattice.FamilyOfKey(level, key), 0));
      });
  }
  return result;
}

/// Returns the keys of families that overlap the cells around a part.
std::vector<Index> NearOf(const OctantFamilies& sets, int level, const IndexBox& part)
{
  const int own = sets.FamilyLevel(level);
  const IndexBox all = ChangeLevel(sets.Lattice().Base().Global(), level);
  const IndexBox near =
    ChangeLevel(Grow(ChangeLevel(part, level), OctantFamilies::CellsAround, all), own - level);
  std::vector<Index> keys;
  std::copy_if(sets.Keys(level).begin(), sets.Keys(level).end(), std::back_inserter(keys),
    [&](Index key) { return near.Contains(ChildOfCell(sets.Lattice().FamilyOfKey(own, key), 0)); });
  return keys;
}

bool AreEqual(const OctantFamilies::LevelReport& a, const OctantFamilies::LevelReport& b)
{
  return a.Requested == b.Requested && a.Balance == b.Balance && a.NonManifold == b.NonManifold &&
    a.Rounds == b.Rounds;
}

struct Case
{
  Index3 Cells;
  std::array<bool, 3> Repeats;
  RefinedUnit Unit;
  double Chance;
};

/// Compares the families of each rank with those of one rank.
/// @param areOwned  whether each rank requests its own families; otherwise all ranks request all
void Compare(const Case& c, unsigned seed, int count, bool areOwned)
{
  const IndexBox domain{ {}, c.Cells };
  const CartesianGrid whole = MakePart(c.Cells, c.Repeats, domain);
  const OctreeKeys lattice(whole, Levels);
  const int halvings = c.Unit == RefinedUnit::Cell;
  const auto families = DrawFamilies(lattice, c.Unit, c.Chance, seed);
  const OctantFamilies expected(lattice, families, c.Unit);
  const std::vector<IndexBox> boxes = CutBox(domain, count, -1);
  std::vector<std::string> problems(count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid base = MakePart(c.Cells, c.Repeats, boxes[ranks.Rank()]);
      const OctreeKeys own(base, Levels);
      const IndexBox& part = base.Local();
      const OctantFamilies sets(own,
        areOwned ? OwnedOf(families, own, halvings, base.Owned()) : families, c.Unit, part, ranks);
      for (int level = 0; level < Levels; ++level)
      {
        const bool isSame = base.Owned().NumberOfCells() > 0
          ? sets.Keys(level) == NearOf(expected, level, part)
          : sets.Keys(level).empty();
        problems[ranks.Rank()] += isSame ? "" : " families of level " + std::to_string(level);
        problems[ranks.Rank()] += AreEqual(sets.Report(level), expected.Report(level))
          ? ""
          : " report of level " + std::to_string(level);
      }
    });
  for (const std::string& problem : problems)
  {
    EXPECT_EQ(problem, "") << count << " ranks, seed " << seed;
  }
}

} // namespace

TEST(FamilyOwners, SetsAreThoseOfOneRank)
{
  constexpr RefinedUnit family = RefinedUnit::Family, cell = RefinedUnit::Cell;
  for (const Case& c :
    { Case{ { { 40, 6, 7 } }, {}, family, .003 }, Case{ { { 40, 6, 7 } }, {}, family, .03 },
      Case{ { { 9, 11, 8 } }, {}, family, .01 }, Case{ { { 40, 6, 7 } }, {}, cell, .001 } })
  {
    for (unsigned seed : ListSeeds(3))
    {
      for (int count : { 1, 2, 3, 5, 8, 27 })
      {
        Compare(c, seed, count, true);
      }
      Compare(c, seed, 4, false);
    }
  }
}

TEST(FamilyOwners, CopiesAreThoseOfOneRank)
{
  constexpr RefinedUnit family = RefinedUnit::Family, cell = RefinedUnit::Cell;
  for (const Case& c : { Case{ { { 26, 4, 6 } }, { { true, false, false } }, family, .01 },
         Case{ { { 8, 6, 4 } }, { { true, true, true } }, family, .01 },
         Case{ { { 8, 6, 4 } }, { { false, true, true } }, cell, .003 } })
  {
    for (unsigned seed : ListSeeds(3))
    {
      for (int count : { 1, 2, 3, 5, 8, 27 })
      {
        Compare(c, seed, count, true);
      }
      Compare(c, seed, 3, false);
    }
  }
}

/// Families far from the cells of the rank that requests them reach their owners.
TEST(FamilyOwners, FarFamiliesReachTheirOwners)
{
  const IndexBox domain{ {}, { { 60, 2, 2 } } };
  const std::vector<IndexBox> boxes = CutBox(domain, 3, 0);
  RunOnRanks(3,
    [&](Ranks& ranks)
    {
      const CartesianGrid base = MakePart(domain.Upper, {}, boxes[ranks.Rank()]);
      const OctreeKeys lattice(base, 1);
      const Index last = lattice.FamilyKey(0, { { 29, 0, 0 } });
      const std::vector<std::vector<Index>> requested{
        ranks.Rank() == 0 ? std::vector<Index>{ last, last } : std::vector<Index>()
      };
      const FamilyOwners owners(lattice, base.Local(), 2, requested, 0, ranks);
      const std::vector<Index> owned = owners.ToOwners(0, requested[0]);
      EXPECT_EQ(owned, ranks.Rank() == 2 ? std::vector<Index>{ last } : std::vector<Index>());
      EXPECT_EQ(owners.Owns(0, { { 29, 0, 0 } }), ranks.Rank() == 2);
      const std::vector<Index> all = owners.WithGhosts(0, owned, base.Global());
      EXPECT_EQ(all, std::vector<Index>{ last }); // the layers reach over all ranks
      EXPECT_EQ(owners.WithGhosts(0, owned, base.Local()), owned);
    });
}

/// A rank gathers nothing, and holds a part of the families only.
TEST(FamilyOwners, RanksHoldTheirParts)
{
  const IndexBox domain{ {}, { { 96, 8, 8 } } };
  const std::vector<IndexBox> boxes = CutBox(domain, 8, 0);
  RunOnRanks(8,
    [&](ThreadRanks& ranks)
    {
      const CartesianGrid base = MakePart(domain.Upper, {}, boxes[ranks.Rank()]);
      const OctreeKeys lattice(base, 1);
      std::vector<std::vector<Index>> all(1);
      ForCells(ChangeLevel(base.Owned(), -1),
        [&](const Index3& family) { all[0].push_back(lattice.FamilyKey(0, family)); });
      const OctantFamilies sets(lattice, all, RefinedUnit::Family, base.Local(), ranks);
      EXPECT_EQ(sets.Report(0).Requested, 48 * 4 * 4);
      EXPECT_LE(static_cast<Index>(sets.Keys(0).size()), (12 + 2 * (3 + 9)) / 2 * 4 * 4);
      EXPECT_GE(sets.Keys(0).size(), all[0].size());
    });
}
