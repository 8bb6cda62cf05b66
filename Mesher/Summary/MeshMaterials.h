/**
 * MeshMaterials: the materials that a mesh has on all ranks together, their names, and the number of a meshed void.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

#include <map>

namespace vfm
{

/// The names by material id: the fields MaterialNames and MaterialIds; "Void" of 0.
std::map<int, std::string> NamesOfMaterials(const MeshData& mesh);
/// "Material 7" where there is no name.
std::string NameOfMaterial(const std::map<int, std::string>& names, int material);

/// Collective: the materials that elements have on any rank, ascending. Throws InputError, on all ranks alike, when the
/// array MaterialId is missing or a value is negative.
std::vector<int> FindMaterials(const MeshData& mesh, Ranks& ranks);

/// Collective: what stands for material 0, the void, where numbers must be positive: the number after the greatest one of the
/// elements and of the field MaterialIds. Throws InputError, on all ranks alike, when there is none.
int FindVoidId(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
