/**
 * SlotArena: many pieces of memory of one size, taken and given back one at a time, freed together.
 * They lie in large blocks, so a piece costs no more than its size. Not for several threads at once.
 */
#pragma once

#include <cstddef>
#include <vector>

namespace vfm
{

class SlotArena
{
public:
  /// bytes: of a slot; a multiple of 8.
  explicit SlotArena(std::size_t bytes) : SlotBytes(bytes) {}
  SlotArena(const SlotArena&) = delete;
  SlotArena& operator=(const SlotArena&) = delete;
  ~SlotArena();

  /// A slot, not initialised.
  void* Take();
  /// Gives a slot back, for Take to hand out again.
  void Give(void* slot) { this->Spare.push_back(slot); }

  std::size_t MemoryInBytes() const
  {
    return this->BlockBytes + this->Spare.capacity() * sizeof(void*);
  }

private:
  std::size_t SlotBytes;
  std::size_t BlockBytes = 0; // of all blocks
  std::vector<void*> Blocks, Spare;
  char* Next = nullptr; // in the last block
  std::size_t Left = 0; // slots from there
};

} // namespace vfm
