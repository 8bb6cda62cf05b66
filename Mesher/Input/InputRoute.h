/**
 * InputRoute: finds the ranks that exchange contents of blocks, so that each rank gets the cells
 * that it meshes and their ghost cells.
 */
#pragma once

#include "Input/InputBlocks.h"

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

/// Returns the box of a rank, which must be in the list.
const IndexBox& BoxOfRank(const std::vector<BlockPlace>& owners, int rank);

} // namespace vfm
