/**
 * Mesher: makes a mesh of all materials, with state and reports, from blocks of cells. The filters,
 * the Python package, the command-line tool and the C library call it.
 */
#pragma once

#include "Phases/MesherInput.h"
#include "Phases/MesherResult.h"

namespace vfm
{

struct CellRuns;

/// Makes a mesh from the input.
/// @param input blocks of this rank, with positions in the grid
/// @param options user options; checked first (CheckOptions)
/// @param runtime threads, ranks and progress
/// @param leftOut  receives hexes of unchanged cells that the mesh leaves out, if options and input
///   allow that; null: the mesh has all hexes. It saves most memory of large bodies; MeshWithRuns
///   and the writers that take runs put both together.
/// @return elements of the cells that this rank meshes, their state, and reports equal on all ranks
/// @throws InputError if options or input are not valid; the same message on all ranks
/// @throws Aborted if the user stops a run on a single rank (Runtime::Progress)
/// @pre Collective over runtime.Group(). On several ranks, the caller runs it in a frame
///   (WorkTogether), so that no rank waits for a rank that runs out of memory.
/// @note Bitwise reproducible for any number of ranks and threads, except with TetGen.
MesherResult RunMesher(const MesherInput& input, const MesherOptions& options, Runtime& runtime,
  CellRuns* leftOut = nullptr);

} // namespace vfm
