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

/// Faces that a small region shares with another, as one rank sees them.
struct SharedFaces
{
  Index Region, Other, Count;
};

/// Which regions join which, decided alike on all ranks. Regions are numbered from 1 by their lowest cell.
class RegionGraph
{
public:
  /// materials, cells: of each region, [0] unused. shared: may name a pair several times.
  RegionGraph(std::vector<int> materials, std::vector<Index> cells, Index minimumCells,
    const std::vector<SharedFaces>& shared);

  /// The material of each region in the end, [0] unused.
  std::vector<int> Merge();

private:
  int ChooseMaterial(Index region, std::set<Index>& joined);
  void Join(Index region, Index other);

  std::vector<int> Material; // of roots
  std::vector<Index> Cells;  // of roots
  std::vector<Index> Parent; // sets of regions
  Index MinimumCells;
  std::map<Index, std::map<Index, Index>>
    Faces; // of small roots, by regions that need not be roots
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

/// The material with the most faces around a region; joined: the regions of it there. -1: there is nothing around.
int RegionGraph::ChooseMaterial(Index region, std::set<Index>& joined)
{
  std::map<int, Index> faces; // by material
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

/// The lower number, so the lower cell, stays the root.
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

/// What is done to the fractions of the owned cells.
class RegionRemover
{
public:
  RegionRemover(const CartesianGrid& grid, const FractionField& fractions, double isoValue,
    const Partition& partition) :
    Grid(grid),
    Fractions(fractions),
    IsoValue(isoValue),
    Parts(partition),
    Labels(AssignMaterials(grid, fractions, isoValue)),
    Regions(grid, this->Labels, true, partition)
  {
  }

  RemovedRegions Decide(Index minimumCells);
  FractionField Apply() const;

private:
  /// From one material to another, near a removed region.
  struct Change
  {
    int From, To;
  };

  template <class Body>
  void ForOwnedCells(const Body& body) const;
  std::vector<Index> CountCells() const;
  std::vector<SharedFaces> FindFaces(const std::vector<Index>& cells, Index minimumCells) const;
  std::vector<Change> FindChanges(const Index3& cell, int label) const;
  std::vector<Part> ChangeParts(const Index3& p, int oldLabel, int label) const;

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  double IsoValue;
  const Partition& Parts;
  LabelArray Labels;
  Fragments Regions;
  std::vector<int> NewMaterials; // of each region
};

/// Calls body(position, cell, region).
template <class Body>
void RegionRemover::ForOwnedCells(const Body& body) const
{
  const IndexBox& box = this->Grid.Owned();
  ForRows(box,
    [&](Index j, Index k)
    {
      this->Regions.ForRuns(j, k,
        [&](Index first, Index last, int region)
        {
          const Index end = std::min(last, box.Upper[0]);
          for (Index i = std::max(first, box.Lower[0]); i < end; ++i)
          {
            body(Index3{ { i, j, k } }, this->Grid.Linear({ { i, j, k } }), region);
          }
        });
    });
}

/// Of each region, over all ranks.
std::vector<Index> RegionRemover::CountCells() const
{
  std::vector<Index> cells(this->Regions.NumberOfFragments() + 1, 0);
  this->ForOwnedCells([&](const Index3&, Index, int region) { ++cells[region]; });
  this->Parts.Group().Sum(cells);
  return cells;
}

/// Of the small regions, seen from the owned cells in them; on all ranks.
std::vector<SharedFaces> RegionRemover::FindFaces(
  const std::vector<Index>& cells, Index minimumCells) const
{
  std::map<std::pair<Index, Index>, Index> counts;
  this->ForOwnedCells(
    [&](const Index3& p, Index, int region)
    {
      for (int face = 0; cells[region] < minimumCells && face < 6; ++face)
      {
        Index3 q = p;
        q[face / 2] += (face & 1) ? 1 : -1;
        const int other = this->Grid.InDomain(q) ? this->Regions.FragmentOfCell(q) : region;
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
  return GatherItems(this->Parts.Group(), mine);
}

RemovedRegions RegionRemover::Decide(Index minimumCells)
{
  const std::vector<Index> cells = this->CountCells();
  const std::vector<int>& materials = this->Regions.MaterialsOfFragments();
  this->NewMaterials =
    RegionGraph(materials, cells, minimumCells, this->FindFaces(cells, minimumCells)).Merge();
  RemovedRegions removed;
  for (std::size_t r = 1; r < materials.size(); ++r)
  {
    if (this->NewMaterials[r] != materials[r])
    {
      ++removed.Regions;
      removed.Cells += cells[r];
    }
  }
  return removed;
}

/// What the removed regions around a cell ask for, its own first, then by their numbers; none from the cell's label.
std::vector<RegionRemover::Change> RegionRemover::FindChanges(const Index3& cell, int label) const
{
  const int own = this->Regions.FragmentOfCell(cell);
  const std::vector<int>& materials = this->Regions.MaterialsOfFragments();
  std::set<int> around;
  for (int v = 0; v < 27; ++v)
  {
    const Index3 q = CellAround(cell, v);
    if (v != 13 && this->Grid.InDomain(q))
    {
      around.insert(this->Regions.FragmentOfCell(q));
    }
  }
  std::vector<int> order{ own };
  order.insert(order.end(), around.begin(), around.end());
  std::vector<Change> changes;
  for (int region : order)
  {
    const int from = materials[region], to = this->NewMaterials[region];
    const auto isKnown = [from](const Change& change) { return change.From == from; };
    if (from != to && from != label && std::none_of(changes.begin(), changes.end(), isKnown))
    {
      changes.push_back({ from, to });
    }
  }
  return changes;
}

/// Moves a fraction; in the order of materials again.
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

/// The parts of a mixed cell in the end.
std::vector<Part> RegionRemover::ChangeParts(const Index3& p, int oldLabel, int label) const
{
  const FractionField::Range old = this->Fractions.Parts(this->Grid.Linear(p));
  std::vector<Part> parts(old.begin(), old.end());
  for (const Change& change : this->FindChanges(p, label))
  {
    std::vector<Part> moved = Moved(parts, change.From, change.To);
    const bool isOwn = oldLabel != label && change.From == oldLabel;
    const bool isKept = isOwn || MaterialOfParts(moved, this->IsoValue) == label;
    parts = isKept ? moved : Moved(parts, change.From, label);
  }
  if (MaterialOfParts(parts, this->IsoValue) != label)
  {
    parts = { { label, 1.0 } }; // three materials, none of which fills half
  }
  return parts;
}

FractionField RegionRemover::Apply() const
{
  FractionField result(this->Grid, this->Fractions.NumberOfMaterials());
  FractionField::RowWriter row(result);
  const IndexBox& box = this->Grid.Owned();
  this->ForOwnedCells(
    [&](const Index3& p, Index cell, int region)
    {
      if (p[0] == box.Lower[0])
      {
        row.Finish();
        row.Start(cell);
      }
      const int label = this->NewMaterials[region];
      if (!this->Fractions.IsMixed(cell))
      {
        row.AddLabel(label);
        return;
      }
      row.CopyParts(this->ChangeParts(p, this->Labels[cell], label));
    });
  row.Finish();
  return result;
}

} // namespace

RemovedRegions RemoveSmallRegions(const CartesianGrid& grid, Index minimumCells, double isoValue,
  const Partition& partition, FractionField& fractions)
{
  RegionRemover remover(grid, fractions, isoValue, partition);
  const RemovedRegions removed = remover.Decide(minimumCells);
  if (removed.Regions > 0)
  {
    fractions = remover.Apply();
    FillGhosts(partition, fractions);
  }
  return removed;
}

} // namespace vfm
