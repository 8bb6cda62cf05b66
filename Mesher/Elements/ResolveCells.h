/**
 * ResolveCells: the label of each cell, such that a valid mesh can start.
 */
#pragma once

#include "Elements/MeshRun.h"
#include "Labels/ResolveLabels.h"
#include "Labels/ThinParts.h"

namespace vfm
{

/// Copies the counts of flipped cells into the report of a mesh.
void ReportFlips(const ResolveReport& resolved, MeshReport& report);

/// Gives cells to thin parts if the options request it (ThinParts.h).
/// @param[in,out] labels  AssignMaterials
/// @return LabelThinParts
/// @pre Collective.
std::vector<ThinCell> LabelThinCells(const MeshCells& cells, MeshRun& run, LabelArray& labels);

/// Counts the owned cells of thin parts of all ranks.
/// @pre Collective.
void ReportThinCells(const MeshCells& cells, const std::vector<ThinCell>& thin, MeshRun& run);

/// Labels, and the cells that got theirs as a thin part.
struct ResolvedCells
{
  LabelArray Labels;
  std::vector<Index> Thin; ///< ascending
};

/// Assigns labels to cells and changes them until a valid mesh can be made from them
/// (ResolveLabels.h).
/// @param keepsSeam  ResolveLabels
/// @pre Collective.
ResolvedCells ResolveCells(const MeshCells& cells, bool keepsSeam, MeshRun& run);

/// Labels of cells, from which those of leaves follow.
struct CellLabels
{
  LabelArray Labels;          ///< AssignMaterials
  LabelArray ThinLabels;      ///< with the labels of thin parts; empty if these get no cells
  std::vector<ThinCell> Thin; ///< LabelThinParts
};

/// @pre Collective.
CellLabels LabelCellsOfLeaves(const MeshCells& cells, MeshRun& run);

/// Labels of leaves (LeafLabels.h).
struct ResolvedLeaves : ResolvedCells
{
  std::vector<Index3> CostlyFlips; ///< ResolveReport
};

/// Assigns labels to leaves and changes them until a valid mesh can be made from them. Only leaves
/// of the finest level get the labels of thin parts.
/// @param keepsSeam  ResolveLabels
/// @pre Collective.
ResolvedLeaves ResolveLeaves(const MeshCells& cells, const RefinedGrid& levels,
  const CellLabels& ofCells, bool keepsSeam, MeshRun& run);

} // namespace vfm
