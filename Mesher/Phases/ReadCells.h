/**
 * ReadCells: the first phase of a run: from blocks to the fractions of a grid.
 */
#pragma once

#include "Levels/LevelFields.h"
#include "Levels/WideCells.h"
#include "Modify/MaterialPairs.h"
#include "Phases/MesherInput.h"
#include "State/MeshState.h"

#include <memory>
#include <optional>

namespace vfm
{

/// Cells that are meshed, and what the input says of them. It stays in place: State refers to it.
struct Cells
{
  LevelCells Source; ///< materials of the blocks
  LevelSetup Setup;
  InputRequests Requests;         ///< of the cells that this rank meshes
  InputLevels Input;              ///< with Places near the cells that this rank meshes; in Source
  std::vector<BlockPlace> Owners; ///< cells of level 0 that nearby ranks mesh (FindOwners)
  LevelFields Fields;             ///< changed by PrepareCells
  std::optional<MaterialPairs> SplitPairs, LayerPairs; ///< interfaces to split, to get layers
  StoredState State;                                   ///< contents of the cells as read
  WideReport Wide{};                                   ///< if CellWidth replaced the cells as read
  std::shared_ptr<const InputSurfaces> Surfaces{};     ///< that fit the fractions; null: none
  std::vector<InputBlocks> LevelSets{};                ///< their fractions, which Source reads
};

/// Returns the finest level of the cells as read, or of those that replaced them.
inline int FinestLevel(const MesherJob& job, const Cells& cells)
{
  return cells.Wide.IsUsed() ? 0 : job.Input.Levels.Finest();
}

/// Reads the arrays of the blocks.
/// @throws InputError  if the input is not valid, on all ranks
/// @pre Collective.
std::unique_ptr<Cells> ReadCells(const MesherJob& job);

} // namespace vfm
