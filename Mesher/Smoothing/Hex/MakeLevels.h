/**
 * MakeLevels: makes the labels and levels of a grid, and refines until a valid mesh starts
 * everywhere.
 */
#pragma once

#include "Elements/Hex/LabelledGrid.h"
#include "Elements/MeshRun.h"

namespace vfm
{

/// Makes and smooths the transitions of a refined grid, and its coarse hexes; without refinements
/// there are none.
/// @throws InputError  see SmoothTransitions
/// @pre Collective.
std::unique_ptr<CoarseHexes> MakeCoarseHexes(const RefinedGrid& grid, const LabelArray& labels,
  const CoarseHexes::Options& options, Runtime& runtime);

/// Makes the labels of cells, or of leaves where interfaces may cross levels, and the levels.
/// Refines until a valid mesh starts everywhere.
/// @throws InputError  see RefinedGrid and MakeCoarseHexes
/// @pre Collective.
void LabelCells(const MeshCells& cells, MeshRun& run, LabelledGrid& result);

/// Makes the levels that a plan requests. Adds families to the plan until a valid mesh starts.
/// @param interfaces  mixed nodes, as in RefinedGrid
/// @param[in,out] levels  is replaced; counts in RequestedFamilies are kept
/// @throws InputError  see RefinedGrid and MakeCoarseHexes
/// @pre Collective.
void MakeLevels(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& interfaces, const CoarseHexes::Options& hexes, LevelPlan& plan,
  Runtime& runtime, MeshReport& report, LevelHexes& levels);

} // namespace vfm
