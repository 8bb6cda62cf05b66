#include "Levels/FitWidths.h"

#include "Fractions/ResampleFields.h"
#include "Labels/Fragments.h"
#include "Levels/WideCells.h"
#include "Ranks/Agreement.h"
#include "Ranks/KeyMerge.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr int StepsOfHalf = 6;        // tried widths from one to half of it
constexpr Index FewestCells = 8;      // of a material
constexpr Index FewestOfFragment = 2; // wider cells of a fragment that counts
constexpr double LargestLoss = 0.6;   // of the cells of a material
constexpr double Rounding = 1e-9;     // of widths
// Elements that replace the eight cells of a family: 64, transitions around, and those of families
// that are added for validity.
constexpr double ElementsOfFamily = 600.0;

/// Returns the widths that are tried: the widest, and narrower ones above 1.
std::vector<double> ListWidths(double widest)
{
  std::vector<double> widths;
  for (int step = 0; widest * std::exp2(-step / double(StepsOfHalf)) > 1.0 + Rounding; ++step)
  {
    widths.push_back(widest * std::exp2(-step / double(StepsOfHalf)));
  }
  return widths;
}

bool Fits(const MaterialFit& fit, double width, double allowed)
{
  const double cells = static_cast<double>(fit.Cells);
  return fit.Cells == 0 ||
    (fit.Distance() <= allowed &&
      cells >= static_cast<double>(FewestCells) * width * width * width &&
      static_cast<double>(fit.Lost) <= LargestLoss * cells);
}

/// Collective. Returns the number of fragments of some cells and more of materials 0, 1, .. on all
/// ranks.
std::vector<Index> CountFragments(
  const CartesianGrid& grid, const LabelArray& labels, int materials, Index fewest, Ranks& ranks)
{
  const Fragments fragments(grid, labels, false, Partition(grid, ranks));
  const FragmentShare& share = fragments.Share();
  std::vector<Index> cells(share.Size(), 0);
  const IndexBox& owned = grid.Owned();
  ForRows(owned,
    [&](Index j, Index k)
    {
      Index end = 0;
      for (Index i = owned.Lower[0]; i < owned.Upper[0]; i = end)
      {
        const int fragment = fragments.FragmentOfCell({ { i, j, k } }, end);
        end = std::min(end, owned.Upper[0]);
        cells[fragment] += end - i;
      }
    });
  share.Merge(cells, 1, [](Index& a, Index b) { a += b; });
  std::vector<Index> counts(materials + 1, 0);
  for (std::size_t f = 1; f < share.Size(); ++f)
  {
    counts[share.Materials[f]] += share.IsMine[f] && cells[f] >= fewest;
  }
  ranks.Sum(counts);
  return counts;
}

/// Collective. Returns the number of fragments of FewestOfFragment and more of materials 0, 1, ..
/// in wider cells.
std::vector<Index> CountWiderFragments(const CartesianGrid& grid, const FractionField& fractions,
  const GridNodes& wider, double isoValue, Runtime& runtime)
{
  const ResampledFields wide = ResampleFields(grid, fractions, wider, 1, runtime);
  return CountFragments(wide.Grid, AssignMaterials(wide.Grid, wide.Fractions, isoValue),
    fractions.NumberOfMaterials(), FewestOfFragment, runtime.Group());
}

/// Returns the smallest number of halvings of a width that gives a narrower one.
int CountHalvings(double from, double to)
{
  int halvings = 0;
  for (; std::ldexp(from, -halvings) > to * (1.0 + Rounding); ++halvings)
  {
  }
  return halvings;
}

/// Families at the nodes of the cells of this rank.
class FamiliesOfRank
{
public:
  /// @param width of a family, in cells of the input
  FamiliesOfRank(const CartesianGrid& grid, double width) :
    Width(width),
    Box{ this->FamilyAt(grid.Owned().Lower), CornerOfCell(this->FamilyAt(grid.Owned().Upper), 7) },
    Contain(this->Box.NumberOfCells(), 0)
  {
  }

  void Add(const Index3& node) { this->Contain[IndexInBox(this->Box, this->FamilyAt(node))] = 1; }

  /// Collective. Returns the number of families on all ranks.
  Index Count(Ranks& ranks) const
  {
    std::vector<Index> counts(1, 0);
    std::vector<Index3> border; // families that other ranks may have too
    for (std::size_t f = 0; f < this->Contain.size(); ++f)
    {
      const Index3 family = CellInBox(this->Box, static_cast<Index>(f));
      if (this->Contain[f] != 0 && !this->IsInside(family))
      {
        border.push_back(family);
      }
      counts[0] += this->Contain[f] != 0 && this->IsInside(family);
    }
    std::sort(border.begin(), border.end());
    counts[0] += static_cast<Index>(KeyMerge<Index3>(std::move(border), ranks).HomeKeys().size());
    ranks.Sum(counts);
    return counts[0];
  }

private:
  Index3 FamilyAt(const Index3& node) const
  {
    Index3 family;
    for (int a = 0; a < 3; ++a)
    {
      family[a] = static_cast<Index>(static_cast<double>(node[a]) / this->Width);
    }
    return family;
  }
  bool IsInside(const Index3& family) const
  {
    bool isInside = true;
    for (int a = 0; a < 3; ++a)
    {
      isInside = isInside && family[a] > this->Box.Lower[a] && family[a] < this->Box.Upper[a] - 1;
    }
    return isInside;
  }

