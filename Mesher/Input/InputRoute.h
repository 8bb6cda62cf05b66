/**
 * InputRoute: which ranks send each other what their blocks hold, so that each has the cells that it meshes and their
 * ghost cells.
 */
#pragma once

#include "Input/InputBlocks.h"

namespace vfm
{

struct InputRoute
{
  std::vector<int> Peers; ///< ascending
  std::vector<IndexBox>
    Requested; ///< by each peer: the cells that it meshes and ghost cells around them
};

/// owners: the cells that the ranks mesh, of all ranks or those near.
InputRoute FindInputRoute(const std::vector<BlockPlace>& owners, const InputBlocks& input,
  int myRank, Index ghostLayers = GhostLayers);

/// The box of a rank in such a list; it must be there.
const IndexBox& BoxOfRank(const std::vector<BlockPlace>& owners, int rank);

} // namespace vfm
