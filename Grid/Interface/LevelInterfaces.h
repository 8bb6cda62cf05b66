/**
 * LevelInterfaces: the interfaces of a refined grid, one Interface for each level that has some, on the grid of that level: of the finest
 * level alone, or where interfaces cross levels (LevelPlan::FineInterfaces false) of all.
 *
 * Labels of a level: in its leaves (RefinedGrid::LeafOf), and in coarser leaves that touch one, those of the leaves; elsewhere what the
 * mean fractions of the level say. So the faces of leaves between two labels are all there, and beyond them the interface goes on as if
 * the level were everywhere, for the fits. Interfaces have nodes near leaves of their level alone: three cells around, or a little more.
 */
#pragma once

#include "Interface/Interface.h"
#include "Octree/RefinedGrid.h"

#include <deque>
#include <memory>

namespace vfm
{

class LevelInterfaces
{
public:
  /// fractions, labels: of the finest grid, in all its ghost layers; labels are resolved, and those of all cells of a leaf are alike.
  /// mixed: FindMixedNodes of them. Where interfaces cross levels the finest grid needs GhostLayers base cells around the owned ones to make the same on any number of ranks. Keeps a reference to
  /// levels.
  LevelInterfaces(const RefinedGrid& levels, const FractionField& fractions,
    const LabelArray& labels, const std::vector<Index>& mixed, double isoValue, Runtime& runtime);
  LevelInterfaces(const LevelInterfaces&) = delete;
  LevelInterfaces& operator=(const LevelInterfaces&) = delete;

  /// The interface of a level.
  const Interface& Of(int level) const { return *this->Interfaces[this->PositionOf(level)]; }
  /// From the coarsest level that has some: what SurfaceTargets takes.
  std::vector<const Interface*> All() const;

  /// The surface point of a pair at a node of a level: its number among those of all levels, level after level (SurfaceTargets). Where
  /// the node has none, that of the nearest node of the level that has, at most two cells away along each axis; -1: none.
  Index FindTarget(int level, const Index3& node, const std::array<int, 2>& labels) const;

private:
  void AddLevel(int level, const CartesianGrid& grid, const FractionField& fractions,
    const LabelArray& labels, double isoValue, Runtime& runtime);
  std::size_t PositionOf(int level) const
  {
    return this->Interfaces.size() - 1 - (this->Levels.NumberOfRefinements() - level);
  }
  Index FindPoint(int level, const Index3& node, const std::array<int, 2>& labels) const;

  const RefinedGrid& Levels;
  std::deque<CartesianGrid> Grids; // of the levels below the finest
  std::vector<std::unique_ptr<Interface>> Interfaces;
  std::vector<Index> FirstPoint; // of each level, among all
};

} // namespace vfm
