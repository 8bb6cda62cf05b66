#include "Levels/LevelFields.h"

#include "Base/Sorted.h"
#include "Fractions/CoarsenFields.h"
#include "Fractions/FractionSum.h"
#include "Fractions/GhostFractions.h"
#include "Input/InputRoute.h"
#include "Input/MakePartition.h"
#include "Levels/ExactChildren.h"
#include "Levels/ThinPlaces.h"
#include "Octree/OctreeKeys.h"
#include "Ranks/Agreement.h"

#include <sstream>

namespace vfm
{
namespace
{

constexpr double LargestSafeRatio = 1000.0; // of widths; no overlaps were seen below
constexpr int ChunkLevels =
  3; // cells are averaged in chunks of 2^ChunkLevels cells along each axis

/// Sets the cells of a box below finer blocks to the means of their children.
void AverageCells(const CartesianGrid& fineGrid, const FractionField& fine, const LevelCover& cover,
  const IndexBox& box, const CartesianGrid& grid, FractionField& field)
{
  ForCells(box,
    [&](const Index3& cell)
    {
      if (cover.Has(ChildOfCell(cell, 0))) // then all children are covered (CheckCover)
      {
        FractionSum mean;
        for (int c = 0; c < 8; ++c)
        {
          mean.Add(fine, fineGrid.Linear(ChildOfCell(cell, c)), 0.125);
        }
        field.CopyParts(grid.Linear(cell), mean.Parts());
      }
    });
}

/// Materials of all levels in the region of this rank.
struct LevelData
{
  const InputLevels& Input;
  const LevelCells& Cells;
  std::vector<std::vector<SparseCells>> Received{}; // cells of other ranks, by level
};

InputField MakeField(const LevelData& data, int level, const CartesianGrid& grid)
{
  return data.Cells[level]->MakeField(grid, data.Received[level]);
}

/// Sets the cells of a box below finer blocks to means over these blocks, recursively. Returns the
/// numbers of finer cells that were corrected.
CorrectedCells Average(const LevelData& data, int level, const IndexBox& box,
  const CartesianGrid& grid, FractionField& field)
{
  CorrectedCells corrected;
  ForCells(ChangeLevel(box, -ChunkLevels),
    [&](const Index3& place)
    {
      const IndexBox chunk = Intersect(ChangeLevel(BoxOfCell(place), ChunkLevels), box);
      const IndexBox finerBox = ChangeLevel(chunk, 1);
      const LevelCover cover(data.Input, level + 1, finerBox);
      if (!cover.IsEmpty())
      {
        const CartesianGrid finerGrid(data.Input.Levels[level + 1].Coordinates, finerBox);
        InputField finer = MakeField(data, level + 1, finerGrid);
        corrected.Add(finer.Corrected);
        if (level + 1 < data.Input.Finest())
        {
          corrected.Add(Average(data, level + 1, finerBox, finerGrid, finer.Fractions));
        }
        AverageCells(finerGrid, finer.Fractions, cover, chunk, grid, field);
      }
    });
  return corrected;
}

/// Levels 0 .. top of the input with their grids.
struct LevelStack
{
  std::vector<CartesianGrid> Grids;
  std::vector<InputField> Fields;
  CorrectedCells Corrected;
};

/// Collective. Reads the levels of this rank; data finer than the top level are averaged.
LevelStack ReadLevels(const InputLevels& input, const LevelCells& cells, const LevelSetup& setup,
  const std::vector<BlockPlace>& owners, Ranks& ranks)
{
  const int top = std::min(setup.Finest, input.Finest());
  const IndexBox owned = BoxOfRank(owners, ranks.Rank());
  WorkTogether(ranks, [&] { CheckCover(input, owned); });
  LevelData data{ input, cells };
  for (int level = 0; level <= input.Finest(); ++level)
  {
    data.Received.push_back(ReceiveCells(ChangeLevel(owners, level), input.Levels[level],
      *cells[level], level > top ? 0 : GhostLayers, ranks)); // only owned cells of finer levels
  }
  LevelStack levels;
  WorkTogether(ranks,
    [&]
    {
      const auto coordinates = HalveWidths(input.Levels[0].Coordinates, std::min(setup.Base, 0));
      for (int level = 0; level <= top; ++level)
      {
        levels.Grids.emplace_back(HalveWidths(coordinates, level - std::min(setup.Base, 0)),
          ChangeLevel(owned, level), GhostLayers);
        levels.Fields.push_back(MakeField(data, level, levels.Grids[level]));
        levels.Corrected.Add(levels.Fields[level].Corrected);
      }
      if (top < input.Finest())
      {
        levels.Corrected.Add(Average(
          data, top, levels.Grids[top].Owned(), levels.Grids[top], levels.Fields[top].Fractions));
      }
    });
  return levels;
}

/// Collective. Averages cells below finer blocks, from fine to coarse, and fills ghost cells.
void AverageLevels(const InputLevels& input, Ranks& ranks, LevelStack& levels)
{
  const int top = static_cast<int>(levels.Grids.size()) - 1;
  for (int level = std::min(top, input.Finest() - 1); level >= 0; --level)
  {
    const CartesianGrid& grid = levels.Grids[level];
    FractionField& field = levels.Fields[level].Fractions;
    if (level < top)
    {
      const CartesianGrid& finer = levels.Grids[level + 1];
      const LevelCover cover(input, level + 1, finer.Owned());
      AverageCells(finer, levels.Fields[level + 1].Fractions, cover, grid.Owned(), grid, field);
    }
    FillGhosts(Partition(grid, ranks), field);
  }
}

/// Replaces the fractions of a level by the fractions of the next finer level.
void RefineLevel(const InputLevels& input, const LevelStack& levels, int level, ChildRule rule,
  Runtime& runtime, FractionField& fractions)
{
  const CartesianGrid& finer = levels.Grids[level + 1];
  const LevelCover cover(input, level + 1, finer);
  RefinedCells refined = RefineCells(levels.Grids[level], fractions, runtime, rule,
    [&cover](const Index3& cell) { return cover.Has(ChildOfCell(cell, 0)); });
  const FractionField& data = levels.Fields[level + 1].Fractions;
  ForCells(finer.Local(),
    [&](const Index3& cell)
    {
      if (cover.Has(cell))
      {
        refined.Fractions.CopyCell(refined.Grid.Linear(cell), data, finer.Linear(cell));
      }
    });
  fractions = std::move(refined.Fractions);
}

/// Collective. Adds the copies of cells of a domain that repeats.
void AddLevelCopies(const std::array<bool, 3>& repeats, Ranks& ranks, LevelStack& levels)
{
  for (std::size_t level = 0; level < levels.Grids.size(); ++level)
  {
    CartesianGrid& grid = levels.Grids[level];
    ReplaceGrid(CartesianGrid::Covering(grid.Coordinates(), grid.Owned(), repeats, Seam::Free,
                  GhostLayers, HexLayers, Index(GhostLayers) << level),
      ranks, grid, levels.Fields[level].Fractions);
  }
}

/// Collective. Returns the field of the finest level.
InputField JoinLevels(const InputLevels& input, ChildRule rule, const std::array<bool, 3>& repeats,
  Runtime& runtime, LevelStack levels)
{
  Ranks& ranks = runtime.Group();
  const bool isPeriodic = repeats[0] || repeats[1] || repeats[2];
  if (isPeriodic)
  {
    AddLevelCopies(repeats, ranks, levels);
  }
  InputField field = std::move(levels.Fields[0]);
  for (int level = 0; level + 1 < static_cast<int>(levels.Grids.size()); ++level)
  {
    WorkTogether(ranks, [&] { RefineLevel(input, levels, level, rule, runtime, field.Fractions); });
    if (isPeriodic) // children of copies are rounded
    {
      FillGhosts(Partition(levels.Grids[level + 1], ranks), field.Fractions);
    }
  }
  if (isPeriodic)
  {
    CartesianGrid& finest = levels.Grids.back();
    ReplaceGrid(finest.OfDomain(GhostLayers), ranks, finest, field.Fractions);
  }
  std::vector<Index> corrected{ levels.Corrected.Normalised, levels.Corrected.Clipped };
  ranks.Sum(corrected);
  field.Corrected = { corrected[0], corrected[1] };
  return field;
}

/// Returns the keys of the families of a level, in a box, below finer blocks.
std::vector<Index> FindFamilies(
  const InputLevels& input, int level, const IndexBox& owned, const OctreeKeys& lattice, int step)
{
  std::vector<Index> keys;
  const LevelCover cover(input, level + 1, ChangeLevel(owned, 1));
  ForCells(owned,
    [&](const Index3& cell)
    {
      if (cover.Has(ChildOfCell(cell, 0)))
      {
        keys.push_back(lattice.FamilyKey(step, ParentOfCell(cell)));
      }
    });
  SortUnique(keys);
  return keys;
}

/// Returns the families that contain the parts of cells after a division.
/// @param lattice,divided keys of the bases before and after
std::vector<Index> DivideFamilies(const std::vector<Index>& keys, int step,
  const CellDivision& division, const OctreeKeys& lattice, const OctreeKeys& divided)
{
  const CellDivision ofLevel = division.OfHalves(step);
  const IndexBox cells = ChangeLevel(lattice.Base().Global(), step);
  std::vector<Index> result;
  for (Index key : keys)
  {
    const IndexBox family = ChangeLevel(BoxOfCell(lattice.FamilyOfKey(step, key)), 1);
    ForCells(ChangeLevel(ofLevel.Divide(Intersect(family, cells)), -1),
      [&](const Index3& q) { result.push_back(divided.FamilyKey(step, q)); });
  }
  SortUnique(result);
  return result;
}

/// Divides the cells of Base and Grid by fields.Division. Ghost cells are void afterwards.
void DivideCells(LevelFields& fields, ChildRule rule, Runtime& runtime)
{
  const int levels = static_cast<int>(fields.Families.size());
  RefinedCells refined = DivideCells(
    fields.Grid, fields.Field.Fractions, fields.Division.OfHalves(levels), runtime, rule);
  CartesianGrid base = CoarsenGrid(refined.Grid, levels, GhostLayers);
  const OctreeKeys before(fields.Base, levels), after(base, levels);
  for (int level = 0; level < levels; ++level)
  {
    fields.Families[level] =
      DivideFamilies(fields.Families[level], level, fields.Division, before, after);
  }
  fields.Base = std::move(base);
  fields.Grid = std::move(refined.Grid);
  fields.Field.Fractions = std::move(refined.Fractions);
}

/// Returns whether boxes of level 0 consist of whole cells of a coarser level.
bool AreAligned(const std::vector<IndexBox>& boxes, int levels)
{
  return std::all_of(boxes.begin(), boxes.end(),
    [levels](const IndexBox& box)
    { return ChangeLevel(ChangeLevel(box, -levels), levels) == box; });
}

} // namespace

IndexBox DistributeCells(
  const InputLevels& input, const LevelCells& cells, const LevelSetup& setup, Ranks& ranks)
{
  const int coarser = std::max(-setup.Base, 0);
  std::vector<IndexBox> held;
  for (int level = 0; level <= input.Finest(); ++level)
  {
    for (const IndexBox& box : input.Levels[level].Boxes())
    {
      held.push_back(ChangeLevel(box, -level - coarser));
    }
  }
  const bool mayStay =
    input.Finest() == 0 && !ranks.Any(!AreAligned(input.Levels[0].Boxes(), coarser));
  const auto findInterfaceCells = [&]
  {
    std::vector<Index3> found;
    for (int level = 0; level <= input.Finest(); ++level)
    {
      for (Index3 cell : cells[level]->FindInterfaceCells())
      {
        for (Index& i : cell)
        {
          i >>= level + coarser;
        }
        found.push_back(cell);
      }
    }
    return found;
  };
  return ChangeLevel(MakePartition(ChangeLevel(input.Levels[0].Global(), -coarser), held,
                       findInterfaceCells, ranks, mayStay),
    coarser);
}

LevelFields MakeLevelFields(const InputLevels& input, const LevelCells& cells,
  const LevelSetup& setup, ChildRule rule, const std::array<bool, 3>& repeats,
  const std::vector<BlockPlace>& owners, Runtime& runtime)
{
  LevelStack levels = ReadLevels(input, cells, setup, owners, runtime.Group());
  AverageLevels(input, runtime.Group(), levels);
  CartesianGrid grid = levels.Grids.back();
  InputField field = JoinLevels(input, rule, repeats, runtime, std::move(levels));
  const IndexBox owned = BoxOfRank(owners, runtime.Group().Rank());
  const int top = std::min(setup.Finest, input.Finest());
  LevelFields result{ CartesianGrid(HalveWidths(input.Levels[0].Coordinates, setup.Base),
                        ChangeLevel(owned, setup.Base), GhostLayers),
    std::move(grid), std::move(field), {}, {} };
  const OctreeKeys lattice(result.Base, setup.Finest - setup.Base);
  for (int level = setup.Base; level < top; ++level)
  {
    result.Families.push_back(setup.TakesInputLevels
        ? FindFamilies(input, level, ChangeLevel(owned, level), lattice, level - setup.Base)
        : std::vector<Index>());
  }
  return result;
}

void DivideFields(LevelFields& fields, double maximumAspectRatio, ChildRule rule, Runtime& runtime)
{
  runtime.Progress(0.0, "Dividing cells of high aspect ratio");
  WorkTogether(runtime.Group(),
    [&] { fields.Division = DivideLongCells(fields.Base.Coordinates(), maximumAspectRatio); });
  if (fields.Division.IsNone())
  {
    return;
  }
  WorkTogether(runtime.Group(), [&] { DivideCells(fields, rule, runtime); });
  FillGhosts(Partition(fields.Grid, runtime.Group()), fields.Field.Fractions);
}

namespace
{

/// Adds the families between Base and Grid that user-selected cells request, and those of `layers`
/// layers around them. Returns the requests for halvings beyond Grid, in cells of Grid.
std::vector<ChosenBox> TakeRequests(
  const InputRequests& requests, const LevelSetup& setup, int layers, LevelFields& fields)
{
  const Index steps = static_cast<Index>(fields.Families.size()); // levels from Base to Grid
  const OctreeKeys lattice(fields.Base, static_cast<int>(steps));
  std::vector<ChosenBox> beyond;
  for (int level = setup.Base; level - setup.Base <= steps; ++level)
  {
    const int step = level - setup.Base;
    const CellDivision division = fields.Division.OfHalves(step);
    for (const ChosenBox& row : requests.Levels[level])
    {
      const IndexBox first = ChangeLevel({ {}, fields.Base.Domain().Lower }, step);
      const IndexBox cells = Moved(division.Divide(row.Cells), first.Upper);
      const Index halvings = std::min(row.Halvings, steps - step);
      AddRequestedFamilies(lattice, step, { cells, halvings }, layers, fields.Families);
      if (row.Halvings > halvings)
      {
        beyond.push_back(
          { ChangeLevel(cells, static_cast<int>(halvings)), row.Halvings - halvings });
      }
    }
  }
  for (std::vector<Index>& keys : fields.Families)
  {
    SortUnique(keys);
  }
  return beyond;
}

/// Finds how many levels finer than Grid the criteria request, and adds the requested families.
/// Collective.
int FindFinerLevels(LevelFields& fields, const RefinementCriteria& criteria, double isoValue,
  int layers, Runtime& runtime)
{
  const Partition partition(fields.Grid, runtime.Group());
  const RefinementRequests requests =
    FindRefinement(fields.Grid, fields.Field.Fractions, criteria, isoValue, partition, runtime);
  const OctreeKeys lattice(fields.Grid, requests.Refinements);
  for (std::vector<Index>& families : FindRequestedFamilies(lattice, requests, layers))
  {
    fields.Families.push_back(std::move(families)); // keys are equal to keys of the lattice of Base
  }
  return requests.Refinements;
}

/// Halves the cells of a grid once.
/// @param bodies  in grid coordinates of unit, or null
RefinedCells HalveCells(const LevelFields& fields, ChildRule rule, const BodySurfaces* bodies,
  const CartesianGrid& unit, Runtime& runtime)
{
  const FractionField& fractions = fields.Field.Fractions;
  if (!bodies || rule != ChildRule::Planes)
  {
    return RefineCells(fields.Grid, fractions, runtime, rule);
  }
  const ExactChildren exact(*bodies, unit, fields.Grid, fractions, runtime);
  return RefineCells(fields.Grid, fractions, runtime, rule, {},
    [&exact](const Index3& cell) { return exact.Find(cell); });
}

/// Halves all cells of Grid.
/// Collective.
void HalveCells(
  int steps, ChildRule rule, const BodySurfaces* bodies, Runtime& runtime, LevelFields& fields)
{
  const CartesianGrid unit = fields.Grid;
  for (int step = 0; step < steps; ++step)
  {
    runtime.Progress(0.0, "Refining cells");
    WorkTogether(runtime.Group(),
      [&]
      {
        RefinedCells refined = HalveCells(fields, rule, bodies, unit, runtime);
        fields.Grid = std::move(refined.Grid);
        fields.Field.Fractions = std::move(refined.Fractions);
      });
  }
}

/// Returns the number of levels finer than the grid that criteria and selected cells request; adds
/// their families.
/// Collective.
int FindRefinements(const MesherOptions& options, const LevelSetup& setup,
  const InputRequests& requests, int finer, const BodySurfaces* bodies, Runtime& runtime,
  LevelFields& fields)
{
  runtime.Progress(0.0, "Looking for places to refine");
  const int layers = options.FineInterfaces ? 0 : options.FineLayers;
  RefinementCriteria criteria{ options.ThinCells, options.CurvaturePerCell,
    options.RefineFlippedCells, options.InterfaceLayers, {}, finer };
  WorkTogether(runtime.Group(),
    [&]
    {
      criteria.Chosen = TakeRequests(requests, setup, layers, fields);
      if (bodies && options.ThinCells > 0.0)
      {
        const std::vector<ChosenBox> thin = FindThinPlaces(
          *bodies, fields.Grid, fields.Field.Fractions, options.ThinCells, finer, runtime);
        criteria.Chosen.insert(criteria.Chosen.end(), thin.begin(), thin.end());
      }
    });
  return finer > 0 ? FindFinerLevels(fields, criteria, options.IsoValue, layers, runtime) : finer;
}

} // namespace

LevelPlan RefineFields(const MesherOptions& options, const LevelSetup& setup,
  const InputRequests& requests, int inputFinest, const BodySurfaces* bodies, Runtime& runtime,
  LevelFields& fields)
{
  const int top = std::min(setup.Finest, inputFinest);
  int finer = setup.Finest - top;
  if (options.Refinement == RefinementMode::Automatic)
  {
    finer = FindRefinements(options, setup, requests, finer, bodies, runtime, fields);
  }
  HalveCells(finer, options.ChildFractions, bodies, runtime, fields);
  LevelPlan plan{ options, 0, {} };
  if (!setup.IsUniform)
  {
    plan.Refinements = top - setup.Base + finer;
    plan.Families = std::move(fields.Families);
  }
  if (InterfacesCrossLevels(plan))
  {
    WidenGrid(LayersFor(plan), runtime.Group(), fields.Grid, fields.Field.Fractions);
  }
  return plan;
}

std::string DescribeWidths(const CartesianGrid& grid)
{
  double ratio = 1.0;
  std::array<std::array<double, 2>, 3> range; // smallest and largest width along each axis
  for (int a = 0; a < 3; ++a)
  {
    range[a] = { { grid.Width(a, 0), grid.Width(a, 0) } };
    for (Index i = 1; i < grid.Global().Upper[a]; ++i)
    {
      range[a][0] = std::min(range[a][0], grid.Width(a, i));
      range[a][1] = std::max(range[a][1], grid.Width(a, i));
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    ratio = std::max({ ratio, range[a][1] / range[b][0], range[b][1] / range[a][0] });
  }
  std::ostringstream text;
  if (ratio > LargestSafeRatio)
  {
    text << "The widths of a cell differ by a factor of " << ratio << ". Above " << LargestSafeRatio
         << ", elements have a poor quality, and bodies that are close may overlap. "
            "MaximumAspectRatio divides such cells.";
  }
  return text.str();
}

} // namespace vfm
