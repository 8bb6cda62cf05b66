/**
 * LevelInterfaces: interfaces of a refined grid, one Interface per level that has interfaces, on
 * the grid of that level. These are all levels if interfaces cross levels
 * (LevelPlan::FineInterfaces false), else only the finest.
 *
 * A level has the labels of leaves (RefinedGrid::LeafOf) in its own leaves and in coarser leaves
 * that touch one. Elsewhere its labels follow from the mean fractions. So it has all faces of
 * leaves between two labels, and beyond them the interface continues for the fits, as if the
 * level were everywhere. Interfaces have nodes only near leaves of their level: three cells
 * around, or a little more.
 */
#pragma once

#include "Interface/Interface.h"
#include "Octree/RefinedGrid.h"

#include <deque>
#include <memory>

namespace vfm
{

/// Owns the interfaces and the grids of coarser levels; keeps a reference to the refined grid.
class LevelInterfaces
{
public:
  /// @param levels  must outlive this object
  /// @param fractions  fractions of the finest grid, in all its ghost layers
  /// @param labels  resolved labels of the same cells, equal in all cells of a leaf
  /// @param mixed  FindMixedNodes of the labels
  /// @param thin  cells, ascending, that got their label as a thin part
  /// @note Reproducible on any number of ranks. If interfaces cross levels, the finest grid needs
  ///   GhostLayers base cells around the owned ones for this.
  LevelInterfaces(const RefinedGrid& levels, const FractionField& fractions,
    const LabelArray& labels, std::vector<Index> mixed, double isoValue, Runtime& runtime,
    const std::vector<Index>& thin = {});
  LevelInterfaces(const LevelInterfaces&) = delete;
  LevelInterfaces& operator=(const LevelInterfaces&) = delete;

  /// Returns the interface of a level.
  const Interface& Of(int level) const { return *this->Interfaces[this->PositionOf(level)]; }
  /// Returns the interfaces of all levels that have some, the coarsest first,
  /// as SurfaceTargets takes them.
  std::vector<const Interface*> All() const;

  /// Returns the surface point of a pair at a node of a level. If the node has none, the nearest
  /// node of the level that has one is used, at most two cells away along each axis.
  /// @return number of the point among all levels, level after level, as in SurfaceTargets; -1 if
  ///   there is none
  Index FindTarget(int level, const Index3& node, const std::array<int, 2>& labels) const;

private:
  void AddLevel(int level, const CartesianGrid& grid, const FractionField& fractions,
    const LabelArray& labels, const std::vector<Index>& thin, double isoValue, Runtime& runtime);
  std::size_t PositionOf(int level) const
  {
    return this->Interfaces.size() - 1 - (this->Levels.NumberOfRefinements() - level);
  }
  Index FindPoint(int level, const Index3& node, const std::array<int, 2>& labels) const;

  const RefinedGrid& Levels;
  std::deque<CartesianGrid> Grids; // grids of the levels below the finest
  std::vector<std::unique_ptr<Interface>> Interfaces;
  std::vector<Index> FirstPoint; // first point of each level, among all
};

} // namespace vfm
