/**
 * LoopThreads: threads that share the loops of a run, kept from one to the next.
 *
 * The calling thread begins each loop and looks at the clock: a loop that it will soon have done wakes no others, whatever its
 * items cost. Between loops threads watch out for a few microseconds, since smoothing runs thousands of them, then sleep.
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

class LoopThreads
{
public:
  using Body = std::function<void(std::int64_t, std::int64_t)>;

  LoopThreads() = default;
  LoopThreads(const LoopThreads&) = delete;
  LoopThreads& operator=(const LoopThreads&) = delete;
  ~LoopThreads();

  /// Calls body(begin, end) on disjoint ranges that cover [first, last), on at most so many threads, this one among them. The first
  /// exception is thrown on, once all ranges were tried. Others are started when a loop needs them; those that the system does not
  /// give are done without. Loops inside of loops take one thread.
  void For(int threads, std::int64_t first, std::int64_t last, const Body& body);

private:
  /// The others' view of a loop: how many work on it, whether more may, and its number.
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
  bool Spins = true; // where each thread has a core

  const Body* TheBody = nullptr;
  std::int64_t Last = 0, Grain = 1;
  std::exception_ptr Thrown; // the first

  alignas(64) std::atomic<std::uint64_t> State{ 0 };
  alignas(64) std::atomic<std::int64_t> Begin{ 0 }; // of the next range
  alignas(64) std::mutex Lock;
  std::condition_variable HasLoop, HasDone;
  std::atomic<int> Sleeping{ 0 };
  std::atomic<bool> IsWaiting{ false }, IsEnding{ false };
};

} // namespace vfm
