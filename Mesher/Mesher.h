/**
 * Mesher: makes a mesh of all materials, with state and reports, from blocks of cells. The filters,
 * the Python package, the command-line tool and the C library call it.
 */
#pragma once

#include "Input/LabelNames.h"
#include "Options/MesherOptions.h"
#include "State/MeshState.h"
#include "Summary/MeshFields.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Arrays of the blocks that are read.
struct MesherArrays
{
  std::vector<std::string> Fractions; ///< one array per material; empty: Labels is used
  std::string Labels;                 ///< array of labels; empty: Fractions are used
  LabelNames Names;                   ///< names of labels
  StateChoice State;
};

/// Input of a run.
struct MesherInput
{
  InputLevels Levels;
  MesherArrays Arrays;
  bool StaysInPlace = false; ///< each rank meshes its own block (FindNeighbourLevels)
  std::function<void(const std::string&)> Warn; ///< called only on rank 0; may be empty
};

/// Result of a run.
struct MesherResult
{
  Mesh TheMesh; ///< elements of this rank, in world coordinates; materials have the ids of the user
  MeshReport Report;
  OutputState State;
  FieldArrays Fields;         ///< ListSides, ListReport, ListDomain, ListBalance
  FieldArrays MaterialFields; ///< ListMaterials, ListBalance; one row per material
};

/// Makes a mesh from the input.
/// @param input blocks of this rank, with positions in the grid
/// @param options user options; checked first (CheckOptions)
/// @param runtime threads, ranks and progress
/// @return elements of the cells that this rank meshes, their state, and reports equal on all ranks
/// @throws InputError if options or input are not valid; the same message on all ranks
/// @throws Aborted if progress reporting requests it
/// @pre Collective over runtime.Group()
/// @note Bitwise reproducible for any number of ranks and threads, except with TetGen.
MesherResult RunMesher(const MesherInput& input, const MesherOptions& options, Runtime& runtime);

} // namespace vfm
