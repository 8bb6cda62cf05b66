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

using Requests = std::vector<RefinementRequest>;

/// Sorts requests by key and keeps the most halvings of each cell.
void Tidy(Requests& cells)
{
  std::sort(cells.begin(), cells.end(),
    [](const RefinementRequest& a, const RefinementRequest& b)
    { return a.Cell != b.Cell ? a.Cell < b.Cell : a.Halvings > b.Halvings; });
  cells.erase(
    std::unique(cells.begin(), cells.end(),
      [](const RefinementRequest& a, const RefinementRequest& b) { return a.Cell == b.Cell; }),
    cells.end());
}

/// Sums the counts of all ranks.
void SumCounts(RefinementRequests& result, Ranks& ranks)
{
  Index* const all[] = { &result.ThinCells, &result.CurvedCells, &result.FlippedCells,
    &result.NearCells, &result.ChosenCells, &result.AllCells };
  std::vector<Index> counts;
  for (const Index* count : all)
  {
    counts.push_back(*count);
  }
  ranks.Sum(counts);
  for (std::size_t c = 0; c < counts.size(); ++c)
  {
    *all[c] = counts[c];
  }
}

/// Adds the requests of one criterion; returns their number.
Index Add(const Requests& more, Requests& requests)
{
  requests.insert(requests.end(), more.begin(), more.end());
  return static_cast<Index>(more.size());
}

void AddRequest(const CartesianGrid& grid, const Index3& cell, int halvings, Requests& requests)
{
  if (halvings > 0)
  {
    requests.push_back({ grid.CellKey(cell), halvings });
  }
}

/// Returns whether a pure cell has a mixed neighbour or one of another label.
bool IsNextToOthers(const CartesianGrid& grid, const FractionField& fractions, const Index3& p)
{
  const int label = fractions.Label(grid.Linear(p));
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (grid.InDomain(q))
    {
      const Index other = grid.Linear(q);
      if (fractions.IsMixed(other) || fractions.Label(other) != label)
      {
        return true;
      }
    }
  }
  return false;
}

/// Returns the most halvings that a part of the cell requests.
int HalvingsForThickness(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, const Index3& p)
{
  const double enough = criteria.ThinCells;
  const auto halvings = [&](int material)
  {
    const double thickness = FindThickness(grid, fractions, p, material, enough);
    return thickness < Speck ? 0 : HalvingsFor(enough / thickness, criteria.MaximumLevel);
  };
  int most = 0;
  fractions.ForParts(
    grid.Linear(p), [&](int material, double) { most = std::max(most, halvings(material)); });
  return most;
}

Requests RequestByThickness(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, Runtime& runtime)
{
  Requests requests;
  if (!(criteria.ThinCells > 0.0))
  {
    return requests;
  }
  std::vector<Index3> cells;
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      if (fractions.IsMixed(grid.Linear(p)) || IsNextToOthers(grid, fractions, p))
      {
        cells.push_back(p);
      }
    });
  std::vector<int> halvings(cells.size());
  ForEach(runtime, cells.size(),
    [&](Index n) { halvings[n] = HalvingsForThickness(grid, fractions, criteria, cells[n]); });
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    AddRequest(grid, cells[n], halvings[n], requests);
  }
  return requests;
}

Requests RequestByCurvature(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, Runtime& runtime)
{
  Requests requests;
  if (!(criteria.CurvaturePerCell > 0.0))
  {
    return requests;
  }
  for (const CellCurvature& c : FindCurvatures(grid, fractions, runtime))
  {
    const double factor = c.Curvature / criteria.CurvaturePerCell;
    AddRequest(grid, grid.Position(c.Cell), HalvingsFor(factor, criteria.MaximumLevel), requests);
  }
  return requests;
}

void MarkAround(const CartesianGrid& grid, Index node, PagedArray<int>& marks)
{
  for (int c = 0; c < 8; ++c)
  {
    marks.Set(grid.CellOfNode(node, c), 1);
  }
}

