/**
 * MakeMesh: runs the mesher on the input of all ranks.
 */
#pragma once

#include "ChooseArrays.h"
#include "Mesher.h"

namespace vfm
{

/// Meshes the materials of the arguments. Rank 0 prints warnings and, on a terminal, the progress
/// unless the arguments are quiet.
/// @param warnings  receives the printed warnings on rank 0; may be null
/// @param leftOut  as RunMesher
/// @return part of this rank of the mesh
/// @throws InputError  WrongArguments as KeepMaterials, RejectedMesh with the message of the
///   mesher, or InternalError if there is not enough memory
/// @pre Collective
MesherResult MakeMesh(const Arguments& arguments, const Input& input, const ChosenArrays& arrays,
  Ranks& ranks, std::vector<std::string>* warnings = nullptr, CellRuns* leftOut = nullptr);

} // namespace vfm
