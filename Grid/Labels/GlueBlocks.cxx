#include "Labels/GlueBlocks.h"

#include "Labels/LabelCondition.h"
#include "Labels/SeamBlocks.h"

#include <map>
#include <set>

namespace vfm
{
namespace
{

/// Returns the axes across which labels of cells of blocks break the condition of flat seams, by
/// the lowest cell of the block.
std::map<Index, int> FindBroken(const LabelFlips& flips)
{
  std::map<Index, int> broken;
  for (Index node : flips.Violated)
  {
    const Index3 position = flips.Grid.Position(node);
    const int seams = flips.Grid.FlatSeams(position);
    const std::array<int, 8> star = StarOfNode(flips.Grid, flips.Labels, node);
    for (int n = 0; seams != 0 && n < 24; ++n)
    {
      const int axis = n / 8, c = n % 8;
      if ((seams >> axis & 1) != 0 && BreaksSeam(star, c, axis))
      {
        const IndexBox block = BlockOfCell(flips.Grid, CellOfStar(position, c));
        broken[flips.Grid.Linear(block.Lower)] |= 1 << axis;
      }
    }
  }
  return broken;
}

/// Returns the label of a box of cells for which the prices of all changes of cells have the
/// smallest sum; -1 if each label costs another label its last cell.
/// @param kept  labels that must not lose cells
int CheapestLabel(const LabelFlips& flips, const IndexBox& cells, const std::set<int>& kept)
{
  std::map<int, Index> counts;
  ForCells(cells, [&](const Index3& cell) { ++counts[flips.Labels[flips.Grid.Linear(cell)]]; });
  int best = -1;
  double lowest = 0.0;
  for (const auto& entry : counts)
  {
    const int label = entry.first;
    const bool may = std::none_of(counts.begin(), counts.end(),
      [&](const auto& other)
      {
        return other.first != label &&
          (kept.count(other.first) > 0 || flips.Sizes->IsLast(other.second, other.first));
      });
    double price = 0.0;
    ForCells(cells,
      [&](const Index3& cell)
      {
        const int current = flips.Labels[flips.Grid.Linear(cell)];
        price += current != label ? Price(flips, BoxOfCell(cell), current, label) : 0.0;
      });
    if (may && (best < 0 || price < lowest))
    {
      best = label;
      lowest = price;
    }
  }
  return best;
}

/// Returns the changes that glue a block along some axes, in addition to the axes along which it
/// is glued; empty if there is no way without the loss of a label.
std::vector<LabelChange> FindGluing(
  const LabelFlips& flips, const IndexBox& block, int axes, const std::set<int>& kept)
{
  axes |= FindGluedAxes(flips.Grid, flips.Labels, block);
  std::vector<LabelChange> changes;
  bool may = true;
  ForCells(block,
    [&](const Index3& cell)
    {
      const IndexBox part = PartOfBlock(block, axes, cell);
      if (part.Lower == cell)
      {
        changes.push_back({ part, CheapestLabel(flips, part, kept) });
        may = may && changes.back().Label >= 0;
      }
    });
  return may ? changes : std::vector<LabelChange>{};
}

/// Returns the labels that have no cell left after changes of all ranks.
/// @pre Collective.
std::vector<int> FindLostLabels(const LabelFlips& flips, const std::vector<LabelChange>& changes)
{
  for (const LabelChange& change : changes)
  {
    ForCells(Intersect(change.Cells, flips.Grid.Owned()),
      [&](const Index3& cell)
      { flips.Sizes->Add(1, flips.Labels[flips.Grid.Linear(cell)], change.Label); });
  }
  return flips.Sizes->FindLost();
}

/// Changes of blocks, as ApplyChanges needs them.
struct Gluing
{
  std::vector<LabelChange> Changes;
  std::vector<IndexBox> Others;
};

Gluing FindGluings(
  const LabelFlips& flips, const std::map<Index, int>& broken, const std::set<int>& kept)
{
  Gluing gluing;
  for (const auto& [lowest, axes] : broken)
  {
    const IndexBox block = BlockOfCell(flips.Grid, flips.Grid.Position(lowest));
    const std::vector<LabelChange> changes = FindGluing(flips, block, axes, kept);
    if (OwnsSome(flips, block))
    {
      gluing.Changes.insert(gluing.Changes.end(), changes.begin(), changes.end());
    }
    else if (!changes.empty())
    {
      gluing.Others.push_back(block);
    }
  }
  return gluing;
}

/// Glues blocks that break the condition of flat seams, all at once as far as no label is lost.
/// Returns whether there was one.
/// @pre Collective.
bool GlueOnce(LabelFlips& flips, Runtime& runtime)
{
  const std::map<Index, int> broken = FindBroken(flips);
  Gluing gluing;
  std::vector<int> lost;
  std::set<int> kept;
  do
  {
    gluing = FindGluings(flips, broken, kept);
    lost = FindLostLabels(flips, gluing.Changes);
    kept.insert(lost.begin(), lost.end());
  } while (!lost.empty());
  if (!flips.Parts.Group().Any(!gluing.Changes.empty()))
  {
    return false;
  }
  ApplyChanges(flips, gluing.Changes, gluing.Others);
  KeepViolated(flips, runtime);
  return true;
}

} // namespace

int GlueBlocks(LabelFlips& flips, Runtime& runtime)
{
  int rounds = 0;
  while (flips.HasBlocks && GlueOnce(flips, runtime))
  {
    ++rounds;
  }
  return rounds;
}

} // namespace vfm
