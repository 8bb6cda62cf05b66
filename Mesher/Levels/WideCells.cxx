#include "Levels/WideCells.h"

#include "Base/ExactSum.h"
#include "Base/ParseText.h"
#include "Fractions/CoarsenFields.h"
#include "Fractions/GhostFractions.h"
#include "Fractions/ResampleFields.h"
#include "Input/NodeCoordinates.h"
#include "Labels/Labels.h"
#include "Ranks/Agreement.h"

namespace vfm
{
namespace
{

constexpr double KeptShare = 0.99; // of a volume, without a warning
constexpr int Tries = 2;           // of narrower cells that keep materials

/// Returns whether a cell or one around it has a label.
bool HasNear(const CartesianGrid& grid, const LabelArray& labels, const Index3& cell, int label)
{
  bool has = false;
  for (int n = 0; n < 27 && !has; ++n)
  {
    const Index3 near = CellAround(cell, n);
    has = grid.Local().Contains(near) && labels[grid.Linear(near)] == label;
  }
  return has;
}

/// Collective. Returns the share of the volume of each material that is at most one cell away from
/// a cell of the material, so that elements can contain it.
std::vector<double> FindKept(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue, Ranks& ranks)
{
  const LabelArray labels = AssignMaterials(grid, fractions, isoValue);
  const std::size_t materials = fractions.NumberOfMaterials() + 1;
  std::vector<ExactSum> sums(2 * materials); // whole volumes, then kept volumes
  ForCells(grid.Owned(),
    [&](const Index3& cell)
    {
      const double volume = grid.CellVolume(cell);
      fractions.ForParts(grid.Linear(cell),
        [&](int material, double fraction)
        {
          sums[material].Add(fraction * volume);
          if (fraction == 1.0 || HasNear(grid, labels, cell, material))
          {
            sums[materials + material].Add(fraction * volume);
          }
        });
    });
  const std::vector<double> volumes = SumOverRanks(sums, ranks);
  std::vector<double> kept;
  for (std::size_t m = 0; m < materials; ++m)
  {
    kept.push_back(volumes[m] > 0.0 ? volumes[materials + m] / volumes[m] : 1.0);
  }
  return kept;
}

/// Collective. Tries a few widths between these and those of the input (Tries), by bisection for
/// one that keeps all materials.
/// @param kept shares of volumes that are kept in cells of some widths
/// @return the largest tried factor of these widths that keeps each material; 0: none
std::vector<double> FindKeepingFactors(const LevelFields& read, const Vector3& widths,
  const std::vector<double>& kept, double isoValue, Runtime& runtime)
{
  const auto isLost = [](double share) { return share < KeptShare; };
  const GridNodes& nodes = read.Grid.Coordinates();
  const Vector3 before = MeanWidths(nodes);
  double ratio = 1.0; // of the widths of the input to these
  for (int a = 0; a < 3; ++a)
  {
    ratio = std::min(ratio, before[a] / widths[a]);
  }
  std::vector<double> factors(kept.size(), 0.0);
  double wide = 1.0, narrow = ratio; // between these is the width
  const bool isAnyLost = ratio < 1.0 && std::any_of(kept.begin() + 1, kept.end(), isLost);
  for (int n = 0; isAnyLost && n < Tries; ++n)
  {
    const double factor = std::sqrt(wide * narrow);
    Vector3 tried;
    for (int a = 0; a < 3; ++a)
    {
      tried[a] = std::max(widths[a] * factor, before[a]);
    }
    const ResampledFields other =
      ResampleFields(read.Grid, read.Field.Fractions, ReplaceNodes(nodes, tried), 1, runtime);
    const std::vector<double> now =
      FindKept(other.Grid, other.Fractions, isoValue, runtime.Group());
    bool keepsAll = true;
    for (std::size_t m = 1; m < kept.size(); ++m)
    {
      const bool isKept = !isLost(now[m]);
      keepsAll = keepsAll && (isKept || !isLost(kept[m]));
      factors[m] = isLost(kept[m]) && isKept ? std::max(factors[m], factor) : factors[m];
    }
    (keepsAll ? narrow : wide) = factor;
  }
  return factors;
}

/// Returns the cells of other nodes that overlap some cells of a grid.
IndexBox FindCells(const GridNodes& level, const IndexBox& cells, const GridNodes& nodes)
{
  IndexBox box;
  for (int a = 0; cells.NumberOfCells() > 0 && a < 3; ++a)
  {
    const std::vector<double>& x = nodes[a];
    box.Lower[a] = FindNode(x, level[a][cells.Lower[a]]);
    box.Upper[a] = std::lower_bound(x.begin(), x.end(), level[a][cells.Upper[a]]) - x.begin();
  }
  return box;
}

/// Returns the smallest box that contains two boxes, of which one may be without cells.
IndexBox Join(const IndexBox& one, const IndexBox& other)
{
  if (one.NumberOfCells() == 0 || other.NumberOfCells() == 0)
  {
    return one.NumberOfCells() > 0 ? one : other;
  }
  IndexBox joined;
  for (int a = 0; a < 3; ++a)
  {
    joined.Lower[a] = std::min(one.Lower[a], other.Lower[a]);
    joined.Upper[a] = std::max(one.Upper[a], other.Upper[a]);
  }
  return joined;
}

} // namespace

std::vector<Index> CountCells(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue, Ranks& ranks)
{
  std::vector<Index> counts(fractions.NumberOfMaterials() + 1, 0);
  const IndexBox& box = grid.Owned();
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      fractions.VisitRuns(first, first + box.Size(0),
        [&](Index begin, Index end, int label)
        { counts[label < 0 ? MaterialOfCell(fractions, begin, isoValue) : label] += end - begin; });
    });
  ranks.Sum(counts);
  return counts;
}

