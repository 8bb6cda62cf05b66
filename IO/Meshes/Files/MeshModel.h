/**
 * MeshModel: what files contain of a mesh: its materials, named sets and cohesive elements.
 */
#pragma once

#include "Report/Sets/SplitFaces.h"
#include "Report/UniqueNames.h"

#include <map>

namespace vfm
{

/// The elements of a material.
struct MaterialPart
{
  int Material; ///< 0: the meshed void
  int Id;       ///< id of the material; FindVoidId() of the void
  std::string Name;
  std::vector<Index> Elements; ///< elements of this rank, ascending
};

/// Lists have the same items on all ranks, with the elements, faces and points of this rank.
struct MeshModel
{
  MeshSets Sets;
  std::vector<CohesiveBlock> Cohesive; ///< empty if the mesh has no cohesive elements
  std::vector<MaterialPart> Materials; ///< ascending by material
};

/// Returns whether the name of an array contains a word of small letters, in any case.
bool HasWord(const MeshArray& array, const char* word);
/// Returns whether an array has the velocity of nodes: three components, and "velocity" in its
/// name, in any case.
bool IsVelocity(const MeshArray& array);

/// Returns the number of cohesive elements on this rank.
Index CountElements(const std::vector<CohesiveBlock>& blocks);

/// @pre Collective
std::vector<MaterialPart> FindMaterialParts(const MeshData& mesh, Ranks& ranks);

/// @throws InputError  if FindMaterials, FindMeshSets or FindCohesiveBlocks does; on all ranks
/// @pre Collective
MeshModel MakeMeshModel(const MeshData& mesh, Ranks& ranks);

/// Returns a name of each material that no other has.
/// @param materials  ascending
/// @param form  converts a name to the form of a format
/// @param[in,out] used  names that others have
std::map<int, std::string> NameMaterials(const MeshData& mesh, const std::vector<int>& materials,
  std::string (*form)(const std::string&), UniqueNames& used);

} // namespace vfm
