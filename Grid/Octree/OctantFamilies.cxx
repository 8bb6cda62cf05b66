#include "Octree/OctantFamilies.h"

#include "Base/Sorted.h"
#include "Octree/FamilyOwners.h"

#include <iterator>

namespace vfm
{
namespace
{

/// Adds sorted keys to sorted keys; returns the new ones.
std::vector<Index> Merge(std::vector<Index>& set, const std::vector<Index>& added)
{
  std::vector<Index> all, fresh;
  std::set_difference(
    added.begin(), added.end(), set.begin(), set.end(), std::back_inserter(fresh));
  std::set_union(set.begin(), set.end(), fresh.begin(), fresh.end(), std::back_inserter(all));
  set = std::move(all);
  return fresh;
}

/// Returns whether a cell shares a face or an edge with the cell a step away, or is this cell.
bool IsFaceOrEdge(const Index3& step)
{
  return step[0] == 0 || step[1] == 0 || step[2] == 0;
}

Index3 Moved(Index3 p, int b, Index alongB, int c, Index alongC)
{
  p[b] += alongB;
  p[c] += alongC;
  return p;
}

} // namespace

OctantFamilies::OctantFamilies(
  const OctreeKeys& lattice, const std::vector<std::vector<Index>>& requested, RefinedUnit unit) :
  TheLattice(lattice), Unit(unit)
{
  Ranks alone;
  this->Close(requested, lattice.Base().Global(), alone);
}

OctantFamilies::OctantFamilies(const OctreeKeys& lattice,
  const std::vector<std::vector<Index>>& requested, RefinedUnit unit, const IndexBox& part,
  Ranks& ranks) :
  TheLattice(lattice), Unit(unit)
{
  this->Close(requested, part, ranks);
}

void OctantFamilies::Close(
  const std::vector<std::vector<Index>>& requested, const IndexBox& part, Ranks& ranks)
{
  const std::size_t levels = this->NumberOfRefinements();
  if (levels == 0)
  {
    return;
  }
  this->Sets.resize(levels);
  this->Reports.resize(levels);
  const FamilyOwners owners(
    this->TheLattice, part, CellsAround, requested, this->FamilyLevel(0), ranks);
  for (int level = this->NumberOfRefinements() - 1; level >= 0; --level)
  {
    const int own = this->FamilyLevel(level);
    const bool isRequested = level < static_cast<int>(requested.size());
    std::vector<Index> owned =
      owners.ToOwners(own, isRequested ? requested[level] : std::vector<Index>());
    this->Reports[level].Requested = static_cast<Index>(owned.size());
    if (level + 1 < this->NumberOfRefinements())
    {
      this->Reports[level].Balance =
        static_cast<Index>(Merge(owned, this->FindBalance(level, owners)).size());
    }
    this->Sets[level] = owners.WithGhosts(own, owned, this->CellsNear(level, part));
    if (this->Unit == RefinedUnit::Family)
    {
      this->CloseNonManifoldEdges(owners, part, ranks, level);
    }
  }
  this->SumReports(ranks);
}

/// Returns the cells near a rank whose families it holds, of the level of their cells.
IndexBox OctantFamilies::CellsNear(int level, const IndexBox& part) const
{
  const IndexBox cells = ChangeLevel(part, level);
  const IndexBox near =
    Grow(cells, CellsAround, ChangeLevel(this->TheLattice.Base().Global(), level));
  return ChangeLevel(near, this->FamilyLevel(level) - level);
}

/// Sums the counts of families over all ranks; rounds are equal.
void OctantFamilies::SumReports(Ranks& ranks)
{
  std::vector<Index> counts;
  for (const LevelReport& report : this->Reports)
  {
    counts.insert(counts.end(), { report.Requested, report.Balance, report.NonManifold });
  }
  ranks.Sum(counts);
  auto next = counts.begin();
  for (LevelReport& report : this->Reports)
  {
    report.Requested = *next++;
    report.Balance = *next++;
    report.NonManifold = *next++;
  }
}

bool OctantFamilies::HasFamily(int level, const Index3& family) const
{
  const std::vector<Index>& set = this->Sets[level];
  const int own = this->FamilyLevel(level);
  return this->TheLattice.HasFamily(own, family) &&
    std::binary_search(set.begin(), set.end(), this->TheLattice.FamilyKey(own, family));
}

bool OctantFamilies::IsTouched(int level, const Index3& cell) const
{
  if (level >= this->NumberOfRefinements() || this->Unit == RefinedUnit::Family)
  {
    return level < this->NumberOfRefinements() && this->FindSlabs(level, cell) != 0;
  }
  bool isTouched = false;
  for (int n = 0; n < 27 && !isTouched; ++n)
  {
    isTouched = IsFaceOrEdge(StepAround(n)) && this->IsRefined(level, CellAround(cell, n));
  }
  return isTouched;
}

int OctantFamilies::FindSlabs(int level, const Index3& cell) const
{
  const Index3 family = ParentOfCell(cell);
  if (this->HasFamily(level, family))
  {
    return 7;
  }
  int slabs = 0;
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const Index nearB = cell[b] & 1 ? 1 : -1, nearC = cell[c] & 1 ? 1 : -1;
    const bool in = this->HasFamily(level, Moved(family, b, nearB, c, 0)) ||
      this->HasFamily(level, Moved(family, b, 0, c, nearC)) ||
      this->HasFamily(level, Moved(family, b, nearB, c, nearC));
    slabs |= in << a;
  }
  return slabs;
}

