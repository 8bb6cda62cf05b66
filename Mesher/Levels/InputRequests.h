/**
 * InputRequests: the cells of the input that are chosen to be halved, by an array or by boxes in space, from the ranks that
 * read them to those that mesh them.
 *
 * A cell is that of the finest block there: what coarser blocks hold below finer ones is ignored. Blanked cells are not chosen. A box
 * chooses the cells that it reaches into by more than a thousandth of their width along every axis; of array and boxes the most halvings count.
 */
#pragma once

#include "Input/InputLevels.h"
#include "Labels/RefinementCriteria.h"
#include "Options/MesherOptions.h"

#include <string>
#include <vector>

namespace vfm
{

struct InputRequests
{
  std::vector<std::vector<ChosenBox>>
    Levels;        ///< rows of cells of each level, that this rank reads or meshes
  Index Cells = 0; ///< that are chosen, over all ranks
  int Finest = 0;  ///< the finest level that they want to be of, over all ranks; 0 without cells
  std::string Warning; ///< empty, or which boxes choose no cell
};

/// Collective: what the cells want that this rank reads. array: its name, of any type and one component, in all blocks; empty: none.
/// Throws InputError, on all ranks alike, on a missing array, values that are no whole numbers from 0 to MaximumHalvings, and boxes that
/// ask for others or end before they begin.
InputRequests FindInputRequests(const InputLevels& input, const std::string& array,
  const std::vector<RefinementBox>& boxes, Ranks& ranks);

/// Collective: what the cells want that this rank meshes. owners: of the cells of level 0, of all ranks or those near.
InputRequests DistributeRequests(const InputRequests& requests, const InputLevels& input,
  const std::vector<BlockPlace>& owners, Ranks& ranks);

} // namespace vfm
