/**
 * InputAssociation: whether the arrays that are meshed belong to the cells of the input, or to its points, which then are the
 * centres of cells.
 *
 * All arrays that are chosen have one association, for it decides what the grid is. Those that hold the materials tell: the
 * cells' if all blocks have all of them there, else the points'.
 */
#pragma once

#include "Base/Ranks.h"
#include "ChosenArray.h"

#include <vector>

namespace vfm
{

struct InputPart;

/// Collective: vtkDataObject::CELL or POINT. materials: the arrays that hold them, state: others that are to be read. Throws InputError,
/// on all ranks alike, when some belong to cells and others to points. An array that is missing is no error here: cells are meant then.
int FindAssociation(const std::vector<InputPart>& parts, const std::vector<ChosenArray>& materials,
  const std::vector<ChosenArray>& others, Ranks& ranks);

} // namespace vfm
