/**
 * BlocksInput: reads SpyPlot files of CTH and plotfiles of AMReX.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"
#include "ReaderSteps.h"

namespace vfm
{

/// Reads the arrays that the arguments name, and without such names the volume fractions of a
/// SpyPlot file. Reads all arrays if there are no such fractions or if a named array is missing.
/// @throws InputError  (UnreadableInput) if the input cannot be read
/// @pre Collective
Input ReadBlocks(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
