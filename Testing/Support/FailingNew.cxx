/// An operator new that fails once, at a selected call. Loaded before all other libraries
/// (LD_PRELOAD), it replaces theirs; tests call it by ctypes. Memory from malloc, which C
/// and Python use, does not fail.
#include <cstdlib>
#include <new>

namespace
{

bool IsCounting = false;
long FailsAt = -1, Calls = 0;

} // namespace

extern "C"
{
  /// Counts calls from 0; the given call fails, none if it is negative.
  void SetFault(long call)
  {
    IsCounting = true;
    FailsAt = call;
    Calls = 0;
  }
  /// Ends counting; returns the number of calls.
  long ClearFault()
  {
    IsCounting = false;
    return Calls;
  }
}

void* operator new(std::size_t size)
{
  const bool fails = IsCounting && Calls++ == FailsAt;
  void* memory = fails ? nullptr : std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
