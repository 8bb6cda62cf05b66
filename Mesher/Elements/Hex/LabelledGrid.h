/**
 * LabelledGrid: the labels of a grid, which pass the label condition, and its levels. They are the
 * input of hexahedral meshes. The levels refer to the labels.
 */
#pragma once

#include "Elements/BarrierElements.h"
#include "Elements/Hex/CoarseHexes.h"
#include "Labels/Labels.h"

#include <memory>

namespace vfm
{

/// Refined grid and its coarse hexes; without refinements there are no coarse hexes.
struct LevelHexes
{
  std::shared_ptr<const RefinedGrid> Grid;
  std::unique_ptr<CoarseHexes> Coarse;
  /// Number of families requested for each refinement, before any was added because no valid
  /// mesh started.
  std::vector<Index> RequestedFamilies;
};

/// Labels, mixed nodes and levels. It cannot be copied, because the levels refer to the labels and
/// the narrow void.
struct LabelledGrid
{
  LabelledGrid() = default;
  LabelledGrid(const LabelledGrid&) = delete;
  LabelledGrid& operator=(const LabelledGrid&) = delete;

  LabelArray Labels;
  std::vector<Index> Thin;  ///< cells that got their label as a thin part (ThinParts.h), ascending
  std::vector<Index> Mixed; ///< nodes of the grid with several labels around them
  NarrowVoid Narrow;        ///< void cells that get hexes as a barrier
  LevelHexes Levels;

  BarrierElements Barrier() const { return { !this->Narrow.IsEmpty() }; }
};

} // namespace vfm
