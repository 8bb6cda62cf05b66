/**
 * StateValues: the values of state arrays in the cells that a rank needs, also from other ranks.
 */
#pragma once

#include "State/StateArrays.h"

#include <deque>
#include <memory>

namespace vfm
{

/// An array in contiguous memory (CarrierType): a view, or a copy of the cells of one block.
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

/// A block of this rank, or a received part of a block, with the values of the arrays.
struct StateBlock
{
  IndexBox Box, Stored; ///< cells of the block, and the cells of its arrays, which include them
  std::vector<const char*> Values;

  Index Place(const Index3& cell) const { return IndexInBox(this->Stored, cell); }
};

/// The values of all arrays in the cells of one level.
class LevelValues
{
public:
  /// input and states must outlive this object.
  LevelValues(const InputBlocks& input, const std::vector<StateArray>& states) :
    Input(input), States(states)
  {
  }

  /// Sends the parts of blocks that other ranks need, and receives the parts that this rank needs.
  /// @param owners cells of the level that each rank meshes
  /// @pre Collective
  void Exchange(const std::vector<BlockPlace>& owners, Index ghostLayers, Ranks& ranks);

  const std::vector<StateBlock>& GetSources() const { return this->Sources; }
  /// Returns the source that contains a cell, or null.
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
  std::size_t Last = 0; // last source found; consecutive elements are near each other
};

/// The values of each level of the input.
using StateValues = std::vector<std::unique_ptr<LevelValues>>;

/// Returns the number of layers of a level of the input that contain the GhostLayers of
/// another level.
inline Index GhostLayersOn(int level, int other)
{
  return Index(GhostLayers) << std::max(level - other, 0);
}

/// Receives the values in the cells that this rank meshes, and in ghost cells around them.
/// Ghost cells of the input are not used; blanked cells have the values of their arrays.
/// @param level level whose GhostLayers are included; coarser levels have as many layers of
/// their own
/// @param owners cells of level 0 that each rank meshes
/// @pre Collective
StateValues ExchangeState(const InputLevels& input, const std::vector<StateArray>& states,
  int level, const std::vector<BlockPlace>& owners, Ranks& ranks);

} // namespace vfm
