/**
 * MakeLevels: makes the levels of a grid and refines them until a valid mesh starts everywhere.
 */
#pragma once

#include "Base/Options.h"
#include "Elements/Hex/LabelledGrid.h"
#include "Elements/MeshReport.h"
#include "Labels/ResolveLabels.h"
#include "Labels/ThinParts.h"

namespace vfm
{

/// Copies the counts of flipped cells into the report of a mesh.
void ReportFlips(const ResolveReport& resolved, MeshReport& report);

/// Counts the owned cells of thin parts of all ranks.
/// @pre Collective.
void ReportThinCells(
  const CartesianGrid& grid, const std::vector<ThinCell>& thin, Ranks& ranks, MeshReport& report);

/// Makes and smooths the transitions of a refined grid, and its coarse hexes; without refinements
/// there are none.
/// @throws InputError  see SmoothTransitions
/// @pre Collective.
std::unique_ptr<CoarseHexes> MakeCoarseHexes(const RefinedGrid& grid, const LabelArray& labels,
  const CoarseHexes::Options& options, Runtime& runtime);

/// Makes levels and labels of leaves where interfaces may cross levels. Refines leaves until a
/// valid mesh starts everywhere.
/// @throws InputError  see RefinedGrid and MakeCoarseHexes
/// @pre Collective.
void LabelLeaves(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, const Partition& partition, Runtime& runtime, MeshReport& report,
  LabelledGrid& result);

/// Makes the levels that a plan requests. Adds families to the plan until a valid mesh starts.
/// @param interfaces  mixed nodes, as in RefinedGrid
/// @param[in,out] levels  is replaced; counts in RequestedFamilies are kept
/// @throws InputError  see RefinedGrid and MakeCoarseHexes
/// @pre Collective.
void MakeLevels(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& interfaces, const CoarseHexes::Options& hexes, LevelPlan& plan,
  Runtime& runtime, MeshReport& report, LevelHexes& levels);

/// Adds families to a plan because no valid mesh starts there.
/// @return whether any rank added families
/// @pre Collective.
bool AddFamilies(const std::vector<std::vector<Index>>& families, LevelPlan& plan, Ranks& ranks);

} // namespace vfm
