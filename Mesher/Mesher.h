/**
 * Mesher: makes a mesh of all materials, with state and reports, from blocks of cells. The filters,
 * the Python package, the command-line tool and the C library call it.
 */
#pragma once

#include "Input/LabelNames.h"
#include "Options/MesherOptions.h"
#include "Report/MeshFields.h"
#include "Report/Sets/SplitFaces.h"
#include "State/MeshState.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Names of the arrays that a run reads from the blocks.
struct MesherArrays
{
  std::vector<std::string> Fractions; ///< one array per material; empty: Labels is set
  std::string Labels;                 ///< array of labels; empty: Fractions are set
  LabelNames Names;                   ///< names of labels
  StateChoice State;                  ///< state arrays to transfer to the mesh
  bool AreGuessed = false;            ///< true: the user did not select Fractions or Labels
  bool IsZeroVoid = false;            ///< label 0 is known to be void
};

/// Input of a run.
struct MesherInput
{
  InputLevels Levels;
  MesherArrays Arrays;
  /// true: each rank has one block and meshes its cells; required for input of FindNeighbourLevels,
  /// which knows only the blocks nearby. false: cells may be redistributed over the ranks.
  bool StaysInPlace = false;
  std::function<void(const std::string&)> Warn; ///< called only on rank 0; may be empty
};

/// Result of a run.
struct MesherResult
{
  Mesh TheMesh; ///< elements of this rank, in world coordinates; materials have the ids of the user
  MeshReport Report;
  OutputState State;
  std::vector<CohesiveBlock> Cohesive; ///< cohesive elements of this rank
  /// Field data of the whole mesh: ListSides, ListReport, ListDomain (MeshFields.h), ListBalance.
  FieldArrays Fields;
  /// Table with one row per material: ListMaterials (MeshFields.h), ListBalance (StateBalance.h).
  FieldArrays MaterialFields;
};

/// Makes a mesh from the input.
/// @param input blocks of this rank, with positions in the grid
/// @param options user options; checked first (CheckOptions)
/// @param runtime threads, ranks and progress
/// @return elements of the cells that this rank meshes, their state, and reports equal on all ranks
/// @throws InputError if options or input are not valid; the same message on all ranks
/// @throws Aborted if the user stops a run on a single rank (Runtime::Progress)
/// @pre Collective over runtime.Group(). On several ranks, the caller runs it in a frame
///   (WorkTogether), so that no rank waits for a rank that runs out of memory.
/// @note Bitwise reproducible for any number of ranks and threads, except with TetGen.
MesherResult RunMesher(const MesherInput& input, const MesherOptions& options, Runtime& runtime);

} // namespace vfm
