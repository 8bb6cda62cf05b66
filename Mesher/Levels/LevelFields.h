/**
 * LevelFields: the fractions of the grid that is meshed, from the blocks of all levels of
 * the input.
 *
 * First, from fine to coarse, a cell below finer blocks gets the mean of its eight children. Then,
 * from coarse to fine, RefineCells makes the children of cells without finer blocks. The volume of
 * each material on every level therefore equals that of the finest data, up to rounding. Each rank
 * averages its own cells and receives its ghost cells from their owners, so the result does not
 * depend on the number of ranks.
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

/// The grid that is meshed, its fractions, and the families of cells that are refined.
struct LevelFields
{
  CartesianGrid Base; ///< grid of level LevelSetup::Base
  /// Grid of LevelSetup::Finest, or of the finest level of the input if that is coarser.
  CartesianGrid Grid;
  InputField Field; ///< materials in Grid
  /// For each refinement between Base and Grid, the families (OctreeKeys::FamilyKey) of this rank's
  /// cells that finer blocks cover, ascending; empty lists unless the mesh uses the input levels.
  std::vector<std::vector<Index>> Families;
  CellDivision Division; ///< division of the original cells of Base into its present cells
};

/// Distributes the cells over the ranks (MakePartition), in whole cells of the base.
/// @return cells of level 0 that each rank meshes, ordered by rank
/// @pre Collective
std::vector<BlockPlace> DistributeCells(
  const InputLevels& input, const LevelCells& cells, const LevelSetup& setup, Ranks& ranks);

/// Makes the grids and fractions of this rank, without copies of cells.
/// @param repeats whether the domain repeats along each axis: cells at sides are then halved with
/// their neighbours across
/// @param owners cells of level 0 that each rank meshes, of all ranks or of nearby ranks
/// @throws InputError if values are not fractions, or if CheckCover does; on all ranks
/// @pre Collective
LevelFields MakeLevelFields(const InputLevels& input, const LevelCells& cells,
  const LevelSetup& setup, ChildRule rule, const std::array<bool, 3>& repeats,
  const std::vector<BlockPlace>& owners, Runtime& runtime);

/// Divides the cells of Base and Grid until no aspect ratio exceeds a maximum (DivideLongCells).
/// Ratios between levels and the places of families do not change.
/// @param maximumAspectRatio at least SmallestAspectRatio
/// @throws InputError if there would be too many cells, on all ranks
/// @pre Collective
void DivideFields(LevelFields& fields, double maximumAspectRatio, ChildRule rule, Runtime& runtime);

/// Adds the families between Base and Grid that user-selected cells request.
/// @param requests requests of the cells that this rank meshes
/// @param layers number of layers around selected cells whose families are added too
/// @return requests for halvings beyond Grid, in cells of Grid
std::vector<ChosenBox> TakeRequests(
  const InputRequests& requests, const LevelSetup& setup, int layers, LevelFields& fields);

/// Finds how many levels finer than Grid the criteria request, and adds the requested families.
/// @param layers number of layers of cells around (FindRequestedFamilies)
/// @return number of levels
/// @pre Collective
int FindFinerLevels(LevelFields& fields, const RefinementCriteria& criteria, double isoValue,
  int layers, Runtime& runtime);

/// Halves all cells of Grid; steps: number of times.
/// @pre Collective
void RefineFields(LevelFields& fields, int steps, ChildRule rule, Runtime& runtime);

} // namespace vfm
