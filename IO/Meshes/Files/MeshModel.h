/**
 * MeshModel: what files contain of a mesh: its materials, named sets and cohesive elements.
 */
#pragma once

#include "Report/Sets/MaterialBins.h"
#include "Report/Sets/SplitFaces.h"
#include "Report/UniqueNames.h"

#include <map>

namespace vfm
{

/// The elements of a material, or of one of its bins.
struct MaterialPart
{
  int Material; ///< 0: the meshed void
  int Id;       ///< id of the material, FindVoidId() of the void; or of the bin
  std::string Name;
  std::vector<Index> Elements; ///< elements of this rank, ascending
  std::optional<MaterialBin> Bin = {};
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

/// Returns whether an array has the ids of bins.
bool IsBinArray(const MeshArray& array);

/// Divides materials whose elements are in bins (MaterialBins.h): each bin becomes a part, and so
/// do the elements of the material that are in none.
/// @throws InputError  if ReadBins does, or an element is in a bin that its material does not have;
///   on all ranks
/// @pre Collective
std::vector<MaterialPart> DivideByBins(
  const std::vector<MaterialPart>& parts, const MeshData& mesh, Ranks& ranks);

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