/// Marks the owned cells within some layers: first the cells at mixed nodes, then the cells that
/// share a node with marked ones.
PagedArray<int> FindNear(
  const CartesianGrid& grid, const LabelArray& labels, int layers, const Partition& partition)
{
  PagedArray<int> isNear(grid, 0);
  for (Index node : FindMixedNodes(grid, labels))
  {
    MarkAround(grid, node, isNear);
  }
  partition.ExchangeCells(isNear, [](Index) {});
  for (int layer = 1; layer < layers; ++layer)
  {
    const PagedArray<int> before = isNear;
    partition.ForCells(grid.Local(),
      [&](Index cell)
      {
        for (int c = 0; before[cell] && c < 8; ++c)
        {
          MarkAround(grid, grid.NodeOfCell(cell, c), isNear);
        }
      });
    partition.ExchangeCells(isNear, [](Index) {});
  }
  return isNear;
}

/// Requests one halving of cells whose label changes.
Requests RequestFlipped(
  const CartesianGrid& grid, const LabelArray& before, const LabelArray& after)
{
  Requests requests;
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      AddRequest(grid, p, after[cell] != before[cell], requests);
    });
  return requests;
}

/// Requests some halvings of marked cells.
Requests RequestMarked(const CartesianGrid& grid, const PagedArray<int>& marks, int halvings)
{
  Requests requests;
  ForCells(grid.Owned(),
    [&](const Index3& p) { AddRequest(grid, p, marks[grid.Linear(p)] ? halvings : 0, requests); });
  return requests;
}

/// Adds requests and their counts by the labels that the mesh will have.
void RequestByLabels(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, double isoValue, const Partition& partition, Runtime& runtime,
  RefinementRequests& result)
{
  if (!criteria.FlippedCells && criteria.InterfaceLayers <= 0)
  {
    return;
  }
  const LabelArray before = AssignMaterials(grid, fractions, isoValue);
  LabelArray labels = before;
  ResolveLabels(grid, fractions, labels, partition, runtime);
  if (criteria.FlippedCells)
  {
    result.FlippedCells = Add(RequestFlipped(grid, before, labels), result.Cells);
  }
  if (criteria.InterfaceLayers > 0)
  {
    const PagedArray<int> isNear = FindNear(grid, labels, criteria.InterfaceLayers, partition);
    result.NearCells = Add(RequestMarked(grid, isNear, criteria.MaximumLevel), result.Cells);
  }
}

Requests RequestChosen(const CartesianGrid& grid, const RefinementCriteria& criteria)
{
  Requests chosen; // boxes may share cells
  for (const ChosenBox& box : criteria.Chosen)
  {
    const int halvings = std::min(static_cast<int>(box.Halvings), criteria.MaximumLevel);
    ForCells(Intersect(box.Cells, grid.Owned()),
      [&](const Index3& p) { AddRequest(grid, p, halvings, chosen); });
  }
  Tidy(chosen);
  return chosen;
}

} // namespace

int HalvingsFor(double factor, int most)
{
  const double requested = std::ceil(std::log2(factor) - Slack);
  return static_cast<int>(std::min(std::max(requested, 0.0), static_cast<double>(most)));
}

RefinementRequests FindRefinement(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, double isoValue, const Partition& partition, Runtime& runtime)
{
  CheckCriteria(criteria);
  RefinementRequests result;
  if (criteria.MaximumLevel > 0)
  {
    result.ThinCells = Add(RequestByThickness(grid, fractions, criteria, runtime), result.Cells);
    result.CurvedCells = Add(RequestByCurvature(grid, fractions, criteria, runtime), result.Cells);
    RequestByLabels(grid, fractions, criteria, isoValue, partition, runtime, result);
    result.ChosenCells = Add(RequestChosen(grid, criteria), result.Cells);
  }
  Tidy(result.Cells);
  result.AllCells = static_cast<Index>(result.Cells.size());
  SumCounts(result, partition.Group());
  int most = 0;
  for (const RefinementRequest& request : result.Cells)
  {
    most = std::max(most, request.Halvings);
  }
  result.Refinements = static_cast<int>(partition.Group().Max(most));
  return result;
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
