#include "ThreadMemory.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <malloc.h>

extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* memory, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
  void __libc_free(void* memory);
}

namespace vfm
{
namespace testing
{
namespace
{

thread_local std::int64_t Allocated = 0, Peak = 0;

/// Counts memory that is allocated, and returns it.
void* Count(void* memory) noexcept
{
  if (memory)
  {
    Allocated += static_cast<std::int64_t>(malloc_usable_size(memory));
    Peak = std::max(Peak, Allocated);
  }
  return memory;
}

/// Counts memory that will be freed.
void Discount(void* memory) noexcept
{
  if (memory)
  {
    Allocated -= static_cast<std::int64_t>(malloc_usable_size(memory));
  }
}

} // namespace

std::int64_t ThreadBytes() noexcept
{
  return Allocated;
}

std::int64_t TakePeakOfThread() noexcept
{
  const std::int64_t peak = Peak;
  Peak = Allocated;
  return peak;
}

} // namespace testing
} // namespace vfm

extern "C"
{
  void* malloc(std::size_t size)
  {
    return vfm::testing::Count(__libc_malloc(size));
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    return vfm::testing::Count(__libc_calloc(count, size));
  }
  void* realloc(void* memory, std::size_t size)
  {
    const std::size_t before = memory ? malloc_usable_size(memory) : 0;
    void* const moved = __libc_realloc(memory, size);
    if (moved || size == 0)
    {
      vfm::testing::Allocated -= static_cast<std::int64_t>(before);
    }
    return vfm::testing::Count(moved);
  }
  void* memalign(std::size_t alignment, std::size_t size)
  {
    return vfm::testing::Count(__libc_memalign(alignment, size));
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    return vfm::testing::Count(__libc_memalign(alignment, size));
  }
  int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
  {
    *memory = vfm::testing::Count(__libc_memalign(alignment, size));
    return *memory ? 0 : ENOMEM;
  }
  void free(void* memory)
  {
    vfm::testing::Discount(memory);
    __libc_free(memory);
  }
}
