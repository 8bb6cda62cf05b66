#include "Octree/OctantFamilies.h"

#include "Base/Sorted.h"

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
  const OctreeKeys& lattice, std::vector<std::vector<Index>> requested, RefinedUnit unit) :
  TheLattice(lattice),
  Unit(unit),
  Sets(std::move(requested)),
  Reports(lattice.NumberOfRefinements())
{
  this->Sets.resize(this->Reports.size());
  for (int level = this->NumberOfRefinements() - 1; level >= 0; --level)
  {
    this->AddCopies(level, this->Sets[level]);
    this->Reports[level].Requested = this->CountInDomain(level, this->Sets[level]);
    if (level + 1 < this->NumberOfRefinements())
    {
      this->AddBalance(level);
    }
    if (this->Unit == RefinedUnit::Family)
    {
      this->CloseNonManifoldEdges(level);
    }
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

/// Adds the copies of families on a periodic grid, and sorts the keys.
void OctantFamilies::AddCopies(int level, std::vector<Index>& keys) const
{
  const CartesianGrid& base = this->TheLattice.Base();
  const int own = this->FamilyLevel(level);
  std::vector<Index> copies;
  for (std::size_t k = 0; base.IsPeriodic() && k < keys.size(); ++k)
  {
    const Index3 family = this->TheLattice.FamilyOfKey(own, keys[k]);
    IndexBox shifts{ {}, { { 1, 1, 1 } } };
    for (int a = 0; a < 3; ++a)
    {
      const Index step = base.Period(a) << own; // a family has two cells, so twice the families
      shifts.Lower[a] = step > 0 ? -(2 * family[a] / step) : 0;
      shifts.Upper[a] =
        step > 0 ? (this->TheLattice.Cells(own, a) - 2 * family[a] - 1) / step + 1 : 1;
    }
    ForCells(shifts,
      [&](const Index3& shift)
      {
        Index3 copy = family;
        for (int a = 0; a < 3; ++a)
        {
          copy[a] += shift[a] * ((base.Period(a) << own) / 2);
        }
        copies.push_back(this->TheLattice.FamilyKey(own, copy));
      });
  }
  keys.insert(keys.end(), copies.begin(), copies.end());
  SortUnique(keys);
}

Index OctantFamilies::CountInDomain(int level, const std::vector<Index>& keys) const
{
  const int own = this->FamilyLevel(level);
  const IndexBox domain = ChangeLevel(this->TheLattice.Base().Domain(), own);
  return std::count_if(keys.begin(), keys.end(),
    [&](Index key)
    {
      const IndexBox family = ChangeLevel(BoxOfCell(this->TheLattice.FamilyOfKey(own, key)), 1);
      return domain.Contains(family.Lower);
    });
}

/// Adds the families of a level that the families of the next level need.
void OctantFamilies::AddBalance(int level)
{
  const int own = this->FamilyLevel(level);
  std::vector<Index> needed;
  for (Index key : this->Sets[level + 1])
  {
    const Index3 cell = this->TheLattice.FamilyOfKey(own + 1, key);
    for (int n = 0; n < 27; ++n)
    {
      const Index3 other = CellAround(cell, n);
      if (IsFaceOrEdge(StepAround(n)) && this->TheLattice.HasCell(own, other))
      {
        needed.push_back(this->TheLattice.FamilyKey(own, ParentOfCell(other)));
      }
    }
  }
  this->AddCopies(level, needed);
  this->Reports[level].Balance = this->CountInDomain(level, Merge(this->Sets[level], needed));
}

void OctantFamilies::CloseNonManifoldEdges(int level)
{
  // A non-manifold edge has an end among the families of the last round.
  std::vector<Index> front = this->Sets[level];
  while (!front.empty())
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
        if (has(2, 2) && !has(1, 1) && !has(1, 0) && !has(0, 1) && !has(2, 1) && !has(1, 2))
        {
          added.push_back(this->TheLattice.FamilyKey(level, Moved(p, b, u, c, v)));
        }
      }
    }
    this->AddCopies(level, added);
    const std::vector<Index> fresh = Merge(this->Sets[level], added);
    this->Reports[level].NonManifold += this->CountInDomain(level, fresh);
    this->Reports[level].Rounds += !fresh.empty();
    front = std::move(added);
  }
}

} // namespace vfm
