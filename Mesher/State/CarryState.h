/**
 * CarryState: state arrays of the input carried over to the mesh, copied or conserved as chosen. What the cells hold is kept before
 * the fractions change, and given to the elements once there is a mesh.
 */
#pragma once

#include "State/ConserveState.h"
#include "State/CopyState.h"

namespace vfm
{

struct StoredState
{
  std::vector<StateArray> Copied;
  std::vector<std::size_t> Places;                 ///< in the choice, of each of these
  std::unique_ptr<const ConservedCells> Conserved; ///< null: nothing is conserved
};

struct OutputState
{
  std::vector<TransferredArray> Arrays;          ///< a tuple an element, in the order of the choice
  std::optional<TransferredArray> NodalVelocity; ///< a tuple a point
  bool IsConserved = false;                      ///< any, so that there is a balance
  StateBalance Balance;
};

/// Collective: keeps what cells hold if anything is conserved. states: those of the choice. fields: as MakeLevelFields made them; setup: their
/// levels. input and cells must outlive the result. owners: the cells of level 0 that the ranks mesh. Throws InputError, on all ranks
/// alike, as PlanState and ConservedCells do.
StoredState StoreState(const InputLevels& input, const LevelCells& cells, const StateChoice& choice,
  const std::vector<StateArray>& states, const LevelFields& fields, const LevelSetup& setup,
  bool meshVoid, const std::vector<BlockPlace>& owners, Runtime& runtime);

/// Collective. mesh: of this rank's owned cells, in the axes of the input.
OutputState GiveState(const StoredState& kept, const InputLevels& input, const Mesh& mesh,
  const MeshedGrid& meshed, const ConserveOptions& options, const std::vector<BlockPlace>& owners,
  Runtime& runtime);

} // namespace vfm
