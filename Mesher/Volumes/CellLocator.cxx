#include "Volumes/CellLocator.h"

#include "Fractions/RefineCells.h"

#include <limits>

namespace vfm
{

/// Searches the leaves around one. Only leaves that touch it count, because this rank may not know
/// cells of other ranks beyond them.
class CellLocator::Search
{
public:
  Search(const CellLocator& locator, const OctreeKeys::LevelIndex& leaf, int material) :
    Locator(locator),
    Material(material),
    Leaf(leaf),
    LeafBox(locator.Levels.FinestCells(leaf.Level, leaf.At)),
    HexBox(locator.Levels.Finest().HexBox())
  {
  }

  int Run()
  {
    for (Index c = 0; c < 27; ++c)
    {
      this->Visit(this->Leaf.Level,
        { { this->Leaf.At[0] + c % 3 - 1, this->Leaf.At[1] + c / 3 % 3 - 1,
          this->Leaf.At[2] + c / 9 - 1 } });
    }
    return this->Best;
  }

private:
  /// Visits a cell as large as the leaf, or its parts down to the leaves.
  void Visit(int level, const Index3& cell)
  {
    const RefinedGrid& levels = this->Locator.Levels;
    const IndexBox box = levels.FinestCells(level, cell);
    if (!levels.Lattice().HasCell(level, cell) || !this->TouchesLeaf(box))
    {
      return;
    }
    if (level == levels.NumberOfRefinements() || !levels.Families().IsRefined(level, cell))
    {
      this->Compare(box);
      return;
    }
    for (int c = 0; c < 8; ++c)
    {
      this->Visit(level + 1, ChildOfCell(cell, c));
    }
  }

  bool TouchesLeaf(const IndexBox& box) const
  {
    bool touches = true;
    for (int a = 0; a < 3; ++a)
    {
      touches =
        touches && box.Lower[a] <= this->LeafBox.Upper[a] && this->LeafBox.Lower[a] <= box.Upper[a];
    }
    return touches;
  }

  /// Compares a leaf with the best one so far. All its cells have one label and fragment; some are
  /// in HexBox, because the searched leaf is owned.
  void Compare(const IndexBox& box)
  {
    const Index3 cell = Intersect(box, this->HexBox).Lower;
    if (this->Locator.Labels[this->Locator.Grid.Linear(cell)] != this->Material)
    {
      return;
    }
    Index distance = 0; // squared distance of the centres, in half cells
    for (int a = 0; a < 3; ++a)
    {
      const Index d = box.Lower[a] + box.Upper[a] - this->LeafBox.Lower[a] - this->LeafBox.Upper[a];
      distance += d * d;
    }
    const int fragment = distance < this->Nearest ? this->Locator.Pieces.FragmentOfCell(cell) : 0;
    if (fragment > 0)
    {
      this->Best = fragment;
      this->Nearest = distance;
    }
  }

  const CellLocator& Locator;
  const int Material;
  const OctreeKeys::LevelIndex Leaf;
  const IndexBox LeafBox, HexBox;
  int Best = 0;
  Index Nearest = std::numeric_limits<Index>::max();
};

int CellLocator::FindNear(const Index3& cell, int material) const
{
  if (!this->Levels.HasFineInterfaces())
  {
    return Search(*this, this->Levels.LeafOf(cell), material).Run();
  }
  return FindNearestCell(this->Grid, cell,
    [&](const Index3& q) {
      return this->Labels[this->Grid.Linear(q)] == material ? this->Pieces.FragmentOfCell(q) : 0;
    });
}

FragmentVolumes VolumesOfCells(const CartesianGrid& grid, const FractionField& fractions,
  const RefinedGrid& levels, const LabelArray& labels, const Fragments& fragments, bool leavesFar,
  Runtime& runtime)
{
  const CellLocator locator(levels, labels, fragments);
  return FragmentVolumes(grid, fractions, fragments.Share(), locator, leavesFar, runtime);
}

} // namespace vfm
