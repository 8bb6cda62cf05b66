/**
 * LevelInterfaces: the interfaces of a refined grid whose interfaces may run through cells of any level (LevelPlan::FineInterfaces
 * false): one Interface for each level, on the grid of that level.
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
  /// The finest grid needs GhostLayers base cells around the owned ones to make the same on any number of ranks. Keeps a reference to
  /// levels.
  LevelInterfaces(const RefinedGrid& levels, const FractionField& fractions,
    const LabelArray& labels, double isoValue, Runtime& runtime);
  LevelInterfaces(const LevelInterfaces&) = delete;
  LevelInterfaces& operator=(const LevelInterfaces&) = delete;

  int NumberOfLevels() const { return static_cast<int>(this->Interfaces.size()); }
  const Interface& Of(int level) const { return *this->Interfaces[level]; }
  /// Of all levels, from the base: what SurfaceTargets takes.
  std::vector<const Interface*> All() const;

  /// The surface point of a pair at a node of a level: its number among those of all levels, level after level (SurfaceTargets). Where
  /// the node has none, that of the nearest node of the level that has, at most two cells away along each axis; -1: none.
  Index FindTarget(int level, const Index3& node, int first, int second) const;

private:
  void AddLevel(int level, const CartesianGrid& grid, const FractionField& fractions,
    const LabelArray& labels, double isoValue, Runtime& runtime);
  Index FindPoint(int level, const Index3& node, int first, int second) const;

  const RefinedGrid& Levels;
  std::deque<CartesianGrid> Grids; // of the levels below the finest
  std::vector<std::unique_ptr<Interface>> Interfaces;
  std::vector<Index> FirstPoint; // of each level, among all
};

} // namespace vfm
