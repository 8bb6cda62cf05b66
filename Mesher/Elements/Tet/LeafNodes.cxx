#include "Elements/Tet/LeafNodes.h"

namespace vfm
{
namespace
{

/// Returns whether a corner of a leaf has a tet with another corner that is a fine vertex. Tets
/// join ends of edges without a midpoint, and opposite corners of faces without midpoints.
bool SeesFineVertex(const RefinedGrid& levels, const OctreeKeys::LevelIndex& leaf, int corner)
{
  const auto isWhole = [&](int axis)
  { return !HasMidpoint(levels, leaf, corner, corner ^ 1 << axis); };
  const auto isFine = [&](int flips)
  {
    const Index3 node = CornerOfCell(leaf.At, corner ^ flips);
    return IsFineVertex(levels, levels.FinestNode(leaf.Level, node));
  };
  bool sees = false;
  for (int a = 0; a < 3 && !sees; ++a)
  {
    const int b = (a + 1) % 3;
    sees = isWhole(a) && (isFine(1 << a) || (isWhole(b) && isFine(1 << a | 1 << b)));
  }
  return sees;
}

} // namespace

bool IsRefined(const RefinedGrid& levels, const OctreeKeys::LevelIndex& cell)
{
  return cell.Level < levels.NumberOfRefinements() &&
    levels.Families().IsRefined(cell.Level, cell.At);
}

bool IsFineVertex(const RefinedGrid& levels, const Index3& node)
{
  const int last = levels.NumberOfRefinements() - 1;
  bool isFine = false;
  for (int c = 0; c < 8 && !isFine; ++c)
  {
    const Index3 cell = CellOfStar(node, c);
    isFine = levels.Lattice().HasCell(last + 1, cell) &&
      IsRefined(levels, { last, ParentOfCell(cell), 0 });
  }
  return isFine;
}

bool HasMidpoint(
  const RefinedGrid& levels, const OctreeKeys::LevelIndex& leaf, int corner, int next)
{
  bool has = false;
  for (int n = 1; n < 4 && !has; ++n)
  {
    OctreeKeys::LevelIndex other = leaf;
    for (int a = 0, across = 0; a < 3; ++a)
    {
      if ((corner >> a & 1) == (next >> a & 1))
      {
        other.At[a] += n >> across++ & 1 ? (corner >> a & 1 ? 1 : -1) : 0;
      }
    }
    has = IsRefined(levels, other);
  }
  return has;
}

int FinestLevelAt(const RefinedGrid& levels, const Index3& node)
{
  int level = levels.Lattice()
                .NodeOfKey(levels.Lattice().LatticeKey(levels.NumberOfRefinements(), node))
                .Level;
  for (int c = 0; c < 8; ++c)
  {
    const Index3 cell = CellOfStar(node, c);
    if (levels.Finest().InDomain(cell))
    {
      level = std::max(level, levels.LeafOf(cell).Level);
    }
  }
  return level;
}

bool IsNearDistantVertex(const RefinedGrid& levels, const Index3& node)
{
  bool isNear = false;
  for (int c = 0; c < 8 && !isNear; ++c)
  {
    const Index3 cell = CellOfStar(node, c);
    if (!levels.Finest().InDomain(cell))
    {
      continue;
    }
    const OctreeKeys::LevelIndex leaf = levels.LeafOf(cell);
    const int corner = 7 - c; // of the leaf, if the node is one
    const bool isCorner = levels.FinestNode(leaf.Level, CornerOfCell(leaf.At, corner)) == node;
    isNear =
      leaf.Level < levels.NumberOfRefinements() && isCorner && SeesFineVertex(levels, leaf, corner);
  }
  return isNear;
}

} // namespace vfm
