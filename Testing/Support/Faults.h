/**
 * Memory that runs out on one thread, on demand. An executable links Faults.cxx, whose
 * malloc replaces that of glibc.
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
  Lasting ///< this call and all later ones fail until ClearFault
};

/// Makes one call of malloc and its family fail on this thread, counted from 0 from now on.
void SetFault(std::int64_t count, FaultKind kind) noexcept;
/// Ends the fault; returns the number of calls since SetFault.
std::int64_t ClearFault() noexcept;
/// Returns whether a call has failed since SetFault on this thread.
bool HasStruck() noexcept;

} // namespace testing
} // namespace vfm
