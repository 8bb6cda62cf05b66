/**
 * GlobalOrder: positions of points and cells in the whole mesh, and numbers of its faces.
 *
 * Each number or cell determines the rank that orders it, so no rank needs memory for the whole
 * mesh.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Ranks.h"

#include <vector>

namespace vfm
{

/// Positions of items of this rank among the items of all ranks.
struct GlobalOrder
{
  std::vector<Index> Positions; ///< from 0
  Index Total = 0;              ///< number of different ids on all ranks
};

/// Orders the items of all ranks by id; equal ids on several ranks are one item.
/// @param ids  ids of this rank, from 1, each once
/// @pre Collective
GlobalOrder OrderIds(const Index* ids, Index count, Ranks& ranks);

/// Number of faces of a cell in a group: inner faces that it owns, or faces in a patch.
struct FaceCount
{
  Index Cell; ///< position of the cell in the whole mesh
  int Group;
  int Count;
};

/// Returns the number of the first face of each entry, if faces are ordered by group, then cell.
/// @param counts  of this rank; each cell and group on one rank and once
/// @param groups,cells  number of groups and of all cells, equal on all ranks
/// @pre Collective
std::vector<Index> NumberFaces(
  const std::vector<FaceCount>& counts, int groups, Index cells, Ranks& ranks);

} // namespace vfm
