/**
 * Runs work in its own process: crashes, hangs and excessive use of memory
 * are reported to the caller.
 */
#pragma once

#include <functional>
#include <string>

namespace vfm
{
namespace testing
{

struct ApartResult
{
  std::string Text;    ///< text that the work returned
  std::string Failure; ///< empty, or how the process ended without returning
};

/// Forks; the caller must have only one thread. memory: limit of the memory that the work may
/// allocate in addition to this process, bytes; 0: no limit.
ApartResult RunApart(const std::function<std::string()>& work, int seconds, std::size_t memory = 0);

} // namespace testing
} // namespace vfm
