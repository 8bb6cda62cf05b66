/**
 * BuiltInTest: meshes and checks two boxes of full cells (SAND report 2010, figures 12 and 13).
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Runs `sculptor test`. The grid has 10 x 6 x 6 cells, or twice as many along each axis if chosen
/// cells are refined; each rank has a slab. The boxes are two fragments of one material.
///
/// Two meshes are made: without refinement, and refined. Refined are chosen cells, or all cells as
/// often as the arguments request, by default once. Rank 0 prints the tables, all checks, and PASS
/// or FAIL. The last mesh is written if the arguments name an output.
/// @return false if a check fails
/// @throws InputError  if the mesher fails or the output cannot be written
/// @pre Collective
bool RunBuiltInTest(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
