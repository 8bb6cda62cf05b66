/**
 * InputAssociation: whether the arrays that are meshed belong to the cells of the input, or to its points, which then are the
 * centres of cells.
 *
 * All arrays that are chosen have one association, for it decides what the grid is. Those that hold the materials tell: the
 * cells' if all blocks have all of them there, else the points'.
 */
#pragma once

#include "ChosenArray.h"
#include "Ranks/Ranks.h"

#include <vector>

namespace vfm
{

struct InputPart;

/// Collective: vtkDataObject::CELL or POINT. Throws InputError, on all ranks alike, when some of the arrays belong to cells and others to
/// points, or one is none that can be read. An array that is missing is no error here: what the others belong to is meant then, or cells.
int FindAssociation(const std::vector<InputPart>& parts, const ArraysToRead& toRead, Ranks& ranks);

} // namespace vfm
