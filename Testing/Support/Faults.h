/**
 * Memory that runs out on one thread, on demand. For executables that link Faults.cxx, whose malloc
 * takes the place of glibc's.
 */
#pragma once

#include <cstdint>

namespace vfm
{
namespace testing
{

enum class FaultKind
{
  Once,   ///< one call fails
  Lasting ///< and all that follow, until the faults are taken off
};

/// From now on this thread's call of malloc and its family fails that is the count-th, from 0.
void SetFault(std::int64_t count, FaultKind kind) noexcept;
/// Takes the fault off. How many calls there were since it was set.
std::int64_t ClearFault() noexcept;
/// Whether the last fault that was set on this thread has struck.
bool HasStruck() noexcept;

} // namespace testing
} // namespace vfm
