/**
 * StateValues: the values of arrays in the cells of the input that a rank needs, from whichever ranks read them.
 */
#pragma once

#include "State/StateArrays.h"

#include <deque>
#include <memory>

namespace vfm
{

/// An array as plain memory, in its carrier's type: its own, or a copy of the cells of one block.
class PlainTuples
{
public:
  PlainTuples(std::shared_ptr<const BlockArray> array, Index first, Index count, std::size_t size);
  const char* Data() const { return this->Values ? this->Values : this->Copy.data(); }

private:
  std::shared_ptr<const BlockArray> Array;
  const char* Values = nullptr;
  Bytes Copy;
};

/// The cells of a block of this rank, or of a part of one that another sent, and the values of the arrays there.
struct StateBlock
{
  IndexBox Box, Stored; ///< the cells; those of the arrays, of which they are some
  std::vector<const char*> Values;

  Index Place(const Index3& cell) const { return IndexInBox(this->Stored, cell); }
};

/// The values of all arrays in the cells of one level.
class LevelValues
{
public:
  /// input, states: must outlive this.
  LevelValues(const InputBlocks& input, const std::vector<StateArray>& states) :
    Input(input), States(states)
  {
  }

  /// Collective: sends the parts of blocks that other ranks need, and receives what this rank needs. owners: the cells of the level that the
  /// ranks mesh.
  void Exchange(const std::vector<BlockPlace>& owners, Index ghostLayers, Ranks& ranks);

  const std::vector<StateBlock>& GetSources() const { return this->Sources; }
  /// What has the values of a cell, or null.
  const StateBlock* Find(const Index3& cell);

private:
  void AddBlocks();
  Bytes Pack(const IndexBox& requested) const;
  void AddParts(const Bytes& message);

  const InputBlocks& Input;
  const std::vector<StateArray>& States;
  std::deque<PlainTuples> Tuples;
  std::vector<Bytes> Messages; // some sources point into them
  std::vector<StateBlock> Sources;
  std::size_t Last = 0; // the source found last: elements lie near each other
};

/// Of each level of the input.
using StateValues = std::vector<std::unique_ptr<LevelValues>>;

/// Layers of cells of a level of the input that hold the GhostLayers of another, be that finer or coarser.
inline Index GhostLayersOn(int level, int other)
{
  return Index(GhostLayers) << std::max(level - other, 0);
}

/// Collective: of the cells that this rank meshes and the GhostLayers around them in cells of a level; of coarser levels in their own cells.
/// owners: the cells of level 0 that the ranks mesh. Ghost cells give nothing, blanked cells what their arrays hold.
StateValues ExchangeState(const InputLevels& input, const std::vector<StateArray>& states,
  int level, const std::vector<BlockPlace>& owners, Ranks& ranks);

} // namespace vfm
