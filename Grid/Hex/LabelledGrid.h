/**
 * What hexahedra are made of: labels that pass the label condition, and the levels, which refer to them.
 */
#pragma once

#include "Hex/CoarseHexes.h"
#include "Labels/Labels.h"

#include <memory>

namespace vfm
{

/// A refined grid and its coarse hexes: none without refinements.
struct LevelHexes
{
  std::shared_ptr<const RefinedGrid> Grid;
  std::unique_ptr<CoarseHexes> Coarse;
  /// How many families were asked for, of each refinement, before any was added because no valid mesh started.
  std::vector<Index> RequestedFamilies;
};

struct LabelledGrid
{
  LabelledGrid() = default;
  LabelledGrid(const LabelledGrid&) = delete;
  LabelledGrid& operator=(const LabelledGrid&) = delete;

  LabelArray Labels;
  std::vector<Index> Mixed; ///< nodes of the grid with several labels around
  LevelHexes Levels;
};

} // namespace vfm
