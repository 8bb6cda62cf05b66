/**
 * LoopThreads: threads that share the loops of a run and stay alive between loops.
 */
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace vfm
{

/// Pool of threads for loops. The calling thread begins each loop and measures the time; it wakes
/// the other threads only if enough work is left. Idle threads spin for 100 microseconds, because
/// smoothing runs thousands of loops, and then sleep. One thread calls For at a time.
class LoopThreads
{
public:
  using Body = std::function<void(std::int64_t, std::int64_t)>;

  LoopThreads() = default;
  LoopThreads(const LoopThreads&) = delete;
  LoopThreads& operator=(const LoopThreads&) = delete;
  ~LoopThreads();

  /// Calls body(begin, end) on disjoint ranges that cover [first, last). A nested loop runs on the
  /// calling thread. Other threads are started by the first loop that needs them; if the system
  /// cannot start all of them, the loop runs on fewer. Rethrows the first exception of a body after
  /// all ranges have run.
  /// @param threads  maximum number of threads, including the calling one
  void For(int threads, std::int64_t first, std::int64_t last, const Body& body);

private:
  /// Bits of State: the number of other threads that work on the loop (Working), whether more
  /// threads may join (IsOpen), and the number of the loop (from Next).
  static constexpr std::uint64_t IsOpen = 1 << 16, Next = 1 << 17, Working = IsOpen - 1;

  void RunItems(std::int64_t first, int threads);
  void RunMany(std::int64_t first, int threads);
  void Open(std::int64_t first);
  void Wake(int others);
  void Start(int others);
  void Finish();
  void RunRange(std::int64_t begin, std::int64_t end) noexcept;
  bool RunNext() noexcept;
  void RunRanges() noexcept;
  void Work() noexcept;
  std::uint64_t WaitForLoop(std::uint64_t done);
  bool IsNew(std::uint64_t state, std::uint64_t done) const
  {
    return this->IsEnding || ((state & IsOpen) && state / Next != done);
  }
  void WaitForOthers();

  std::vector<std::thread> Others;
  bool HasStarted = false, IsLooping = false;
  bool Spins = true; // false: there are fewer cores than threads

  const Body* TheBody = nullptr;
  std::int64_t Last = 0, Grain = 1;
  std::exception_ptr Thrown; // first exception of a body

  alignas(64) std::atomic<std::uint64_t> State{ 0 };
  alignas(64) std::atomic<std::int64_t> Begin{ 0 }; // begin of the next range
  alignas(64) std::mutex Lock;
  std::condition_variable HasLoop, HasDone;
  std::atomic<int> Sleeping{ 0 };
  std::atomic<bool> IsWaiting{ false }, IsEnding{ false };
};

} // namespace vfm
