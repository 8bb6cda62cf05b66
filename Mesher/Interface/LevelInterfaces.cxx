#include "Interface/LevelInterfaces.h"

#include "Fractions/CoarsenFields.h"

#include <unordered_map>

namespace vfm
{
namespace
{

// The two further layers are for CrossingFinder::FindNear, on levels above the base.
constexpr int LevelGhosts = GhostLayers + 2;
constexpr Index SearchRadius = 2; // distance of nodes for FindTarget, in cells
// Families around that of a node; at least 3 cells around the node.
constexpr Index NearFamilies = 2;

/// Classifies the cells of a level. The cells of a family (OctreeKeys.h) are all of one class,
/// unless single cells are refined.
class LevelCells
{
public:
  LevelCells(const RefinedGrid& levels, int level) : Levels(levels), Level(level) {}

  bool IsLeaf(const Index3& cell) const
  {
    return !this->IsInCoarserLeaf(cell) && !this->IsRefined(cell);
  }

  /// Returns whether a cell is a leaf or lies in a coarser leaf that touches a leaf of the level.
  bool HasLeafLabel(const Index3& cell)
  {
    return !this->IsRefined(cell) && (!this->IsInCoarserLeaf(cell) || this->TouchesLeaf(cell));
  }

  /// Returns whether a leaf is near the family of a node.
  bool IsNear(const Index3& node)
  {
    const Index3 family =
      ParentOfCell(ChangeLevel(this->Levels.Base().Global(), this->Level).Nearest(node));
    const auto at = this->Near.try_emplace(this->Lattice().FamilyKey(this->Level, family), false);
    if (at.second)
    {
      at.first->second = this->HasLeafAround(BoxOfCell(family), NearFamilies);
    }
    return at.first->second;
  }

private:
  const OctreeKeys& Lattice() const { return this->Levels.Lattice(); }
  bool IsRefined(const Index3& cell) const
  {
    return this->Level < this->Levels.NumberOfRefinements() &&
      this->Levels.Families().IsRefined(this->Level, cell);
  }
  bool IsInCoarserLeaf(const Index3& cell) const
  {
    return this->Level > 0 &&
      !this->Levels.Families().IsRefined(this->Level - 1, ParentOfCell(cell));
  }

  /// Returns whether the coarser leaf that contains a cell touches a leaf of the level.
  bool TouchesLeaf(const Index3& cell)
  {
    const OctreeKeys::LevelIndex leaf =
      this->Levels.LeafOf(this->Levels.FinestCells(this->Level, cell).Lower);
    const auto at =
      this->Touching.try_emplace(this->Lattice().HexKey(leaf.Level, leaf.At, 0), false);
    if (at.second)
    {
      // A leaf of the previous level is one family.
      const IndexBox families = ChangeLevel(BoxOfCell(leaf.At), this->Level - 1 - leaf.Level);
      at.first->second = this->HasLeafAround(families, 1);
    }
    return at.first->second;
  }

  /// Returns whether a family has a leaf.
  bool HasLeaf(const Index3& family) const
  {
    const bool areAlike = this->Levels.Families().UnitOfSets() == RefinedUnit::Family;
    bool found = false;
    for (int c = 0; c < (areAlike ? 1 : 8) && !found; ++c)
    {
      const Index3 cell = ChildOfCell(family, c);
      found = this->Lattice().HasCell(this->Level, cell) && this->IsLeaf(cell);
    }
    return found;
  }

  /// Returns whether there is a leaf in a box of families, or in the families around it.
  bool HasLeafAround(const IndexBox& families, Index around) const
  {
    const IndexBox all = ChangeLevel(ChangeLevel(this->Levels.Base().Global(), this->Level), -1);
    bool found = false;
    ForCells(Grow(families, around, all),
      [&](const Index3& family) { found = found || this->HasLeaf(family); });
    return found;
  }

  const RefinedGrid& Levels;
  int Level;
  // Results for the families and leaves checked so far.
  std::unordered_map<Index, bool> Near, Touching;
};

/// Sets the label of a cell and its mirrors if it needs the label of a leaf; returns whether the
/// cell lies in a coarser leaf.
bool SetLeafLabel(
  LevelCells& cells, const CartesianGrid& grid, Index cell, int label, LabelArray& labels)
{
  const Index3 position = grid.Position(cell);
  if (!cells.HasLeafLabel(position))
  {
    return false;
  }
  labels.Set(cell, label);
  grid.ForMirrors(cell, [&](Index mirror) { labels.Set(mirror, label); });
  return !cells.IsLeaf(position);
}

/// Row of labels of the finest grid, 2^Halvings times as fine as a row of a level.
struct FinestRow
{
  const LabelArray& Labels;
  Index First; // first cell of the row
  int Halvings;

