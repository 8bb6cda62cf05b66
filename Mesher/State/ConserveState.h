/**
 * ConserveState: arrays of the mesh that hold all that the cells of the input hold (Transfer/TransferState.h), and what was kept and lost.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "State/ConservedCells.h"
#include "State/StateBalance.h"
#include "State/TransferredArray.h"

#include <optional>

namespace vfm
{

struct ConservedState
{
  std::vector<TransferredArray> Arrays; ///< a tuple an element, of type double
  std::vector<std::size_t>
    States; ///< of each the first state array of the input that it comes from
  std::optional<TransferredArray> NodalVelocity; ///< a tuple a point
  StateBalance Balance;
};

/// Collective. mesh: of this rank's owned elements, in the axes of the input; grid: that it was made of. Lost energy stays lost where no
/// array is the energy.
ConservedState ConserveState(const Mesh& mesh, const CartesianGrid& grid,
  const ConservedCells& cells, const ConserveOptions& options, Runtime& runtime);

} // namespace vfm
