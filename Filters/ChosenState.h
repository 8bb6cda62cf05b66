/**
 * ChosenState: what is chosen to be carried, completed by what a data object of VTK has.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "State/StateChoice.h"

class vtkDataObject;

namespace vfm
{

/// Collective: CompleteChoice, by the arrays of cells and points of all ranks. Throws InputError, on all ranks alike, on input of a kind
/// that cannot be meshed.
StateChoice FindChosenState(vtkDataObject* input, StateChoice choice, Ranks& ranks);

} // namespace vfm
