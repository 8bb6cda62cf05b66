/**
 * MakeMesh: runs the mesher on the input of all ranks.
 */
#pragma once

#include "ChooseArrays.h"
#include "Mesher.h"

namespace vfm
{

/// Collective: this rank's part of the mesh, of the materials of the arguments. Shows the progress on a terminal unless quiet, and
/// warnings, on rank 0. Throws InputError: WrongArguments as KeepMaterials, else RejectedMesh with the mesher's message, or InternalError
/// for lack of memory.
MesherResult MakeMesh(
  const Arguments& arguments, const Input& input, const ChosenArrays& arrays, Ranks& ranks);

} // namespace vfm
