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

constexpr double Slack = 0.15; // of a halving: so much is not worth one (a tenth of a length)
constexpr double Speck = 0.05; // cells: what is thinner cannot be resolved and asks for nothing
static_assert(
  ThicknessReach <= GhostLayers && CurvatureReach <= GhostLayers, "cells that are read");

/// How many halvings, 0..most, multiply the cells across a length by about a factor.
int HalvingsFor(double factor, int most)
{
  const double wanted = std::ceil(std::log2(factor) - Slack);
  return static_cast<int>(std::min(std::max(wanted, 0.0), static_cast<double>(most)));
}

void CheckCriteria(const RefinementCriteria& criteria)
{
  if (!(criteria.ThinCells <= LargestThickness))
  {
    throw InputError("Thin features are those below " + std::to_string(criteria.ThinCells) +
      " cells: give at most " + std::to_string(LargestThickness) + ".");
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

/// Asks one criterion after another.
class Inquiry
{
public:
  Inquiry(const CartesianGrid& grid, const FractionField& fractions,
    const RefinementCriteria& criteria, double isoValue, const Partition& partition,
    Runtime& runtime) :
    Grid(grid),
    Fractions(fractions),
    Criteria(criteria),
    IsoValue(isoValue),
    ThePartition(partition),
    Run(runtime)
  {
  }

  RefinementWishes Ask()
  {
    if (this->Criteria.MaximumLevel > 0)
    {
      this->AskThickness();
      this->AskCurvature();
      this->AskLabels();
      this->AskChosen();
    }
    RefinementWishes& result = this->Result;
    Tidy(result.Cells);
    result.AllCells = static_cast<Index>(result.Cells.size());
    this->SumCounts();
    int most = 0;
    for (const RefinementWish& wish : result.Cells)
    {
      most = std::max(most, wish.Halvings);
    }
    result.Refinements = static_cast<int>(this->ThePartition.Group().Max(most));
    return std::move(result);
  }

private:
  void Wish(const Index3& cell, int halvings, Index& count)
  {
    if (halvings > 0)
    {
      this->Result.Cells.push_back({ this->Grid.CellKey(cell), halvings });
      ++count;
    }
  }

  void SumCounts()
  {
    RefinementWishes& result = this->Result;
    Index* const all[] = { &result.ThinCells, &result.CurvedCells, &result.FlippedCells,
      &result.NearCells, &result.ChosenCells, &result.AllCells };
    std::vector<Index> counts;
    for (const Index* count : all)
    {
      counts.push_back(*count);
    }
    this->ThePartition.Group().Sum(counts);
    for (std::size_t c = 0; c < counts.size(); ++c)
    {
      *all[c] = counts[c];
    }
  }

  /// Of each cell the most halvings, in the order of keys.
  static void Tidy(std::vector<RefinementWish>& cells)
  {
    std::sort(cells.begin(), cells.end(),
      [](const RefinementWish& a, const RefinementWish& b)
      { return a.Cell != b.Cell ? a.Cell < b.Cell : a.Halvings > b.Halvings; });
    cells.erase(
      std::unique(cells.begin(), cells.end(),
        [](const RefinementWish& a, const RefinementWish& b) { return a.Cell == b.Cell; }),
      cells.end());
  }

  /// Whether what is around a pure cell is not the same.
  bool IsBesideOthers(const Index3& p, Index cell) const
  {
    for (int c = 0; c < 27; ++c)
    {
      const Index3 q = CellAround(p, c);
      if (this->Grid.InDomain(q))
      {
        const Index other = this->Grid.Linear(q);
        if (this->Fractions.IsMixed(other) ||
          this->Fractions.Label(other) != this->Fractions.Label(cell))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// The most halvings that a part of the cell wants.
  int HalvingsForThickness(const Index3& p, Index cell) const
  {
    const double enough = this->Criteria.ThinCells;
    const auto halvings = [&](int material)
    {
      const double thickness = FindThickness(this->Grid, this->Fractions, p, material, enough);
      return thickness < Speck ? 0 : HalvingsFor(enough / thickness, this->Criteria.MaximumLevel);
    };
    if (!this->Fractions.IsMixed(cell))
    {
      return halvings(this->Fractions.Label(cell));
    }
    int most = 0;
    for (const FractionField::Part& part : this->Fractions.Parts(cell))
    {
      most = std::max(most, halvings(part.Material));
    }
    return most;
  }

  void AskThickness()
  {
    if (!(this->Criteria.ThinCells > 0.0))
    {
      return;
    }
    std::vector<Index3> cells;
    ForCells(this->Grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = this->Grid.Linear(p);
        if (this->Fractions.IsMixed(cell) || this->IsBesideOthers(p, cell))
        {
          cells.push_back(p);
        }
      });
    std::vector<int> halvings(cells.size());
    ForEach(this->Run, cells.size(),
      [&](Index n)
      { halvings[n] = this->HalvingsForThickness(cells[n], this->Grid.Linear(cells[n])); });
    for (std::size_t n = 0; n < cells.size(); ++n)
    {
      this->Wish(cells[n], halvings[n], this->Result.ThinCells);
    }
  }

  void AskCurvature()
  {
    if (!(this->Criteria.CurvaturePerCell > 0.0))
    {
      return;
    }
    for (const CellCurvature& c : FindCurvatures(this->Grid, this->Fractions, this->Run))
    {
      const double factor = c.Curvature / this->Criteria.CurvaturePerCell;
      this->Wish(this->Grid.Position(c.Cell), HalvingsFor(factor, this->Criteria.MaximumLevel),
        this->Result.CurvedCells);
    }
  }

  void AskLabels()
  {
    if (!this->Criteria.FlippedCells && this->Criteria.InterfaceLayers <= 0)
    {
      return;
    }
    const LabelArray before = AssignMaterials(this->Grid, this->Fractions, this->IsoValue);
    LabelArray labels = before;
    ResolveLabels(this->Grid, this->Fractions, labels, this->ThePartition, this->Run);
    ForCells(this->Grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = this->Grid.Linear(p);
        this->Wish(p, this->Criteria.FlippedCells && labels[cell] != before[cell],
          this->Result.FlippedCells);
      });
    if (this->Criteria.InterfaceLayers > 0)
    {
      const PagedArray<int> isNear = this->FindNear(labels);
      ForCells(this->Grid.Owned(),
        [&](const Index3& p)
        {
          const int halvings = isNear[this->Grid.Linear(p)] ? this->Criteria.MaximumLevel : 0;
          this->Wish(p, halvings, this->Result.NearCells);
        });
    }
  }

  void AskChosen()
  {
    std::vector<RefinementWish> chosen; // boxes may share cells
    for (const ChosenBox& box : this->Criteria.Chosen)
    {
      const int halvings = std::min(static_cast<int>(box.Halvings), this->Criteria.MaximumLevel);
      if (halvings > 0)
      {
        ForCells(Intersect(box.Cells, this->Grid.Owned()),
          [&](const Index3& p) {
            chosen.push_back({ this->Grid.CellKey(p), halvings });
          });
      }
    }
    Tidy(chosen);
    this->Result.ChosenCells = static_cast<Index>(chosen.size());
    this->Result.Cells.insert(this->Result.Cells.end(), chosen.begin(), chosen.end());
  }

  /// Whether each owned cell lies within the layers: cells at nodes with several labels, then cells at those.
  PagedArray<int> FindNear(const LabelArray& labels) const
  {
    PagedArray<int> isNear(this->Grid, 0);
    for (Index node : FindMixedNodes(this->Grid, labels))
    {
      this->MarkAround(node, isNear);
    }
    this->ThePartition.ExchangeCells(isNear, [](Index) {});
    for (int layer = 1; layer < this->Criteria.InterfaceLayers; ++layer)
    {
      const PagedArray<int> before = isNear;
      this->ThePartition.ForCells(this->Grid.Local(),
        [&](Index cell)
        {
          for (int c = 0; before[cell] && c < 8; ++c)
          {
            this->MarkAround(this->Grid.NodeOfCell(cell, c), isNear);
          }
        });
      this->ThePartition.ExchangeCells(isNear, [](Index) {});
    }
    return isNear;
  }

  void MarkAround(Index node, PagedArray<int>& marks) const
  {
    for (int c = 0; c < 8; ++c)
    {
      marks.Set(this->Grid.CellOfNode(node, c), 1);
    }
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const RefinementCriteria& Criteria;
  const double IsoValue;
  const Partition& ThePartition;
  Runtime& Run;
  RefinementWishes Result;
};

} // namespace

RefinementWishes FindRefinement(const CartesianGrid& grid, const FractionField& fractions,
  const RefinementCriteria& criteria, double isoValue, const Partition& partition, Runtime& runtime)
{
  CheckCriteria(criteria);
  return Inquiry(grid, fractions, criteria, isoValue, partition, runtime).Ask();
}

void AddWantedFamilies(const OctreeKeys& lattice, int level, const ChosenBox& wanted, int layers,
  std::vector<std::vector<Index>>& families)
{
  const int halvings = static_cast<int>(wanted.Halvings), finest = level + halvings;
  const IndexBox children =
    Grow(ChangeLevel(wanted.Cells, halvings), layers, ChangeLevel(lattice.Base().Global(), finest));
  for (int l = level; l < finest; ++l)
  {
    const IndexBox around =
      ChangeLevel(children, l - finest - 1); // a family is two cells of its level
    ForCells(around, [&](const Index3& q) { families[l].push_back(lattice.FamilyKey(l, q)); });
  }
}

std::vector<std::vector<Index>> FindWantedFamilies(
  const OctreeKeys& lattice, const RefinementWishes& wishes, int layers)
{
  std::vector<std::vector<Index>> families(wishes.Refinements);
  for (const RefinementWish& wish : wishes.Cells)
  {
    AddWantedFamilies(lattice, 0, { BoxOfCell(lattice.Base().CellOfKey(wish.Cell)), wish.Halvings },
      layers, families);
  }
  for (std::vector<Index>& keys : families)
  {
    SortUnique(keys);
  }
  return families;
}

} // namespace vfm
