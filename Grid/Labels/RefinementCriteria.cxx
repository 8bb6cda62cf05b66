#include "Labels/RefinementCriteria.h"

#include "Base/Sorted.h"
#include "Fractions/InterfaceCurvature.h"
#include "Fractions/ThinFeatures.h"
#include "Labels/ResolveLabels.h"

#include <cmath>

namespace vfm
{
namespace
{

// This fraction of a halving, a tenth of a length, is not worth another one.
constexpr double Slack = 0.15;
// Thickness, in cells, below which features are not resolved and request nothing.
constexpr double Speck = 0.05;
static_assert(ThicknessReach <= GhostLayers && CurvatureReach <= GhostLayers,
  "ghost layers contain the cells that are read");

/// Returns the number of halvings, 0 to most, that multiply the cells across a length
/// by about a factor.
int HalvingsFor(double factor, int most)
{
  const double requested = std::ceil(std::log2(factor) - Slack);
  return static_cast<int>(std::min(std::max(requested, 0.0), static_cast<double>(most)));
}

void CheckCriteria(const RefinementCriteria& criteria)
{
  if (!(criteria.ThinCells <= LargestThickness))
  {
    throw InputError("The thickness of thin features is " + std::to_string(criteria.ThinCells) +
      " cells: it must be at most " + std::to_string(LargestThickness) + ".");
  }
  if (std::isnan(criteria.CurvaturePerCell))
  {
    throw InputError("The curvature per cell is not a number.");
  }
  if (criteria.MaximumLevel < 0)
  {
    throw InputError("The maximum level is " + std::to_string(criteria.MaximumLevel) +
      ": it must not be negative.");
  }
}

/// Evaluates one criterion after another.
struct Work
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const RefinementCriteria& Criteria;
  const double IsoValue;
  const Partition& ThePartition;
  Runtime& Run;
  RefinementRequests Result{};
};

void SumCounts(Work& work)
{
  RefinementRequests& result = work.Result;
  Index* const all[] = { &result.ThinCells, &result.CurvedCells, &result.FlippedCells,
    &result.NearCells, &result.ChosenCells, &result.AllCells };
  std::vector<Index> counts;
  for (const Index* count : all)
  {
    counts.push_back(*count);
  }
  work.ThePartition.Group().Sum(counts);
  for (std::size_t c = 0; c < counts.size(); ++c)
  {
    *all[c] = counts[c];
  }
}

/// Sorts requests by key and keeps the most halvings of each cell.
void Tidy(std::vector<RefinementRequest>& cells)
{
  std::sort(cells.begin(), cells.end(),
    [](const RefinementRequest& a, const RefinementRequest& b)
    { return a.Cell != b.Cell ? a.Cell < b.Cell : a.Halvings > b.Halvings; });
  cells.erase(
    std::unique(cells.begin(), cells.end(),
      [](const RefinementRequest& a, const RefinementRequest& b) { return a.Cell == b.Cell; }),
    cells.end());
}

void AddRequest(Work& work, const Index3& cell, int halvings, Index& count)
{
  if (halvings > 0)
  {
    work.Result.Cells.push_back({ work.Grid.CellKey(cell), halvings });
    ++count;
  }
}

/// Returns whether a pure cell has a mixed neighbour or one of another label.
bool IsNextToOthers(const Work& work, const Index3& p, Index cell)
{
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (work.Grid.InDomain(q))
    {
      const Index other = work.Grid.Linear(q);
      if (work.Fractions.IsMixed(other) ||
        work.Fractions.Label(other) != work.Fractions.Label(cell))
      {
        return true;
      }
    }
  }
  return false;
}

/// Returns the most halvings that a part of the cell requests.
int HalvingsForThickness(const Work& work, const Index3& p, Index cell)
{
  const double enough = work.Criteria.ThinCells;
  const auto halvings = [&](int material)
  {
    const double thickness = FindThickness(work.Grid, work.Fractions, p, material, enough);
    return thickness < Speck ? 0 : HalvingsFor(enough / thickness, work.Criteria.MaximumLevel);
  };
  int most = 0;
  work.Fractions.ForParts(
    cell, [&](int material, double) { most = std::max(most, halvings(material)); });
  return most;
}

void RequestByThickness(Work& work)
{
  if (!(work.Criteria.ThinCells > 0.0))
  {
    return;
  }
  std::vector<Index3> cells;
  ForCells(work.Grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = work.Grid.Linear(p);
      if (work.Fractions.IsMixed(cell) || IsNextToOthers(work, p, cell))
      {
        cells.push_back(p);
      }
    });
  std::vector<int> halvings(cells.size());
  ForEach(work.Run, cells.size(),
    [&](Index n)
    { halvings[n] = HalvingsForThickness(work, cells[n], work.Grid.Linear(cells[n])); });
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    AddRequest(work, cells[n], halvings[n], work.Result.ThinCells);
  }
}

void RequestByCurvature(Work& work)
{
  if (!(work.Criteria.CurvaturePerCell > 0.0))
  {
    return;
  }
  for (const CellCurvature& c : FindCurvatures(work.Grid, work.Fractions, work.Run))
  {
    const double factor = c.Curvature / work.Criteria.CurvaturePerCell;
    AddRequest(work, work.Grid.Position(c.Cell), HalvingsFor(factor, work.Criteria.MaximumLevel),
      work.Result.CurvedCells);
  }
}

