/**
 * BuiltInTest: two boxes of full cells, meshed and checked (SAND report 2010, figure 12).
 */
#pragma once

#include "Arguments.h"

class vtkMultiProcessController;

namespace vfm
{

/// Collective. The grid has 10 x 6 x 6 cells, dealt to the ranks in slabs. Meshes it without refinement and
/// refined (once, or as the arguments ask); prints the tables and PASS or FAIL on rank 0, and writes the last mesh when the arguments name an
/// output. False when a check fails. Throws ProgramError.
bool RunBuiltInTest(const Arguments& arguments, vtkMultiProcessController* controller);

} // namespace vfm
