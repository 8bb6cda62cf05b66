/**
 * NewCells: plans the cells that replace those of the input, by the options CellWidth,
 * MaterialWidths and Refinement.
 */
#pragma once

#include "Levels/CellSizes.h"
#include "Levels/InputRequests.h"
#include "Levels/LevelFields.h"

namespace vfm
{

/// Returns whether other cells replace those of the input.
bool ReplacesCells(const MesherOptions& options);

/// Checks whether MaterialWidths, which determines the levels of the mesh, is combined with another
/// option that does.
/// @throws InputError if it is
void CheckMaterialWidths(const MesherOptions& options);

/// Plans the new cells. Without widths of materials, the halvings are as often as Refinement joins
/// cells, and OfMaterial stays empty.
/// @param fields materials in the cells of the input, without copies of cells
/// @param cells numbers of these cells of materials 0, 1, .. on all ranks
/// @throws InputError if cells would be narrower than those of the input, or if MaterialWidths has
/// an unknown name
/// @pre Collective.
CellSizes PlanNewCells(const MesherOptions& options, const LevelFields& fields,
  const std::vector<Index>& cells, Runtime& runtime);

/// Sets up the levels of new cells, and the families that are halved for widths of materials.
/// @param sizes PlanNewCells
/// @param[in,out] fields materials in the finest new cells
LevelSetup SetUpNewLevels(const MesherOptions& options, const CellSizes& sizes,
  const InputRequests& requests, LevelFields& fields);

} // namespace vfm
