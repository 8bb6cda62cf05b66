/**
 * InputRequests: finds the cells of the input that an array or boxes select for refinement, and
 * sends them from the ranks that read them to the ranks that mesh them.
 *
 * Only the finest blocks count; coarser blocks below finer ones are ignored. Blanked cells are not
 * selected. A box selects the cells that it overlaps by more than 1e-3 of their width along every
 * axis. A cell gets the maximum number of halvings of the array and all boxes.
 */
#pragma once

#include "Input/InputLevels.h"
#include "Labels/RefinementCriteria.h"
#include "Options/MesherOptions.h"

#include <string>
#include <vector>

namespace vfm
{

/// Requests for halvings of cells.
struct InputRequests
{
  /// Rows of selected cells of each level, among the cells that this rank reads or meshes.
  std::vector<std::vector<ChosenBox>> Levels;
  Index Cells = 0;     ///< number of selected cells on all ranks
  int Finest = 0;      ///< finest requested level on all ranks; 0 without cells
  std::string Warning; ///< empty, or the boxes that select no cell
};

/// Finds the requests of the cells that this rank reads.
/// @param options RefinementArray, of any numeric type and one component, in all blocks, and
/// RefinementBoxes; they count if Refinement is Automatic
/// @throws InputError if the array is missing, if numbers of halvings are not integers from 0 to
/// MaximumHalvings, or if a box ends before it begins; on all ranks
/// @pre Collective
InputRequests FindInputRequests(
  const InputLevels& input, const MesherOptions& options, Ranks& ranks);

/// Returns the requests of the cells that this rank meshes.
/// @param owners cells of level 0 that each rank meshes, of all ranks or of nearby ranks
/// @pre Collective
InputRequests DistributeRequests(const InputRequests& requests, const InputLevels& input,
  const std::vector<BlockPlace>& owners, Ranks& ranks);

} // namespace vfm
