/**
 * LevelFields: the fractions of the grid that is meshed, from the blocks of all levels of the input.
 *
 * First from fine to coarse: a cell that finer blocks cover has the mean of its eight halves. Then from coarse to fine:
 * halves of cells that no finer block covers are made by RefineCells. So every material keeps the volume that the finest data
 * have of it, to rounding, on every level. Each rank averages its own cells, and gets its ghost cells from their owners: the same on any number of ranks.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/RefineCells.h"
#include "Input/InputFields.h"
#include "Input/InputLevels.h"
#include "Labels/RefinementCriteria.h"
#include "Levels/InputRequests.h"
#include "Levels/LevelSetup.h"

namespace vfm
{

struct LevelFields
{
  CartesianGrid Base; ///< of level LevelSetup::Base
  CartesianGrid
    Grid; ///< of LevelSetup::Finest or, where that is coarser, of the finest level of the input
  InputField Field; ///< of Grid
  /// Of each refinement between Base and Grid the families (OctreeKeys::FamilyKey) of this rank's cells that finer blocks
  /// cover, ascending; empty lists unless the mesh takes the input's levels.
  std::vector<std::vector<Index>> Families;
  CellDivision Division; ///< of the cells of Base, into those that it now has
};

/// Collective: the cells of level 0 that each rank meshes, by rank (MakePartition): whole cells of the base.
std::vector<BlockPlace> DistributeCells(
  const InputLevels& input, const LevelCells& cells, const LevelSetup& setup, Ranks& ranks);

/// Collective. owners: the cells of level 0 that the ranks mesh, of all ranks or those near. Throws InputError, on all ranks
/// alike, on values that are no fractions, and as CheckCover does.
LevelFields MakeLevelFields(const InputLevels& input, const LevelCells& cells,
  const LevelSetup& setup, ChildRule rule, const std::vector<BlockPlace>& owners, Runtime& runtime);

/// Collective: cuts the cells of Base, and those of Grid alike, until none has an aspect ratio above a number (DivideLongCells):
/// levels keep their ratios, families their places. 0: none is cut; else at least SmallestAspectRatio. Throws InputError, on all ranks
/// alike, where there would be too many cells.
void DivideFields(LevelFields& fields, double maximumAspectRatio, ChildRule rule, Runtime& runtime);

/// Adds the families between Base and Grid that cells of the input want, and those of so many layers around; returns, in cells of Grid, what
/// they want beyond it. wishes: of the cells that this rank meshes; setup: of those levels.
std::vector<ChosenBox> TakeRequests(
  const InputRequests& requests, const LevelSetup& setup, int layers, LevelFields& fields);

/// Collective: how many levels finer than Grid the criteria want; adds the families that they want to refine, and those of so many
/// layers of cells around (FindRequestedFamilies).
int FindFinerLevels(LevelFields& fields, const RefinementCriteria& criteria, double isoValue,
  int layers, Runtime& runtime);

/// Collective: halves all cells of Grid so many times.
void RefineFields(LevelFields& fields, int steps, ChildRule rule, Runtime& runtime);

} // namespace vfm
