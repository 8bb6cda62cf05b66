#include "Base/SlotArena.h"

#include "Base/Memory.h"

#include <algorithm>

namespace vfm
{
namespace
{

// A block is as large as all blocks before it together, which limits the unused memory.
constexpr std::size_t SmallestBlock = std::size_t(1) << 12, LargestBlock = std::size_t(1) << 22;

} // namespace

SlotArena::~SlotArena()
{
  for (void* block : this->Blocks)
  {
    std::free(block);
  }
}

void* SlotArena::Take()
{
  if (!this->Spare.empty())
  {
    void* slot = this->Spare.back();
    this->Spare.pop_back();
    return slot;
  }
  if (this->Left == 0)
  {
    const std::size_t bytes = std::min(std::max(this->BlockBytes, SmallestBlock), LargestBlock);
    this->Left = std::max<std::size_t>(bytes / this->SlotBytes, 1);
    // The list grows before the block is allocated: no block leaks if the list cannot grow.
    this->Blocks.push_back(nullptr);
    this->Blocks.back() = AllocateBytes(this->Left * this->SlotBytes);
    this->BlockBytes += this->Left * this->SlotBytes;
    this->Next = static_cast<char*>(this->Blocks.back());
  }
  --this->Left;
  void* slot = this->Next;
  this->Next += this->SlotBytes;
  return slot;
}

} // namespace vfm
