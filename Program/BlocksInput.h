/**
 * BlocksInput: files of blocks of cells that IO reads: SpyPlot files of CTH, and plotfiles of codes on AMReX.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"
#include "ReaderSteps.h"

namespace vfm
{

/// Collective: reads the arrays that the arguments name, or the volume fractions of a SpyPlot file, or all
/// where these are none or one is missing. Throws InputError (UnreadableInput).
Input ReadBlocks(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
