/**
 * ExodusModel: a rank's part of a mesh in the numbering of Exodus, which lists elements block by block, and what it must know of
 * the other parts.
 */
#pragma once

#include "Meshes/ExodusVariables.h"
#include "Summary/MeshSets.h"
#include "Summary/SharedPoints.h"

namespace vfm
{

struct ExodusBlock
{
  int Id; ///< the material's; of the void, material 0, FindVoidId()
  std::string Name;
  std::vector<Index> Elements; ///< of the mesh of this rank, ascending
  Index Total = 0;             ///< elements on all ranks
};

struct ExodusModel
{
  StoredMesh Mesh;                 ///< of this rank; points and elements in the order of their ids
  std::vector<ExodusBlock> Blocks; ///< the same on all ranks, by id
  std::vector<Index> Numbers;      ///< of each element its number in the file, from 1
  MeshSets Sets;                   ///< the same on all ranks, each name once
  std::vector<Index> SideTotals;   ///< sides of each side set on all ranks
  std::vector<Index> NodeTotals;   ///< nodes of each node set on all ranks, shared ones once
  Index TotalNodes = 0, TotalElements = 0;
  SharedPoints Sharing;
  std::vector<ExodusVariable> PointVariables, ElementVariables;
  std::vector<ExodusNumber> GlobalVariables;
  std::size_t LongestName = 0;
  bool HasWideIds = false;     ///< some id is greater than 2^31 - 1
  bool HasLargeArrays = false; ///< some array is larger than the classic file format allows, 4 GiB
};

/// Collective. mesh: of the mesher, or one that was read. Throws InputError on all ranks when it is no such mesh.
ExodusModel MakeExodusModel(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
