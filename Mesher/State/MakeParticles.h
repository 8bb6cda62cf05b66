/**
 * MakeParticles: makes particles and their conserved state from contents that no element receives.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "State/ConservedCells.h"
#include "State/Particles.h"
#include "State/StateBalance.h"

namespace vfm
{

/// Particles without copied state.
struct ConservedParticles
{
  Particles Items;             ///< an array for each conserved array of the plan
  std::vector<Index3> Cells;   ///< cell of each particle, of those joined the best
  std::vector<StateSums> Sums; ///< sums of each material from 0 over all ranks
  std::vector<Index> Counts;   ///< particles of each material from 0 over all ranks
};

/// @param rows  result of TransferState
/// @param grid  grid of the rows, which may have copies of cells (RepeatedCells)
/// @param cells  cells that were transferred
/// @pre Collective.
ConservedParticles MakeParticles(const UnmeshedRows& rows, const CartesianGrid& grid,
  const DonorCells& cells, const ConserveOptions& options, Runtime& runtime);

} // namespace vfm
