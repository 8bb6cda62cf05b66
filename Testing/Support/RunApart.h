/**
 * Work in a process of its own: what crashes, hangs or asks for too much memory there is told here.
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
  std::string Text;    ///< what the work returned
  std::string Failure; ///< "" or how the process ended without returning
};

/// Forks; call it while there is one thread. memory: in bytes, what the work may ask for beside
/// what this process has; 0: no limit.
ApartResult RunApart(const std::function<std::string()>& work, int seconds, std::size_t memory = 0);

} // namespace testing
} // namespace vfm
