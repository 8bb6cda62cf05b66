/**
 * OutputState: the state arrays of a mesh, with the balance of their contents.
 */
#pragma once

#include "State/Particles.h"
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
  /// Material without elements; empty unless the option UnmeshedMaterial is Particles.
  std::optional<Particles> TheParticles;
  bool IsConserved = false; ///< true if contents were transferred; sets Balance
  StateBalance Balance;
};

} // namespace vfm
