/**
 * ListInput: prints the contents of an input: times, grid, arrays, and the materials found.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"

#include <iosfwd>

namespace vfm
{

/// Reads one time of the input, by default the first, and prints its contents on rank 0. The text
/// does not depend on the number of ranks.
/// @throws InputError  (UnreadableInput) if the input cannot be read
/// @pre Collective
void ListInput(const Arguments& arguments, Ranks& ranks, std::ostream& to);

} // namespace vfm
