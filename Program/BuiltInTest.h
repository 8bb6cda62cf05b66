/**
 * BuiltInTest: two boxes of full cells, meshed and checked (SAND report 2010, figures 12 and 13).
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Collective. The grid has 10 x 6 x 6 cells, twice as many along each axis for chosen cells, dealt to the ranks in slabs; the boxes
/// are two fragments of one material. Meshes it as the arguments ask without refinement, and refined: chosen cells, or all as
/// often as the arguments ask, else once. Prints the tables, what is checked, and PASS or FAIL on rank 0, and writes the last
/// mesh when the arguments name an output. False when a check fails. Throws InputError.
bool RunBuiltInTest(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