  const double Width;
  const IndexBox Box;
  std::vector<unsigned char> Contain; // whether each family contains cells
};

/// Collective. Returns the number of families that contain cells of materials, on all ranks.
/// @param width of a family, in cells of the input
/// @param isIn whether a label is one of these materials
template <class IsIn>
Index CountFamilies(
  const CartesianGrid& grid, const LabelArray& labels, double width, const IsIn& isIn, Ranks& ranks)
{
  FamiliesOfRank families(grid, width);
  ForCells(grid.Owned(),
    [&](const Index3& cell)
    {
      for (int c = 0; c < 8 && isIn(labels[grid.Linear(cell)]); ++c)
      {
        families.Add(CornerOfCell(cell, c));
      }
    });
  return families.Count(ranks);
}

/// Collective. Estimates the number of elements: the cells inside of materials, one more per side
/// of a cell at their surfaces, and those of families.
double EstimateElements(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<FittedWidth>& fitted, const WidthChoice& choice, Ranks& ranks)
{
  const double width = choice.Coarsest;
  double elements = 0.0;
  for (std::size_t m = 1; m < fitted.size(); ++m)
  {
    const MaterialFit& extent = fitted[m].Extent;
    elements +=
      static_cast<double>(extent.Cells) / (width * width * width) + extent.Area() / (width * width);
  }
  for (int level = 0; level < choice.Halvings; ++level)
  {
    const auto isHalved = [&](int label) { return choice.OfMaterial[label] > level; };
    const Index families =
      CountFamilies(grid, labels, std::ldexp(width, 1 - level), isHalved, ranks);
    elements += ElementsOfFamily * static_cast<double>(families);
  }
  return elements;
}

} // namespace

/// Two layers of the widest cells, which are rounded to fill the domain, by up to a half more.
int LayersOf(const WidthLimits& limits)
{
  return std::max(GhostLayers, static_cast<int>(std::ceil(3.0 * limits.Widest)));
}

std::vector<FittedWidth> FitWidths(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const WidthLimits& limits, double isoValue, Runtime& runtime)
{
  const Vector3 ofInput = MeanWidths(grid.Coordinates());
  std::vector<FittedWidth> fitted(fractions.NumberOfMaterials() + 1, { 1.0, {} });
  const std::vector<Index> fragments =
    CountFragments(grid, labels, fractions.NumberOfMaterials(), 1, runtime.Group());
  std::size_t found = 0; // materials with a width
  for (const double ratio : ListWidths(limits.Widest))
  {
    const Vector3 widths{ { ratio * ofInput[0], ratio * ofInput[1], ratio * ofInput[2] } };
    const GridNodes wider = ReplaceNodes(grid.Coordinates(), widths);
    const std::vector<MaterialFit> fits =
      FindFits(grid, fractions, labels, wider, isoValue, runtime);
    const std::vector<Index> pieces =
      CountWiderFragments(grid, fractions, wider, isoValue, runtime);
    for (std::size_t m = 0; m < fits.size(); ++m)
    {
      const bool isFirst = fitted[m].Ratio == 1.0 && pieces[m] <= fragments[m] &&
        Fits(fits[m], ratio, limits.Distance);
      fitted[m] = { isFirst ? ratio : fitted[m].Ratio, fits[m] };
      found += isFirst;
    }
    if (found == fitted.size())
    {
      break;
    }
  }
  return fitted;
}

WidthChoice ChooseWidths(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<FittedWidth>& fitted, const WidthLimits& limits, Ranks& ranks)
{
  WidthChoice best{ 1.0, 0, std::vector<int>(fitted.size(), 0) };
  double least = EstimateElements(grid, labels, fitted, best, ranks);
  for (const double coarsest : ListWidths(limits.Widest))
  {
    WidthChoice choice{ coarsest, 0, { 0 } };
    for (std::size_t m = 1; m < fitted.size(); ++m)
    {
      choice.OfMaterial.push_back(CountHalvings(coarsest, fitted[m].Ratio));
      choice.Halvings = std::max(choice.Halvings, choice.OfMaterial[m]);
    }
    if (choice.Halvings <= limits.Halvings &&
      std::ldexp(coarsest, -choice.Halvings) >= 1.0 - Rounding)
    {
      const double elements = EstimateElements(grid, labels, fitted, choice, ranks);
      best = elements < least ? choice : best;
      least = std::min(elements, least);
    }
  }
  return best;
}

} // namespace vfm