/// Returns the owned families of a level that the families of the next level need, ascending.
std::vector<Index> OctantFamilies::FindBalance(int level, const FamilyOwners& owners) const
{
  const int own = this->FamilyLevel(level);
  std::vector<Index> needed;
  for (Index key : this->Sets[level + 1])
  {
    const Index3 cell = this->TheLattice.FamilyOfKey(own + 1, key);
    for (int n = 0; n < 27; ++n)
    {
      const Index3 other = CellAround(cell, n);
      if (IsFaceOrEdge(StepAround(n)) && this->TheLattice.HasCell(own, other) &&
        owners.Owns(own, ParentOfCell(other)))
      {
        needed.push_back(this->TheLattice.FamilyKey(own, ParentOfCell(other)));
      }
    }
  }
  SortUnique(needed);
  return needed;
}

/// Returns the owned families that fill non-manifold edges with an end in a list of families,
/// ascending.
std::vector<Index> OctantFamilies::FillNonManifoldEdges(
  int level, const std::vector<Index>& front, const FamilyOwners& owners) const
{
  std::vector<Index> added;
  for (Index key : front)
  {
    const Index3 p = this->TheLattice.FamilyOfKey(level, key);
    for (int n = 0; n < 12; ++n)
    {
      const int b = (n / 4 + 1) % 3, c = (n / 4 + 2) % 3;
      const Index u = n & 1 ? 1 : -1, v = n & 2 ? 1 : -1;
      const auto has = [&](Index alongB, Index alongC)
      { return this->HasFamily(level, Moved(p, b, alongB * u, c, alongC * v)); };
      const Index3 middle = Moved(p, b, u, c, v);
      if (has(2, 2) && !has(1, 1) && !has(1, 0) && !has(0, 1) && !has(2, 1) && !has(1, 2) &&
        owners.Owns(level, middle))
      {
        added.push_back(this->TheLattice.FamilyKey(level, middle));
      }
    }
  }
  SortUnique(added);
  return added;
}

void OctantFamilies::CloseNonManifoldEdges(
  const FamilyOwners& owners, const IndexBox& part, Ranks& ranks, int level)
{
  // A non-manifold edge has an end among the families of the last round.
  std::vector<Index> front = this->Sets[level];
  for (;;)
  {
    const std::vector<Index> added = this->FillNonManifoldEdges(level, front, owners);
    if (!ranks.Any(!added.empty()))
    {
      return;
    }
    this->Reports[level].NonManifold += static_cast<Index>(added.size());
    ++this->Reports[level].Rounds;
    front = owners.WithGhosts(level, added, this->CellsNear(level, part));
    Merge(this->Sets[level], front);
  }
}

} // namespace vfm
