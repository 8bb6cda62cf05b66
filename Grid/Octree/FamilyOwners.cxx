#include "Octree/FamilyOwners.h"

#include "Base/Sorted.h"

namespace vfm
{
namespace
{

/// Returns the first cell of a family.
Index3 FirstCell(const Index3& family)
{
  return ChildOfCell(family, 0);
}

/// Returns the distance of a cell from a range of cells, 0 inside.
Index DistanceFrom(Index lower, Index upper, Index cell)
{
  return std::max<Index>({ 0, lower - cell, cell - upper + 1 });
}

/// Returns the number of layers around a box that contain another box.
Index LayersTo(const IndexBox& box, const IndexBox& wider)
{
  Index layers = 0;
  for (int a = 0; a < 3; ++a)
  {
    layers = std::max({ layers, box.Lower[a] - wider.Lower[a], wider.Upper[a] - box.Upper[a] });
  }
  return layers;
}

} // namespace

FamilyOwners::FamilyOwners(const OctreeKeys& lattice, const IndexBox& part, Index layers,
  const std::vector<std::vector<Index>>& requested, int halvings, Ranks& ranks) :
  Lattice(lattice),
  Window(lattice.Base(), lattice.Base().Owned(),
    static_cast<int>(this->FindLayers(part, layers, requested, halvings, ranks))),
  Parts(this->Window, ranks)
{
}

/// Returns the number of layers of base cells around the owned ones, on all ranks the same, that
/// contain the cells in which any rank reads families, and the requested families of any rank.
Index FamilyOwners::FindLayers(const IndexBox& part, Index layers,
  const std::vector<std::vector<Index>>& requested, int halvings, Ranks& ranks) const
{
  const IndexBox& owned = this->Lattice.Base().Owned();
  Index most = LayersTo(owned, part) + layers;
  for (std::size_t i = 0; owned.NumberOfCells() > 0 && i < requested.size(); ++i)
  {
    const int level = static_cast<int>(i) + halvings;
    for (Index key : requested[i])
    {
      const Index3 cell = FirstCell(this->Lattice.FamilyOfKey(level, key));
      most = std::max(most, this->DistanceOf(level, this->NearestCopy(level, cell)));
    }
  }
  return static_cast<Index>(ranks.Max(static_cast<double>(most)));
}

/// Returns the distance of a cell of a level from the owned ones, in base cells: the largest along
/// the axes.
Index FamilyOwners::DistanceOf(int level, const Index3& cell) const
{
  const IndexBox& owned = this->Lattice.Base().Owned();
  Index distance = 0;
  for (int a = 0; a < 3; ++a)
  {
    distance = std::max(distance, DistanceFrom(owned.Lower[a], owned.Upper[a], cell[a] >> level));
  }
  return distance;
}

/// Returns the copy of a cell of a level that is nearest to the owned ones.
Index3 FamilyOwners::NearestCopy(int level, const Index3& cell) const
{
  const CartesianGrid& base = this->Lattice.Base();
  Index3 nearest = cell;
  for (int a = 0; a < 3; ++a)
  {
    const Index period = base.Period(a) << level;
    const auto distance = [&](Index i)
    { return DistanceFrom(base.Owned().Lower[a] << level, base.Owned().Upper[a] << level, i); };
    for (Index copy = period > 0 ? cell[a] % period : this->Lattice.Cells(level, a);
         copy < this->Lattice.Cells(level, a); copy += period)
    {
      nearest[a] = distance(copy) < distance(nearest[a]) ? copy : nearest[a];
    }
  }
  return nearest;
}

bool FamilyOwners::Owns(int level, const Index3& family) const
{
  return ChangeLevel(this->Window.Owned(), level).Contains(FirstCell(family));
}

std::vector<Index> FamilyOwners::ToOwners(int level, const std::vector<Index>& keys) const
{
  std::vector<Index> owned;
  std::vector<std::vector<Index>> sent(this->Parts.Peers().size());
  const bool hasCells = this->Window.Owned().NumberOfCells() > 0;
  for (std::size_t k = 0; hasCells && k < keys.size(); ++k)
  {
    const Index3 cell =
      this->NearestCopy(level, FirstCell(this->Lattice.FamilyOfKey(level, keys[k])));
    if (this->DistanceOf(level, cell) == 0)
    {
      owned.push_back(this->Lattice.FamilyKeyOf({ level, cell, 0 }));
      continue;
    }
    const int peer =
      this->Parts.PeerOfCell({ { cell[0] >> level, cell[1] >> level, cell[2] >> level } });
    const Index3 shift = this->Parts.ShiftOf(peer);
    sent[peer].push_back(this->Lattice.FamilyKeyOf({ level,
      { { cell[0] - (shift[0] << level), cell[1] - (shift[1] << level),
        cell[2] - (shift[2] << level) } },
      0 }));
  }
  for (std::vector<Index>& list : sent)
  {
    SortUnique(list);
  }
  for (const std::vector<Index>& list : this->Parts.Exchange(sent))
  {
    owned.insert(owned.end(), list.begin(), list.end());
  }
  SortUnique(owned);
  return owned;
}

std::vector<Index> FamilyOwners::WithGhosts(
  int level, const std::vector<Index>& owned, const IndexBox& near) const
{
  std::vector<Index> keys = owned;
  this->Parts.ExchangeBoxes(
    [&](const IndexBox& box)
    {
      const IndexBox cells = ChangeLevel(box, level);
      std::vector<Index> sent; // first cells, numbered in the box
      for (Index key : owned)
      {
        const Index3 cell = FirstCell(this->Lattice.FamilyOfKey(level, key));
        if (cells.Contains(cell))
        {
          sent.push_back(IndexInBox(cells, cell));
        }
      }
      return ToBytes(sent);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      const IndexBox cells = ChangeLevel(box, level);
      for (Index index : FromBytes<Index>(bytes))
      {
        const Index3 cell = CellInBox(cells, index);
        if (near.Contains(cell))
        {
          keys.push_back(this->Lattice.FamilyKeyOf({ level, cell, 0 }));
        }
      }
    });
  SortUnique(keys);
  return keys;
}

} // namespace vfm
