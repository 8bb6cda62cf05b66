/// An operator new that fails once, at a chosen call. Loaded before all other libraries
/// (LD_PRELOAD), it takes the place of theirs; tests reach it by ctypes. Memory of malloc, which C
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
  /// From now on calls are counted from 0, and that one fails; none when it is negative.
  void SetFault(long call)
  {
    IsCounting = true;
    FailsAt = call;
    Calls = 0;
  }
  /// Ends this; returns the calls.
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
