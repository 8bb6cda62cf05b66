/**
 * OutputState: the state arrays of a mesh, with the balance of their contents.
 */
#pragma once

#include "State/StateBalance.h"
#include "State/TransferredArray.h"

#include <optional>
#include <vector>

namespace vfm
{

/// State of a mesh.
struct OutputState
{
  std::vector<TransferredArray> Arrays;          ///< element arrays, in the order of the choice
  std::optional<TransferredArray> NodalVelocity; ///< point array
  bool IsConserved = false;                      ///< true if any array is conserved; sets Balance
  StateBalance Balance;
};

} // namespace vfm
