/**
 * MeshState: transfers state arrays of the input to the mesh, copied or conserved.
 * StoreState stores the contents of cells before the fractions change; MakeOutputState distributes
 * them to the elements.
 */
#pragma once

#include "Levels/LevelFields.h"
#include "State/ConserveState.h"
#include "State/CopyState.h"
#include "State/OutputState.h"

namespace vfm
{

/// State of the input until there is a mesh.
struct StoredState
{
  std::vector<StateArray> Copied;
  std::vector<std::size_t> Places;             ///< index of each copied array in the choice
  std::unique_ptr<const DonorCells> Conserved; ///< null: nothing is conserved
  /// Nodes of the finest level of the input if its cells are replaced; else empty.
  std::array<std::vector<double>, 3> InputNodes{};
};

/// Returns whether the state of cells is kept, or needed by particles.
bool NeedsState(const StateChoice& choice, const MesherOptions& options);

/// Plans the transfer, and stores the contents of cells if anything is conserved.
/// @param input,cells must outlive the result
/// @param states state arrays of the choice
/// @param fields result of MakeLevelFields; setup: its levels
/// @param owners cells of level 0 that each rank meshes
/// @throws InputError if PlanState, MarkRotated or ConservedCells do, on all ranks
/// @pre Collective
StoredState StoreState(const InputLevels& input, const LevelCells& cells, const StateChoice& choice,
  std::vector<StateArray> states, const LevelFields& fields, const LevelSetup& setup,
  const MesherOptions& options, const std::vector<BlockPlace>& owners, Runtime& runtime);

/// Replaces the cells of the state.
/// @param grid grid of the new cells; the state was stored for all cells that its local box
/// overlaps
void WidenState(const CartesianGrid& grid, Runtime& runtime, StoredState& kept);

/// Makes the state arrays of the mesh.
/// @param mesh elements owned by this rank, in image axes
/// @pre Collective
OutputState MakeOutputState(const StoredState& kept, const InputLevels& input, const Mesh& mesh,
  MeshedGrid meshed, const ConserveOptions& options, const std::vector<BlockPlace>& owners,
  Runtime& runtime);

} // namespace vfm
