#include "Octree/OctantFamilies.h"

#include "Base/Sorted.h"

#include <iterator>

namespace vfm
{
namespace
{

/// Adds sorted keys to sorted keys; returns the number of new ones.
Index Merge(std::vector<Index>& set, const std::vector<Index>& added)
{
  std::vector<Index> all;
  std::set_union(set.begin(), set.end(), added.begin(), added.end(), std::back_inserter(all));
  all.swap(set);
  return static_cast<Index>(set.size() - all.size());
}

Index3 Moved(Index3 p, int b, Index alongB, int c, Index alongC)
{
  p[b] += alongB;
  p[c] += alongC;
  return p;
}

} // namespace

OctantFamilies::OctantFamilies(
  const OctreeKeys& lattice, std::vector<std::vector<Index>> requested) :
  TheLattice(lattice), Sets(std::move(requested)), Reports(lattice.NumberOfRefinements())
{
  this->Sets.resize(this->Reports.size());
  for (int level = this->NumberOfRefinements() - 1; level >= 0; --level)
  {
    SortUnique(this->Sets[level]);
    this->Reports[level].Requested = static_cast<Index>(this->Sets[level].size());
    if (level + 1 < this->NumberOfRefinements())
    {
      this->AddBalance(level);
    }
    this->CloseNonManifoldEdges(level);
  }
}

bool OctantFamilies::HasFamily(int level, const Index3& family) const
{
  const std::vector<Index>& set = this->Sets[level];
  return this->TheLattice.HasFamily(level, family) &&
    std::binary_search(set.begin(), set.end(), this->TheLattice.FamilyKey(level, family));
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

/// Adds the families of a level that the families of the next level need.
void OctantFamilies::AddBalance(int level)
{
  std::vector<Index> needed;
  for (Index key : this->Sets[level + 1])
  {
    const Index3 cell = this->TheLattice.FamilyOfKey(level + 1, key);
    for (int n = 0; n < 27; ++n)
    {
      const Index3 step = StepAround(n), other = CellAround(cell, n);
      if ((step[0] == 0 || step[1] == 0 || step[2] == 0) && this->TheLattice.HasCell(level, other))
      {
        needed.push_back(this->TheLattice.FamilyKey(level, ParentOfCell(other)));
      }
    }
  }
  SortUnique(needed);
  this->Reports[level].Balance = Merge(this->Sets[level], needed);
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
    SortUnique(added);
    const Index count = Merge(this->Sets[level], added);
    this->Reports[level].NonManifold += count;
    this->Reports[level].Rounds += count > 0;
    front = std::move(added);
  }
}

} // namespace vfm
