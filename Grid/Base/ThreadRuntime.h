/**
 * ThreadRuntime: a Runtime with threads and ranks.
 */
#pragma once

#include "Base/LoopThreads.h"
#include "Base/Runtime.h"

#include <algorithm>
#include <thread>

namespace vfm
{

/// Returns the number of threads per rank.
/// @param given  number that the user set; 0: all cores on a single rank, one
///   thread on several ranks
/// @param processes  number of ranks
inline int ChooseThreads(int given, int processes)
{
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return given > 0 ? given : processes > 1 ? 1 : cores;
}

/// Runtime whose loops share threads that stay alive between loops (LoopThreads).
class ThreadRuntime : public Runtime
{
public:
  /// @param threads  maximum number of threads
  /// @param ranks  must outlive this object; null for a single rank
  explicit ThreadRuntime(int threads, Ranks* ranks = nullptr) : Count(threads), TheRanks(ranks) {}

  /// Runs a loop on at most `threads` threads; fewer if the system cannot start them. Rethrows the
  /// first exception of the body after all ranges have run.
  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override
  {
    this->Threads.For(this->Count, first, last, body);
  }
  Ranks& Group() override { return this->TheRanks ? *this->TheRanks : this->Runtime::Group(); }

protected:
  const int Count; // maximum number of threads

private:
  Ranks* TheRanks;
  LoopThreads Threads;
};

} // namespace vfm
