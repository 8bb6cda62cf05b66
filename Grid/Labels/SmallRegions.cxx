#include "Labels/SmallRegions.h"

#include "Fractions/FractionSum.h"
#include "Fractions/GhostFractions.h"
#include "Labels/Fragments.h"
#include "Labels/JoinRegions.h"

#include <map>
#include <set>

namespace vfm
{
namespace
{

using Part = FractionField::Part;

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

/// Returns the number of cells of each region of this rank, over all ranks. Collective.
std::vector<Index> CountCells(const CartesianGrid& grid, const Fragments& regions)
{
  std::vector<Index> cells(regions.Share().Size(), 0);
  ForOwnedCells(grid, regions, [&](const Index3&, Index, int region) { ++cells[region]; });
  regions.Share().Merge(cells, 1, [](Index& a, Index b) { a += b; });
  return cells;
}

/// Counts the faces of small regions, seen from their owned cells.
/// @param cells  number of cells of each region
std::vector<SharedFaces> FindFaces(const CartesianGrid& grid, const Fragments& regions,
  const std::vector<Index>& cells, Index minimumCells)
{
  std::map<std::array<int, 2>, Index> counts;
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
          ++counts[{ { region, other } }];
        }
      }
    });
  std::vector<SharedFaces> mine;
  for (const auto& count : counts)
  {
    mine.push_back({ count.first[0], count.first[1], count.second });
  }
  return mine;
}

/// Counts the regions that get another material, and their cells, on all ranks. Collective.
RemovedRegions CountRemoved(const FragmentShare& regions, const std::vector<int>& newMaterials,
  const std::vector<Index>& cells, Ranks& ranks)
{
  std::vector<Index> counts(2, 0);
  for (std::size_t r = 1; r < regions.Size(); ++r)
  {
    if (regions.IsMine[r] && newMaterials[r] != regions.Materials[r])
    {
      ++counts[0];
      counts[1] += cells[r];
    }
  }
  ranks.Sum(counts);
  return { counts[0], counts[1] };
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
  const Fragments regions(grid, AssignMaterials(grid, fractions, isoValue), true, partition);
  const std::vector<Index> cells = CountCells(grid, regions);
  const std::vector<int> newMaterials = JoinRegions(
    regions.Share(), cells, minimumCells, FindFaces(grid, regions, cells, minimumCells), ranks);
  const RemovedRegions removed = CountRemoved(regions.Share(), newMaterials, cells, ranks);
  if (removed.Regions > 0)
  {
    fractions = Apply(grid, fractions, isoValue, regions, newMaterials);
    FillGhosts(partition, fractions);
  }
  return removed;
}

} // namespace vfm
