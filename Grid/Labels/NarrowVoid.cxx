#include "Labels/NarrowVoid.h"

#include "Labels/LeafLabels.h"

namespace vfm
{
namespace
{

constexpr int Reach = 2; // distance of the materials on both sides, in cells

struct Work
{
  const RefinedGrid& Levels;
  const LabelArray& Labels;
  const CartesianGrid& Grid = Levels.Finest();
  const LabelUnits Units{ Grid, Levels.HasFineInterfaces() ? nullptr : &Levels };
};

bool IsVoid(const Work& work, const Index3& cell)
{
  return work.Grid.Local().Contains(cell) && work.Labels[work.Grid.Linear(cell)] == 0;
}

/// Returns whether any cell of a box has a material.
bool HasMaterial(const Work& work, const IndexBox& cells)
{
  bool found = false;
  ForCells(Intersect(cells, work.Grid.Local()),
    [&](const Index3& cell) { found = found || work.Labels[work.Grid.Linear(cell)] > 0; });
  return found;
}

IndexBox Shifted(IndexBox cells, const Index3& step, Index factor)
{
  for (int a = 0; a < 3; ++a)
  {
    cells.Lower[a] += factor * step[a];
    cells.Upper[a] += factor * step[a];
  }
  return cells;
}

/// Returns whether a unit has a material within its reach on one side.
bool HasMaterialBeside(const Work& work, const IndexBox& cells, const Index3& step, Index side)
{
  bool found = false;
  for (Index distance = 1; distance <= Reach && !found; ++distance)
  {
    found = HasMaterial(work, Shifted(cells, step, side * distance * cells.Size(0)));
  }
  return found;
}

bool IsNarrow(const Work& work, const IndexBox& cells)
{
  bool isNarrow = false;
  for (int n = 0; n < 13 && !isNarrow; ++n) // one of each pair of opposite directions
  {
    isNarrow = HasMaterialBeside(work, cells, StepAround(n), 1) &&
      HasMaterialBeside(work, cells, StepAround(n), -1);
  }
  return isNarrow;
}

/// Calls visit(cell) for the void cells that can be narrow: those at mixed nodes, and a cell of
/// each unit around these.
template <class Visitor>
void ForCandidates(const Work& work, const std::vector<Index>& mixed, const Visitor& visit)
{
  PagedArray<unsigned char> isDone(work.Grid, 0);
  for (Index node : mixed)
  {
    const Index3 p = work.Grid.Position(node);
    for (int c = 0; c < 8; ++c)
    {
      const Index3 cell = CellOfStar(p, c);
      if (!IsVoid(work, cell) || isDone[work.Grid.Linear(cell)] != 0)
      {
        continue;
      }
      isDone.Set(work.Grid.Linear(cell), 1);
      const IndexBox cells = work.Units.CellsOf(work.Units.UnitOf(cell));
      for (int n = 0; n < 27; ++n)
      {
        const Index3 other = Shifted(BoxOfCell(cell), StepAround(n), cells.Size(0)).Lower;
        if (IsVoid(work, other))
        {
          visit(other);
        }
      }
    }
  }
}

} // namespace

NarrowVoid::NarrowVoid(
  const RefinedGrid& levels, const LabelArray& labels, const std::vector<Index>& mixed) :
  Cells(levels.Finest(), 0), Nodes(levels.Finest(), 0)
{
  const Work work{ levels, labels };
  PagedArray<unsigned char> isDone(work.Grid, 0);
  ForCandidates(work, mixed,
    [&](const Index3& cell)
    {
      const Index unit = work.Units.UnitOf(cell);
      if (isDone[unit] != 0 || (levels.HasFineInterfaces() && !levels.IsFine(cell)))
      {
        return;
      }
      isDone.Set(unit, 1);
      const IndexBox cells = work.Units.CellsOf(unit);
      if (IsNarrow(work, cells))
      {
        this->Add(work.Grid, cells);
      }
    });
}

void NarrowVoid::Add(const CartesianGrid& grid, const IndexBox& cells)
{
  this->Empty = false;
  vfm::ForCells(cells, [&](const Index3& cell) { this->Cells.Set(grid.Linear(cell), 1); });
  vfm::ForCells(NodesOf(cells), [&](const Index3& node) { this->Nodes.Set(grid.Linear(node), 1); });
  const IndexBox owned = Intersect(cells, grid.Owned());
  this->Owned += owned.NumberOfCells();
}

} // namespace vfm