void MarkAround(const Work& work, Index node, PagedArray<int>& marks)
{
  for (int c = 0; c < 8; ++c)
  {
    marks.Set(work.Grid.CellOfNode(node, c), 1);
  }
}

/// Marks the owned cells within the layers: first the cells at mixed nodes, then the cells that
/// share a node with marked ones.
PagedArray<int> FindNear(const Work& work, const LabelArray& labels)
{
  PagedArray<int> isNear(work.Grid, 0);
  for (Index node : FindMixedNodes(work.Grid, labels))
  {
    MarkAround(work, node, isNear);
  }
  work.ThePartition.ExchangeCells(isNear, [](Index) {});
  for (int layer = 1; layer < work.Criteria.InterfaceLayers; ++layer)
  {
    const PagedArray<int> before = isNear;
    work.ThePartition.ForCells(work.Grid.Local(),
      [&](Index cell)
      {
        for (int c = 0; before[cell] && c < 8; ++c)
        {
          MarkAround(work, work.Grid.NodeOfCell(cell, c), isNear);
        }
      });
    work.ThePartition.ExchangeCells(isNear, [](Index) {});
  }
  return isNear;
}

void RequestByLabels(Work& work)
{
  if (!work.Criteria.FlippedCells && work.Criteria.InterfaceLayers <= 0)
  {
    return;
  }
  const LabelArray before = AssignMaterials(work.Grid, work.Fractions, work.IsoValue);
  LabelArray labels = before;
  ResolveLabels(work.Grid, work.Fractions, labels, work.ThePartition, work.Run);
  ForCells(work.Grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = work.Grid.Linear(p);
      AddRequest(work, p, work.Criteria.FlippedCells && labels[cell] != before[cell],
        work.Result.FlippedCells);
    });
  if (work.Criteria.InterfaceLayers > 0)
  {
    const PagedArray<int> isNear = FindNear(work, labels);
    ForCells(work.Grid.Owned(),
      [&](const Index3& p)
      {
        const int halvings = isNear[work.Grid.Linear(p)] ? work.Criteria.MaximumLevel : 0;
        AddRequest(work, p, halvings, work.Result.NearCells);
      });
  }
}

void RequestChosen(Work& work)
{
  std::vector<RefinementRequest> chosen; // boxes may share cells
  for (const ChosenBox& box : work.Criteria.Chosen)
  {
    const int halvings = std::min(static_cast<int>(box.Halvings), work.Criteria.MaximumLevel);
    if (halvings > 0)
    {
      ForCells(Intersect(box.Cells, work.Grid.Owned()),
        [&](const Index3& p) {
          chosen.push_back({ work.Grid.CellKey(p), halvings });
        });
    }
  }
  Tidy(chosen);
  work.Result.ChosenCells = static_cast<Index>(chosen.size());
  work.Result.Cells.insert(work.Result.Cells.end(), chosen.begin(), chosen.end());
}

} // namespace

RefinementRequests FindRefinement(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, double isoValue, const Partition& partition, Runtime& runtime)
{
  CheckCriteria(criteria);
  Work work{ grid, fractions, criteria, isoValue, partition, runtime };
  if (work.Criteria.MaximumLevel > 0)
  {
    RequestByThickness(work);
    RequestByCurvature(work);
    RequestByLabels(work);
    RequestChosen(work);
  }
  RefinementRequests& result = work.Result;
  Tidy(result.Cells);
  result.AllCells = static_cast<Index>(result.Cells.size());
  SumCounts(work);
  int most = 0;
  for (const RefinementRequest& request : result.Cells)
  {
    most = std::max(most, request.Halvings);
  }
  result.Refinements = static_cast<int>(work.ThePartition.Group().Max(most));
  return std::move(result);
}

void AddRequestedFamilies(const OctreeKeys& lattice, int level, const ChosenBox& requested,
  int layers, std::vector<std::vector<Index>>& families)
{
  const int halvings = static_cast<int>(requested.Halvings), finest = level + halvings;
  const IndexBox children = Grow(
    ChangeLevel(requested.Cells, halvings), layers, ChangeLevel(lattice.Base().Global(), finest));
  for (int l = level; l < finest; ++l)
  {
    const IndexBox around =
      ChangeLevel(children, l - finest - 1); // a family spans two cells of its level
    ForCells(around, [&](const Index3& q) { families[l].push_back(lattice.FamilyKey(l, q)); });
  }
}

std::vector<std::vector<Index>> FindRequestedFamilies(
  const OctreeKeys& lattice, const RefinementRequests& requests, int layers)
{
  std::vector<std::vector<Index>> families(requests.Refinements);
  for (const RefinementRequest& request : requests.Cells)
  {
    AddRequestedFamilies(lattice, 0,
      { BoxOfCell(lattice.Base().CellOfKey(request.Cell)), request.Halvings }, layers, families);
  }
  for (std::vector<Index>& keys : families)
  {
    SortUnique(keys);
  }
  return families;
}

} // namespace vfm
