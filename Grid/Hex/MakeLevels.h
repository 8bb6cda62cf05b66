/**
 * MakeLevels: the levels of a grid, refined until a valid mesh starts everywhere.
 */
#pragma once

#include "Base/Options.h"
#include "Hex/LabelledGrid.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Where interfaces cross levels: leaves are refined until a valid mesh starts everywhere. Collective. Throws InputError as MakeLevels does.
void LabelLeaves(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, const Partition& partition, Runtime& runtime, MeshReport& report,
  LabelledGrid& result);

/// Makes the levels that a plan asks for; adds to it what has to be refined so that a valid mesh starts. interfaces: as in RefinedGrid. hexes: as in
/// CoarseHexes. levels: as they are made so far. Collective. Throws InputError as RefinedGrid and CoarseHexes do.
void MakeLevels(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& interfaces, const CoarseHexes::Options& hexes, LevelPlan& plan,
  Runtime& runtime, MeshReport& report, LevelHexes& levels);

/// Adds families to a plan because no valid mesh starts there; whether any rank had some. Collective.
bool AddFamilies(const std::vector<std::vector<Index>>& families, LevelPlan& plan, Ranks& ranks);

} // namespace vfm