  /// Returns the number of the first cell of the level that begins at or after a finest cell.
  Index CellFrom(Index finest) const
  {
    const Index round = (Index(1) << this->Halvings) - 1;
    return (finest - this->First + round) >> this->Halvings;
  }
};

/// Lists the cells of a row of a level whose label differs from their lowest finest cell, with the
/// label of the latter. Cells with equal labels are skipped in runs.
/// @param row,size  first cell and number of cells of the row
std::vector<std::array<Index, 2>> ListOthers(
  const FinestRow& finest, const LabelArray& labels, Index row, Index size)
{
  std::vector<std::array<Index, 2>> others;
  std::vector<Index> found;
  finest.Labels.Visit(
    finest.First, finest.First + (size << finest.Halvings),
    [&](Index begin, Index end, int label)
    {
      found.clear();
      FindOthers(labels, row + finest.CellFrom(begin), row + finest.CellFrom(end), label, found);
      for (Index cell : found)
      {
        others.push_back({ { cell, label } });
      }
    },
    [&](Index begin, Index end, const int* values)
    {
      for (Index n = finest.CellFrom(begin); n < finest.CellFrom(end); ++n)
      {
        const int label = values[finest.First + (n << finest.Halvings) - begin];
        if (labels[row + n] != label)
        {
          others.push_back({ { row + n, label } });
        }
      }
    });
  return others;
}

/// Sets the labels of leaves in the cells of a level that need them; returns the cells in coarser
/// leaves that got another label, ascending.
/// @param finest,finestLabels  the finest grid, 2^halvings times as fine
std::vector<Index> SetLeafLabels(const CartesianGrid& finest, const LabelArray& finestLabels,
  int halvings, const CartesianGrid& grid, LevelCells& cells, LabelArray& labels)
{
  std::vector<Index> steps;
  const IndexBox& box = grid.Local();
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first =
        finest.Linear({ { box.Lower[0] << halvings, j << halvings, k << halvings } });
      const Index row = grid.Linear({ { box.Lower[0], j, k } });
      for (const std::array<Index, 2>& other :
        ListOthers({ finestLabels, first, halvings }, labels, row, box.Size(0)))
      {
        if (SetLeafLabel(cells, grid, other[0], static_cast<int>(other[1]), labels))
        {
          steps.push_back(other[0]);
        }
      }
    });
  return steps;
}

/// Lists the steps from a node to nodes at most SearchRadius away along each
/// axis, the shortest first.
std::vector<Index3> MakeSteps()
{
  std::vector<Index3> steps;
  IndexBox box;
  box.Lower.fill(-SearchRadius);
  box.Upper.fill(SearchRadius + 1);
  ForCells(box, [&](const Index3& p) { steps.push_back(p); });
  const auto square = [](const Index3& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; };
  std::stable_sort(steps.begin(), steps.end(),
    [&](const Index3& a, const Index3& b) { return square(a) < square(b); });
  return steps;
}

} // namespace

LevelInterfaces::LevelInterfaces(const RefinedGrid& levels, const FractionField& fractions,
  const LabelArray& labels, std::vector<Index> mixed, double isoValue, Runtime& runtime,
  const std::vector<Index>& thin) :
  Levels(levels), FirstPoint(1, 0)
{
  const CartesianGrid& finest = levels.Finest();
  if (levels.HasFineInterfaces())
  {
    this->Interfaces.push_back(std::make_unique<Interface>(
      finest, fractions, labels, std::move(mixed), isoValue, runtime, std::vector<Index>(), thin));
    return;
  }
  for (int level = 0; level < levels.NumberOfRefinements(); ++level)
  {
    const int halvings = levels.NumberOfRefinements() - level;
    this->Grids.push_back(
      CoarsenGrid(finest, halvings, CountCoarseGhosts(finest, halvings, LevelGhosts)));
    const CartesianGrid& grid = this->Grids.back();
    this->AddLevel(level, grid, CoarsenFractions(finest, fractions, halvings, grid, runtime),
      labels, {}, isoValue, runtime);
  }
  this->AddLevel(levels.NumberOfRefinements(), finest, fractions, labels, thin, isoValue, runtime);
}

/// Adds the interface of a level; labels are on the finest grid.
void LevelInterfaces::AddLevel(int level, const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const std::vector<Index>& thin, double isoValue, Runtime& runtime)
{
  LevelCells cells(this->Levels, level);
  LabelArray own = AssignMaterials(grid, fractions, isoValue);
  const int halvings = this->Levels.NumberOfRefinements() - level;
  const std::vector<Index> steps =
    SetLeafLabels(this->Levels.Finest(), labels, halvings, grid, cells, own);
  std::vector<Index> nodes = FindMixedNodes(grid, own);
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(),
                [&](Index node) { return !cells.IsNear(grid.Position(node)); }),
    nodes.end());
  this->Interfaces.push_back(std::make_unique<Interface>(
    grid, fractions, own, std::move(nodes), isoValue, runtime, steps, thin));
  this->FirstPoint.push_back(
    this->FirstPoint.back() + static_cast<Index>(this->Interfaces.back()->Points().size()));
}

std::vector<const Interface*> LevelInterfaces::All() const
{
  std::vector<const Interface*> all;
  for (const auto& interface : this->Interfaces)
  {
    all.push_back(interface.get());
  }
  return all;
}

/// Returns the number of the surface point of a pair at a node itself, or -1.
Index LevelInterfaces::FindPoint(
  int level, const Index3& node, const std::array<int, 2>& labels) const
{
  const Interface& interface = this->Of(level);
  const Index n =
    interface.Grid().Local().Touches(node) ? interface.Find(interface.Grid().Linear(node)) : -1;
  const SurfacePoint* point = n < 0 ? nullptr : interface.FindPoint(n, labels[0], labels[1]);
  return point ? this->FirstPoint[this->PositionOf(level)] + (point - interface.Points().data())
               : -1;
}

Index LevelInterfaces::FindTarget(
  int level, const Index3& node, const std::array<int, 2>& labels) const
{
  static const std::vector<Index3> steps = MakeSteps();
  for (const Index3& step : steps) // the first step is 0
  {
    const Index found = this->FindPoint(
      level, { { node[0] + step[0], node[1] + step[1], node[2] + step[2] } }, labels);
    if (found >= 0)
    {
      return found;
    }
  }
  return -1;
}

} // namespace vfm
