/**
 * ThreadMemory: the memory that a thread has allocated. Ranks that are threads share a process, so
 * the memory of one rank can only be counted call by call.
 */
#pragma once

#include <cstdint>

namespace vfm
{
namespace testing
{

/// Returns the bytes that the calling thread has allocated and not freed. What another thread frees
/// is counted there.
std::int64_t ThreadBytes() noexcept;

/// Returns the largest ThreadBytes since the last call, or since the thread began.
std::int64_t TakePeakOfThread() noexcept;

} // namespace testing
} // namespace vfm
