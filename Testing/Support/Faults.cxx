#include "Faults.h"

#include <cerrno>
#include <cstdlib>

extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* memory, std::size_t size);
}

namespace vfm
{
namespace testing
{
namespace
{

struct Fault
{
  bool IsSet = false, HasStruck = false;
  FaultKind Kind = FaultKind::Once;
  std::int64_t At = 0, Calls = 0;
};

thread_local Fault TheFault;

bool Strikes() noexcept
{
  Fault& fault = TheFault;
  if (!fault.IsSet)
  {
    return false;
  }
  const std::int64_t call = fault.Calls++;
  if (call == fault.At || (call > fault.At && fault.Kind == FaultKind::Lasting))
  {
    fault.HasStruck = true;
    errno = ENOMEM;
    return true;
  }
  return false;
}

} // namespace

void SetFault(std::int64_t count, FaultKind kind) noexcept
{
  TheFault = { true, false, kind, count, 0 };
}

std::int64_t ClearFault() noexcept
{
  TheFault.IsSet = false;
  return TheFault.Calls;
}

bool HasStruck() noexcept
{
  return TheFault.HasStruck;
}

} // namespace testing
} // namespace vfm

extern "C"
{
  void* malloc(std::size_t size)
  {
    return vfm::testing::Strikes() ? nullptr : __libc_malloc(size);
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    return vfm::testing::Strikes() ? nullptr : __libc_calloc(count, size);
  }
  void* realloc(void* memory, std::size_t size)
  {
    return vfm::testing::Strikes() ? nullptr : __libc_realloc(memory, size);
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    return vfm::testing::Strikes() ? nullptr : __libc_memalign(alignment, size);
  }
}
