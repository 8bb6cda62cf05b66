/**
 * InputRoute: finds the ranks that exchange contents of blocks, so that each rank gets the cells
 * that it meshes and their ghost cells.
 */
#pragma once

#include "Input/InputLevels.h"

namespace vfm
{

struct InputRoute
{
  std::vector<int> Peers; ///< ranks that send or receive, ascending
  /// Cells that each peer meshes, and ghost cells around them.
  std::vector<IndexBox> Requested;
};

/// Finds the peers of this rank.
/// @param owners cells that each rank meshes, of all ranks or of nearby ranks
InputRoute FindInputRoute(const std::vector<BlockPlace>& owners, const InputBlocks& input,
  int myRank, Index ghostLayers = GhostLayers);

/// Finds the ranks that hold cells which this rank needs, or need cells of its blocks: the cells
/// that a rank meshes, and GhostLayers around them.
/// @param owned cells of level 0 that this rank meshes; cells of several ranks may overlap
/// @param repeats whether the domain repeats along each axis: ghost cells across its sides are
/// then needed too
/// @param[in,out] input its Places are set to the blocks of this rank and those that hold needed
/// cells
/// @return cells of level 0 that each of these ranks and this rank mesh, ordered by rank
/// @pre Collective
std::vector<BlockPlace> FindOwners(
  const IndexBox& owned, const std::array<bool, 3>& repeats, Ranks& ranks, InputLevels& input);

/// Returns the box of a rank, which must be in the list.
const IndexBox& BoxOfRank(const std::vector<BlockPlace>& owners, int rank);

} // namespace vfm
