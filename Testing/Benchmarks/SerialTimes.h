/**
 * SerialTimes: how much of the work of each stage runs on one thread only.
 */
#pragma once

#include "Base/ThreadRuntime.h"

#include <atomic>
#include <ctime>
#include <map>
#include <string>

namespace vfm
{
namespace testing
{

/// Returns the CPU seconds of a clock: CLOCK_PROCESS_CPUTIME_ID or CLOCK_THREAD_CPUTIME_ID.
inline double CpuSeconds(clockid_t clock)
{
  timespec time;
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// CPU seconds of a stage.
struct SerialTime
{
  double Serial = 0.0; ///< of the calling thread, between loops
  double Loops = 0.0;  ///< of all threads, in the bodies of loops

  double Total() const { return this->Serial + this->Loops; }
  /// Returns the largest possible ratio of the speeds on `threads` threads and on one (Amdahl).
  double Bound(int threads) const { return this->Total() / (this->Serial + this->Loops / threads); }
};

using SerialTimes = std::map<std::string, SerialTime>; // by names of stages

/// ThreadRuntime that measures CPU time. CPU time does not depend on other programs as much as wall
/// time does.
class TimedRuntime : public ThreadRuntime
{
public:
  using ThreadRuntime::ThreadRuntime;

  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override
  {
    if (this->IsLooping)
    {
      ThreadRuntime::For(first, last, body);
      return;
    }
    this->IsLooping = true;
    this->AddSerial();
    std::atomic<std::int64_t> nanoseconds(0);
    ThreadRuntime::For(first, last,
      [&](std::int64_t begin, std::int64_t end)
      {
        const double start = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
        body(begin, end);
        nanoseconds +=
          static_cast<std::int64_t>(1e9 * (CpuSeconds(CLOCK_THREAD_CPUTIME_ID) - start));
      });
    this->Stages[this->Stage].Loops += 1e-9 * static_cast<double>(nanoseconds);
    this->Since = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    this->IsLooping = false;
  }
  void Progress(double, const char* stage) override
  {
    this->AddSerial();
    this->Stage = stage;
  }

  /// Returns the times up to now.
  const SerialTimes& Times()
  {
    this->AddSerial();
    return this->Stages;
  }

private:
  void AddSerial()
  {
    const double now = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    this->Stages[this->Stage].Serial += now - this->Since;
    this->Since = now;
  }

  SerialTimes Stages;
  std::string Stage;
  std::atomic<bool> IsLooping{ false };               // read by the threads of nested loops
  double Since = CpuSeconds(CLOCK_THREAD_CPUTIME_ID); // begin of the serial part
};

} // namespace testing
} // namespace vfm
