/**
 * SlotArena: an allocator of slots of memory of one size.
 */
#pragma once

#include <cstddef>
#include <vector>

namespace vfm
{

/// Pool of slots of one size in large blocks, without overhead per slot. Slots are taken and
/// returned one at a time; the destructor frees all of them. It is not thread-safe.
class SlotArena
{
public:
  /// @param bytes  size of a slot, a multiple of 8
  explicit SlotArena(std::size_t bytes) : SlotBytes(bytes) {}
  SlotArena(const SlotArena&) = delete;
  SlotArena& operator=(const SlotArena&) = delete;
  ~SlotArena();

  /// Returns an uninitialised slot.
  /// @throws std::bad_alloc  if there is not enough memory
  void* Take();
  /// Returns a slot to the pool for reuse.
  void Give(void* slot) { this->Spare.push_back(slot); }

  std::size_t MemoryInBytes() const
  {
    return this->BlockBytes + this->Spare.capacity() * sizeof(void*);
  }

private:
  std::size_t SlotBytes;
  std::size_t BlockBytes = 0; // size of all blocks
  std::vector<void*> Blocks, Spare;
  char* Next = nullptr; // first unused slot of the last block
  std::size_t Left = 0; // number of slots from Next
};

} // namespace vfm
