/**
 * ListInput: what an input holds, for the user: times, grid, cell arrays, and the materials that would be taken.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"

#include <iosfwd>

namespace vfm
{

/// Collective: reads the time that the arguments ask for, else the first, and prints on rank 0. The same on any number of ranks. Throws
/// InputError (UnreadableInput).
void ListInput(const Arguments& arguments, Ranks& ranks, std::ostream& to);

} // namespace vfm
