/**
 * ThreadRuntime: loops on threads that are kept from loop to loop, and the ranks that work on one grid.
 */
#pragma once

#include "Base/LoopThreads.h"
#include "Base/Runtime.h"

#include <algorithm>
#include <thread>

namespace vfm
{

/// Threads for the number that a user gave; 0: all cores on one process, one thread on each of several.
inline int ChooseThreads(int given, int processes)
{
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return given > 0 ? given : processes > 1 ? 1 : cores;
}

class ThreadRuntime : public Runtime
{
public:
  /// ranks: null for one process; must outlive this.
  explicit ThreadRuntime(int threads, Ranks* ranks = nullptr) : Count(threads), TheRanks(ranks) {}

  /// An exception in the body is thrown on, once all threads have ended. Threads that the system does not give are done without.
  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override
  {
    this->Threads.For(this->Count, first, last, body);
  }
  Ranks& Group() override { return this->TheRanks ? *this->TheRanks : this->Runtime::Group(); }

protected:
  const int Count; // of threads

private:
  Ranks* TheRanks;
  LoopThreads Threads;
};

} // namespace vfm
