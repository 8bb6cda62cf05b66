#include "Surfaces/RepeatedTriangles.h"

#include "Base/DisjointSets.h"
#include "Surfaces/SurfaceEdges.h"

#include <algorithm>
#include <utility>

namespace vfm
{
namespace
{

/// Triangles with the same corners.
struct TriangleStack
{
  PatchTriangle Kept; ///< one of the turn that most of them have
  Index Count = 0;
  bool IsEven = false; ///< as many turn one way as the other
};

/// Which stacks of a connected set are kept.
enum class StackRule
{
  ByTurn,
  All,
  None
};

/// Returns the stacks in the order of the triangles, which are sorted.
std::vector<TriangleStack> FindStacks(const std::vector<PatchTriangle>& triangles)
{
  std::vector<TriangleStack> stacks;
  ForRuns(
    triangles.begin(), triangles.end(),
    [](const PatchTriangle& a, const PatchTriangle& b) { return a.HasSameCorners(b); },
    [&stacks](auto first, auto last)
    {
      const Index count = last - first;
      const Index ahead = std::count_if(
        first, last, [first](const PatchTriangle& t) { return t.Corners == first->Corners; });
      stacks.push_back({ 2 * ahead >= count ? *first : *(last - 1), count, 2 * ahead == count });
    });
  return stacks;
}

bool IsKept(const TriangleStack& stack, StackRule rule)
{
  return stack.Count == 1 || rule == StackRule::All || (rule == StackRule::ByTurn && !stack.IsEven);
}

/// Returns the sets of stacks of several triangles that are joined by edges.
std::vector<Index> JoinStacks(
  const std::vector<TriangleStack>& stacks, const std::vector<TriangleSide>& sides)
{
  std::vector<Index> parent = MakeSets(stacks.size());
  ForEdges(sides,
    [&](auto first, auto last)
    {
      Index before = -1;
      for (auto side = first; side != last; ++side)
      {
        if (stacks[side->Triangle].Count > 1)
        {
          Join(parent, side->Triangle, before < 0 ? side->Triangle : before);
          before = side->Triangle;
        }
      }
    });
  return parent;
}

/// Returns, for each set, the number of its edges that have an odd number of triangles.
std::vector<Index> CountOdd(const std::vector<TriangleStack>& stacks,
  const std::vector<TriangleSide>& sides, const std::vector<Index>& roots, StackRule rule)
{
  std::vector<Index> odd(stacks.size(), 0);
  ForEdges(sides,
    [&](auto first, auto last)
    {
      Index count = 0, root = -1;
      for (auto side = first; side != last; ++side)
      {
        const TriangleStack& stack = stacks[side->Triangle];
        count += IsKept(stack, rule);
        root = stack.Count > 1 ? roots[side->Triangle] : root;
      }
      if (root >= 0)
      {
        odd[root] += count % 2;
      }
    });
  return odd;
}

/// Returns the rule of each set, at the root of the set.
std::vector<StackRule> ChooseRules(const std::vector<TriangleStack>& stacks,
  const std::vector<TriangleSide>& sides, const std::vector<Index>& roots)
{
  std::vector<StackRule> best(stacks.size(), StackRule::ByTurn);
  std::vector<Index> least = CountOdd(stacks, sides, roots, StackRule::ByTurn);
  for (StackRule rule : { StackRule::All, StackRule::None })
  {
    const std::vector<Index> odd = CountOdd(stacks, sides, roots, rule);
    for (std::size_t s = 0; s < stacks.size(); ++s)
    {
      if (odd[s] < least[s])
      {
        least[s] = odd[s];
        best[s] = rule;
      }
    }
  }
  return best;
}

} // namespace

DroppedTriangles DropRepeated(PatchTriangles& surface)
{
  DroppedTriangles dropped;
  const std::vector<TriangleStack> stacks = FindStacks(surface.Triangles);
  if (stacks.size() == surface.Triangles.size())
  {
    return dropped;
  }
  PatchTriangles once{ surface.Points, {} };
  for (const TriangleStack& stack : stacks)
  {
    once.Triangles.push_back(stack.Kept);
  }
  const std::vector<TriangleSide> sides = SortSides(once);
  std::vector<Index> roots = JoinStacks(stacks, sides);
  for (Index& root : roots)
  {
    root = FindRoot(roots, root);
  }
  const std::vector<StackRule> rules = ChooseRules(stacks, sides, roots);
  surface.Triangles.clear();
  for (std::size_t s = 0; s < stacks.size(); ++s)
  {
    const bool isKept = IsKept(stacks[s], rules[roots[s]]);
    if (isKept)
    {
      surface.Triangles.push_back(stacks[s].Kept);
    }
    (isKept ? dropped.Repeated : dropped.BackToBack) += stacks[s].Count - isKept;
  }
  return dropped;
}

} // namespace vfm