GridNodes ReplaceNodes(const GridNodes& nodes, const Vector3& widths)
{
  GridNodes replaced = nodes;
  for (int a = 0; a < 3; ++a)
  {
    if (widths[a] > 0.0)
    {
      replaced[a] = ReplaceNodes(nodes[a], widths[a]);
    }
    if (replaced[a].size() > nodes[a].size())
    {
      throw InputError("CellWidth is " + FormatNumber(widths[a]) + " along " + AxisNames[a] +
        ", and the cells of the input are " + FormatNumber(MeanWidth(nodes[a])) +
        " wide: it makes cells wider, not narrower. Refinement makes narrower cells.");
    }
  }
  return replaced;
}

WidePlan PlanCells(
  const InputLevels& input, const CartesianGrid& read, GridNodes nodes, int coarser)
{
  WidePlan plan{ std::move(nodes), coarser, {}, {} };
  const IndexBox owned =
    CellsOfOwner(read.Coordinates(), plan.Nodes, Index(1) << coarser, read.Owned());
  const CartesianGrid grid(plan.Nodes, owned, GhostLayers);
  plan.Needed = Join(read.Owned(), FindCells(plan.Nodes, grid.Local(), read.Coordinates()));
  plan.Place = ChangeLevel(plan.Needed, -input.Finest());
  return plan;
}

LevelFields HoldNeeded(const WidePlan& plan, const LevelFields& fields, Ranks& ranks)
{
  Index layers = GhostLayers;
  const IndexBox& owned = fields.Grid.Owned();
  for (int a = 0; plan.Needed.NumberOfCells() > 0 && a < 3; ++a)
  {
    layers = std::max(
      { layers, owned.Lower[a] - plan.Needed.Lower[a], plan.Needed.Upper[a] - owned.Upper[a] });
  }
  LevelFields held = fields;
  const auto all = static_cast<int>(ranks.Max(static_cast<double>(layers)));
  WidenGrid({ all, HexLayers }, ranks, held.Grid, held.Field.Fractions);
  return held;
}

WideReport WidenFields(const WidePlan& plan, const CellSizes& sizes, double isoValue,
  Runtime& runtime, LevelFields& fields)
{
  Ranks& ranks = runtime.Group();
  WideReport report;
  report.Widths = MeanWidths(plan.Nodes);
  report.MaterialWidths = WidthsOfMaterials(sizes);
  report.Halvings = report.MaterialWidths.empty() ? 0 : sizes.Halvings;
  report.InputCells = CountCells(fields.Grid, fields.Field.Fractions, isoValue, ranks);
  ResampledFields wide = ResampleFields(
    fields.Grid, fields.Field.Fractions, plan.Nodes, Index(1) << plan.Coarser, runtime);
  report.Cells = CountCells(wide.Grid, wide.Fractions, isoValue, ranks);
  if (report.MaterialWidths.empty())
  {
    report.Keeping = FindKeepingFactors(fields, report.Widths,
      FindKept(wide.Grid, wide.Fractions, isoValue, ranks), isoValue, runtime);
  }
  const double width = *std::max_element(report.Widths.begin(), report.Widths.end());
  for (double& keeping : report.Keeping)
  {
    keeping *= width;
  }
  fields.Grid = std::move(wide.Grid);
  fields.Field.Fractions = std::move(wide.Fractions);
  fields.Base = CoarsenGrid(fields.Grid, plan.Coarser, GhostLayers);
  fields.Families.assign(plan.Coarser, {});
  return report;
}

InputRequests WidenRequests(const InputRequests& requests, const InputLevels& input,
  const std::vector<BlockPlace>& owners, const CartesianGrid& grid, Ranks& ranks)
{
  InputRequests wide{ {}, requests.Cells, 0, "" };
  wide.Levels.resize(1);
  const InputRequests here = DistributeRequests(requests, input, owners, ranks);
  for (int level = 0; level <= input.Finest(); ++level)
  {
    for (const ChosenBox& row : here.Levels[level])
    {
      const IndexBox cells = Intersect(
        FindCells(input.Levels[level].Coordinates, row.Cells, grid.Coordinates()), grid.Owned());
      if (cells.NumberOfCells() > 0)
      {
        wide.Levels[0].push_back({ cells, row.Halvings });
        wide.Finest = std::max(wide.Finest, static_cast<int>(row.Halvings));
      }
    }
  }
  wide.Finest = static_cast<int>(ranks.Max(static_cast<double>(wide.Finest)));
  return wide;
}

} // namespace vfm
