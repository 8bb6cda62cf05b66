#include "Levels/HalvedCells.h"

#include "Base/Sorted.h"
#include "Octree/OctreeKeys.h"

namespace vfm
{
namespace
{

/// Returns the cell of the domain that another one is, if axes repeat; a cell outside otherwise.
Index3 WrapCell(Index3 cell, const IndexBox& domain, const std::array<bool, 3>& repeats)
{
  for (int a = 0; a < 3; ++a)
  {
    const Index size = domain.Size(a);
    cell[a] = repeats[a] ? (cell[a] + size) % size : cell[a];
  }
  return cell;
}

} // namespace

HalvedCells::HalvedCells(const IndexBox& owned, int halvings)
{
  for (int level = 0; level < halvings; ++level)
  {
    this->Boxes.push_back(ChangeLevel(owned, level - halvings));
    this->Flags.emplace_back(this->Boxes[level].NumberOfCells(), 0);
  }
}

void HalvedCells::HalveParents()
{
  for (int level = this->NumberOfLevels() - 1; level > 0; --level)
  {
    ForCells(this->Boxes[level],
      [&](const Index3& cell)
      {
        if (this->Has(level, cell))
        {
          this->Halve(level - 1, ParentOfCell(cell));
        }
      });
  }
}

HalvedCells FindHalved(const CartesianGrid& grid, const FractionField& fractions,
  const std::vector<int>& ofMaterial, int halvings)
{
  HalvedCells halved(grid.Owned(), halvings);
  ForCells(grid.Owned(),
    [&](const Index3& cell)
    {
      int most = 0;
      fractions.ForParts(grid.Linear(cell),
        [&](int material, double) { most = std::max(most, ofMaterial[material]); });
      if (most > 0)
      {
        const IndexBox parent = ChangeLevel(BoxOfCell(cell), most - 1 - halvings);
        halved.Halve(most - 1, parent.Lower);
      }
    });
  halved.HalveParents();
  return halved;
}

std::vector<std::vector<Index>> FamiliesOf(const HalvedCells& halved, const CartesianGrid& base,
  const std::array<bool, 3>& repeats, Index layers)
{
  const OctreeKeys lattice(base, halved.NumberOfLevels());
  std::vector<std::vector<Index>> families(halved.NumberOfLevels());
  for (int level = 0; level < halved.NumberOfLevels(); ++level)
  {
    const IndexBox domain = ChangeLevel(base.Global(), level);
    ForCells(halved.Box(level),
      [&](const Index3& cell)
      {
        IndexBox around = halved.Has(level, cell) ? BoxOfCell(cell) : IndexBox();
        for (int a = 0; around.NumberOfCells() > 0 && a < 3; ++a)
        {
          around.Lower[a] -= layers;
          around.Upper[a] += layers;
        }
        ForCells(around,
          [&](const Index3& near)
          {
            const Index3 wrapped = WrapCell(near, domain, repeats);
            if (domain.Contains(wrapped))
            {
              families[level].push_back(lattice.FamilyKey(level, ParentOfCell(wrapped)));
            }
          });
      });
    SortUnique(families[level]);
  }
  return families;
}

} // namespace vfm
