#include "Labels/SmallRegions.h"

#include "Base/DisjointSets.h"
#include "Fractions/FractionSum.h"
#include "Fractions/GhostFractions.h"
#include "Labels/Fragments.h"

#include <map>
#include <set>

namespace vfm
{
namespace
{

using Part = FractionField::Part;

/// Number of faces that a small region shares with another, as one rank sees them.
struct SharedFaces
{
  Index Region, Other, Count;
};

/// Decides which regions join, equally on all ranks. Regions are numbered from 1
/// by their lowest cell.
class RegionGraph
{
public:
  /// @param materials,cells  one per region; [0] is unused
  /// @param shared  may contain a pair several times
  RegionGraph(std::vector<int> materials, std::vector<Index> cells, Index minimumCells,
    const std::vector<SharedFaces>& shared);

  /// Returns the final material of each region; [0] is unused.
  std::vector<int> Merge();

private:
  int ChooseMaterial(Index region, std::set<Index>& joined);
  void Join(Index region, Index other);

  std::vector<int> Material; // one per root
  std::vector<Index> Cells;  // one per root
  std::vector<Index> Parent; // sets of regions
  Index MinimumCells;
  // Number of faces of small roots, by region; regions need not be roots.
  std::map<Index, std::map<Index, Index>> Faces;
};

RegionGraph::RegionGraph(std::vector<int> materials, std::vector<Index> cells, Index minimumCells,
  const std::vector<SharedFaces>& shared) :
  Material(std::move(materials)),
  Cells(std::move(cells)),
  Parent(MakeSets(this->Material.size())),
  MinimumCells(minimumCells)
{
  for (const SharedFaces& faces : shared)
  {
    this->Faces[faces.Region][faces.Other] += faces.Count;
  }
}

/// Returns the material with the most faces around a region, or -1 if nothing is around. joined:
/// adds the adjacent regions of that material.
int RegionGraph::ChooseMaterial(Index region, std::set<Index>& joined)
{
  std::map<int, Index> faces; // one count per material
  for (const auto& shared : this->Faces[region])
  {
    const Index other = FindRoot(this->Parent, shared.first);
    if (other != region)
    {
      faces[this->Material[other]] += shared.second;
    }
  }
  int best = -1;
  for (const auto& count : faces)
  {
    best = best < 0 || count.second > faces[best] ? count.first : best;
  }
  for (const auto& shared : this->Faces[region])
  {
    const Index other = FindRoot(this->Parent, shared.first);
    if (other != region && this->Material[other] == best)
    {
      joined.insert(other);
    }
  }
  return best;
}

/// Joins two regions. The one with the lower number, hence the lower cell, stays the root.
void RegionGraph::Join(Index region, Index other)
{
  const Index root = std::min(region, other), child = std::max(region, other);
  vfm::Join(this->Parent, root, child);
  this->Cells[root] += this->Cells[child];
  const auto old = this->Faces.find(child);
  if (old != this->Faces.end())
  {
    for (const auto& shared : old->second)
    {
      this->Faces[root][shared.first] += shared.second;
    }
    this->Faces.erase(child);
  }
}

std::vector<int> RegionGraph::Merge()
{
  std::set<std::pair<Index, Index>> small; // cells, root
  for (std::size_t r = 1; r < this->Cells.size(); ++r)
  {
    if (this->Cells[r] < this->MinimumCells)
    {
      small.insert({ this->Cells[r], static_cast<Index>(r) });
    }
  }
  while (!small.empty())
  {
    Index region = small.begin()->second;
    small.erase(small.begin());
    std::set<Index> joined;
    const int material = this->ChooseMaterial(region, joined);
    if (material < 0)
    {
      continue;
    }
    for (Index other : joined)
    {
      small.erase({ this->Cells[other], other });
      this->Join(region, other);
      region = std::min(region, other);
    }
    this->Material[region] = material;
    if (this->Cells[region] < this->MinimumCells)
    {
      small.insert({ this->Cells[region], region });
    }
  }
  std::vector<int> materials;
  for (std::size_t r = 0; r < this->Material.size(); ++r)
  {
    materials.push_back(this->Material[FindRoot(this->Parent, static_cast<Index>(r))]);
  }
  return materials;
}

/// Change from one material to another, near a removed region.
struct Change
{
  int From, To;
};

/// Calls body(position, cell, region) for the owned cells.
template <class Body>
void ForOwnedCells(const CartesianGrid& grid, const Fragments& regions, const Body& body)
{
  const IndexBox& box = grid.Owned();
  ForRows(box,
    [&](Index j, Index k)
    {
      regions.ForRuns(j, k,
        [&](Index first, Index last, int region)
        {
          const Index end = std::min(last, box.Upper[0]);
          for (Index i = std::max(first, box.Lower[0]); i < end; ++i)
          {
            body(Index3{ { i, j, k } }, grid.Linear({ { i, j, k } }), region);
          }
        });
    });
}

/// Returns the number of cells of each region, over all ranks.
std::vector<Index> CountCells(const CartesianGrid& grid, const Fragments& regions, Ranks& ranks)
{
  std::vector<Index> cells(regions.NumberOfFragments() + 1, 0);
  ForOwnedCells(grid, regions, [&](const Index3&, Index, int region) { ++cells[region]; });
  ranks.Sum(cells);
  return cells;
}

/// Counts the faces of small regions, seen from their owned cells. Returns the counts of all ranks.
/// @param cells  number of cells of each region
std::vector<SharedFaces> FindFaces(const CartesianGrid& grid, const Fragments& regions,
  const std::vector<Index>& cells, Index minimumCells, Ranks& ranks)
{
  std::map<std::pair<Index, Index>, Index> counts;
  ForOwnedCells(grid, regions,
    [&](const Index3& p, Index, int region)
    {
      for (int face = 0; cells[region] < minimumCells && face < 6; ++face)
      {
        Index3 q = p;
        q[face / 2] += (face & 1) ? 1 : -1;
        const int other = grid.InDomain(q) ? regions.FragmentOfCell(q) : region;
        if (other != region)
        {
          ++counts[{ region, other }];
        }
      }
    });
  std::vector<SharedFaces> mine;
  for (const auto& count : counts)
  {
    mine.push_back({ count.first.first, count.first.second, count.second });
  }
  return GatherItems(ranks, mine);
}

/// Counts the regions that get another material, and their cells.
RemovedRegions CountRemoved(const std::vector<int>& oldMaterials,
  const std::vector<int>& newMaterials, const std::vector<Index>& cells)
{
  RemovedRegions removed;
  for (std::size_t r = 1; r < oldMaterials.size(); ++r)
  {
    if (newMaterials[r] != oldMaterials[r])
    {
      ++removed.Regions;
      removed.Cells += cells[r];
    }
  }
  return removed;
}

/// Returns the changes by the removed regions around a cell, its own first, then by number. No
/// change takes from the new label of the cell.
std::vector<Change> FindChanges(const CartesianGrid& grid, const Fragments& regions,
  const std::vector<int>& newMaterials, const Index3& cell)
{
  const int own = regions.FragmentOfCell(cell), label = newMaterials[own];
  const std::vector<int>& materials = regions.MaterialsOfFragments();
  std::set<int> around;
  for (int v = 0; v < 27; ++v)
  {
    const Index3 q = CellAround(cell, v);
    if (v != 13 && grid.InDomain(q))
    {
      around.insert(regions.FragmentOfCell(q));
    }
  }
  std::vector<int> order{ own };
  order.insert(order.end(), around.begin(), around.end());
  std::vector<Change> changes;
  for (int region : order)
  {
    const int from = materials[region], to = newMaterials[region];
    const auto isKnown = [from](const Change& change) { return change.From == from; };
    if (from != to && from != label && std::none_of(changes.begin(), changes.end(), isKnown))
    {
      changes.push_back({ from, to });
    }
  }
  return changes;
}

/// Moves a fraction from one material to another; parts stay in the order of materials.
std::vector<Part> Moved(std::vector<Part> parts, int from, int to)
{
  const auto source = std::find_if(
    parts.begin(), parts.end(), [from](const Part& part) { return part.Material == from; });
  if (source == parts.end() || from == to)
  {
    return parts;
  }
  const double fraction = source->Fraction;
  parts.erase(source);
  PartOf(parts, to).Fraction += fraction;
  return parts;
}

/// Returns the final parts of a mixed cell.
/// @param own  change of its label, which may remain
std::vector<Part> ChangeParts(
  FractionField::Range old, const std::vector<Change>& changes, const Change& own, double isoValue)
{
  const int label = own.To;
  std::vector<Part> parts(old.begin(), old.end());
  for (const Change& change : changes)
  {
    std::vector<Part> moved = Moved(parts, change.From, change.To);
    const bool isOwn = own.From != label && change.From == own.From;
    const bool isKept = isOwn || MaterialOfParts(moved, isoValue) == label;
    parts = isKept ? moved : Moved(parts, change.From, label);
  }
  if (MaterialOfParts(parts, isoValue) != label)
  {
    parts = { { label, 1.0 } }; // three materials, each below one half
  }
  return parts;
}

/// Returns the fractions of the owned cells after the regions got their new materials.
FractionField Apply(const CartesianGrid& grid, const FractionField& fractions, double isoValue,
  const Fragments& regions, const std::vector<int>& newMaterials)
{
  FractionField result(grid, fractions.NumberOfMaterials());
  FractionField::RowWriter row(result);
  const IndexBox& box = grid.Owned();
  ForOwnedCells(grid, regions,
    [&](const Index3& p, Index cell, int region)
    {
      if (p[0] == box.Lower[0])
      {
        row.Finish();
        row.Start(cell);
      }
      const Change own{ regions.MaterialsOfFragments()[region], newMaterials[region] };
      if (!fractions.IsMixed(cell))
      {
        row.AddLabel(own.To);
        return;
      }
      row.CopyParts(ChangeParts(
        fractions.Parts(cell), FindChanges(grid, regions, newMaterials, p), own, isoValue));
    });
  row.Finish();
  return result;
}

} // namespace

RemovedRegions RemoveSmallRegions(const CartesianGrid& grid, Index minimumCells, double isoValue,
  const Partition& partition, FractionField& fractions)
{
  Ranks& ranks = partition.Group();
  const Fragments regions(grid, AssignMaterials(grid, fractions, isoValue), true, partition,
    Fragments::Numbers::OfAllRanks);
  const std::vector<int>& materials = regions.MaterialsOfFragments();
  const std::vector<Index> cells = CountCells(grid, regions, ranks);
  RegionGraph graph(
    materials, cells, minimumCells, FindFaces(grid, regions, cells, minimumCells, ranks));
  const std::vector<int> newMaterials = graph.Merge();
  const RemovedRegions removed = CountRemoved(materials, newMaterials, cells);
  if (removed.Regions > 0)
  {
    fractions = Apply(grid, fractions, isoValue, regions, newMaterials);
    FillGhosts(partition, fractions);
  }
  return removed;
}

} // namespace vfm
