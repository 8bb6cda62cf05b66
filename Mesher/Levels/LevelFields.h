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
#include "GivenSurfaces/BodySurfaces.h"
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
/// @return cells of level 0 that this rank meshes
/// @pre Collective
IndexBox DistributeCells(
  const InputLevels& input, const LevelCells& cells, const LevelSetup& setup, Ranks& ranks);

/// Makes the grids and fractions of this rank, without copies of cells.
/// @param repeats whether the domain repeats along each axis: cells at sides are then halved with
/// their neighbours across
/// @param owners cells of level 0 that each rank meshes, of all ranks or of nearby ranks
/// (FindOwners)
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

/// Refines the grid to the finest cells of the mesh, where the options, requests and criteria say,
/// and adds the ghost layers that meshing needs.
/// @param requests requests of the cells that this rank meshes
/// @param inputFinest finest level of the input
/// @param bodies surfaces in coordinates of Grid, or null; not if the domain repeats. Thin places
/// of these are refined too (ThinPlaces.h), and their children get exact fractions
/// (ExactChildren.h).
/// @return plan of the levels of the mesh
/// @pre Collective
LevelPlan RefineFields(const MesherOptions& options, const LevelSetup& setup,
  const InputRequests& requests, int inputFinest, const BodySurfaces* bodies, Runtime& runtime,
  LevelFields& fields);

/// Returns a sentence if the widths of cells differ so much that close bodies may overlap, or "".
std::string DescribeWidths(const CartesianGrid& grid);

} // namespace vfm
