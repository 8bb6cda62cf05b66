/**
 * ConserveState: makes the conserved state arrays of the elements (State/Transfer/TransferState.h),
 * and the balance of contents.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "State/CopyState.h"
#include "State/MakeParticles.h"

#include <optional>

namespace vfm
{

/// Conserved arrays of a mesh.
struct ConservedState
{
  std::vector<TransferredArray> Arrays;           ///< element arrays of type double
  std::vector<std::size_t> States;                ///< first state array of the input of each array
  std::optional<TransferredArray> NodalVelocity;  ///< point array
  std::optional<ConservedParticles> TheParticles; ///< if unmeshed material becomes particles
  StateBalance Balance;
};

/// Transfers the contents of cells to elements. Lost kinetic energy is only reported if no array is
/// the energy.
/// @param mesh elements owned by this rank, in image axes
/// @pre Collective
ConservedState ConserveState(const Mesh& mesh, const MeshedGrid& meshed, const DonorCells& cells,
  const ConserveOptions& options, Runtime& runtime);

} // namespace vfm
