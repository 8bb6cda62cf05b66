/**
 * MeshMaterials: the materials of a mesh on all ranks, their names, and an id for a meshed void.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <map>

namespace vfm
{

/// Returns names by material id, from the fields MaterialNames and MaterialIds; 0 is "Void".
std::map<int, std::string> NamesOfMaterials(const MeshData& mesh);
/// Returns the name of a material; "Material 7" if it has no name.
std::string NameOfMaterial(const std::map<int, std::string>& names, int material);

/// Returns the materials of the elements of all ranks, ascending.
/// @throws InputError if the array MaterialId is missing or a value is negative, on all ranks
/// @pre Collective
std::vector<int> FindMaterials(const MeshData& mesh, Ranks& ranks);

/// Returns an id for the void (material 0) where ids must be positive: one more than the largest id
/// of the elements and of the field MaterialIds.
/// @throws InputError if no integer is left, on all ranks
/// @pre Collective
int FindVoidId(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
