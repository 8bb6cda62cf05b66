/**
 * Memory for large arrays. It is freed by std::free, so VTK can adopt it, and uses huge pages where
 * the system has them: the first access to a gigabyte takes 0.1 s instead of 0.8 s.
 */
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace vfm
{

/// Returns uninitialised memory, to be freed by std::free. Blocks of 4 MB or more use huge pages.
/// @throws std::bad_alloc  if there is not enough memory
inline void* AllocateBytes(std::size_t bytes)
{
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  void* memory = nullptr;
  if (bytes < 2 * hugePage)
  {
    memory = std::malloc(bytes > 0 ? bytes : 1);
  }
  else
  {
    bytes = (bytes + hugePage - 1) / hugePage * hugePage;
    memory = std::aligned_alloc(hugePage, bytes);
#ifdef MADV_HUGEPAGE
    if (memory)
    {
      madvise(memory, bytes, MADV_HUGEPAGE); // if it fails, pages are small
    }
#endif
  }
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

/// Returns freed memory to the system; otherwise malloc may keep up to 64 MB of it.
inline void ReleaseFreeMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

/// Allocator for std::vector that uses AllocateBytes.
template <class T>
struct LargeAllocator
{
  using value_type = T;
  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&)
  {
  }
  T* allocate(std::size_t n) { return static_cast<T*>(AllocateBytes(n * sizeof(T))); }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  template <class U>
  bool operator==(const LargeAllocator<U>&) const
  {
    return true;
  }
  template <class U>
  bool operator!=(const LargeAllocator<U>&) const
  {
    return false;
  }
};

} // namespace vfm
