/**
 * InputAssociation: decides whether cell arrays or point arrays are meshed; points are then used as
 * centres of cells.
 *
 * All selected arrays must have one association, because it determines the grid. The arrays of the
 * materials decide: cells, if all blocks have all these arrays as cell data; else points.
 */
#pragma once

#include "ChosenArray.h"
#include "Ranks/Ranks.h"

#include <vector>

namespace vfm
{

struct InputPart;

/// Returns vtkDataObject::CELL or POINT. Missing arrays are not an error here; the other arrays
/// decide, or CELL is returned.
/// @throws InputError if cell and point arrays are mixed, or if an array cannot be read
/// (vtkGhostType); on all ranks
/// @pre Collective
int FindAssociation(const std::vector<InputPart>& parts, const ArraysToRead& toRead, Ranks& ranks);

} // namespace vfm
