/**
 * WideCells: the cells that replace those of the input (option CellWidth), and what each material
 * keeps in them.
 */
#pragma once

#include "Base/Runtime.h"
#include "Input/InputLevels.h"
#include "Levels/CellSizes.h"
#include "Levels/InputRequests.h"
#include "Levels/LevelFields.h"

namespace vfm
{

/// What materials keep in other cells, over all ranks.
struct WideReport
{
  /// Of the new cells, the finest of several levels; zeros: the cells are those of the input.
  Vector3 Widths{ { 0.0, 0.0, 0.0 } };
  int Halvings = 0; ///< of the coarsest new cells until they are the finest (MaterialWidths)
  std::vector<Index> InputCells,
    Cells; ///< cells of the input, and new (finest) cells, of materials 0, 1, ..
  std::vector<double> MaterialWidths; ///< of cells of materials 0, 1, ..; empty: Widths
  /// Largest width that keeps each of the materials 0, 1, .. in 99 % of its volume, among those
  /// tried, which are below Widths; 0: only the cells of the input do. Empty with MaterialWidths.
  std::vector<double> Keeping;

  bool IsUsed() const { return this->Widths != Vector3{}; }
};

/// The new cells, and where the cells of the input are needed for them.
struct WidePlan
{
  GridNodes Nodes; ///< of the new cells
  int Coarser;     ///< number of times that the new cells will be joined in pairs
  IndexBox Needed; ///< cells of the input, of its finest level, that this rank needs
  /// Cells of level 0 of the input that this rank needs: those that it meshed, and those that its
  /// new cells, with their ghost cells, overlap. The boxes of ranks overlap.
  IndexBox Place;
};

/// Returns the nodes of the cells that replace others.
/// @param nodes nodes of the finest level of the input
/// @param widths of the new cells; 0: the cells of the input along this axis
/// @throws InputError if there would be more cells than in the input along an axis
GridNodes ReplaceNodes(const GridNodes& nodes, const Vector3& widths);

/// Plans the cells of this rank (CellsOfOwner).
/// @param read grid of the finest level of the input, without copies of cells
WidePlan PlanCells(
  const InputLevels& input, const CartesianGrid& read, GridNodes nodes, int coarser);

/// Returns the fields with so many ghost layers that all ranks hold the cells that they need.
/// @pre Collective
LevelFields HoldNeeded(const WidePlan& plan, const LevelFields& fields, Ranks& ranks);

/// Returns the numbers of cells of materials 0, 1, .. on all ranks.
/// @pre Collective
std::vector<Index> CountCells(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue, Ranks& ranks);

/// Replaces the cells of fields of one level.
/// @param sizes of the new cells, for WideReport
/// @param[in,out] fields made for LevelSetup::IsUniform, without copies of cells
/// @pre Collective
WideReport WidenFields(const WidePlan& plan, const CellSizes& sizes, double isoValue,
  Runtime& runtime, LevelFields& fields);

/// Returns the requests for the new cells of this rank: a new cell gets the most halvings of the
/// cells of the input that it overlaps.
/// @param requests of the cells that this rank reads
/// @param owners cells of level 0 that each rank needs (WidePlan::Place)
/// @param grid grid of the new cells
/// @pre Collective
InputRequests WidenRequests(const InputRequests& requests, const InputLevels& input,
  const std::vector<BlockPlace>& owners, const CartesianGrid& grid, Ranks& ranks);

} // namespace vfm
