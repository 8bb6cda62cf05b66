/**
 * PythonRuntime: runs loops on threads without the GIL of Python, reports progress to a callable,
 * and handles Ctrl-C.
 *
 * The calling thread checks for signals at the start of loops and inside long loops, at most ten
 * times per second. If a signal, the progress callable or another call of Python raises an
 * exception, all threads stop, and Run throws the exception.
 */
#pragma once

#include "Base/ThreadRuntime.h"

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <string>
#include <thread>

namespace vfm
{

class PythonRuntime : public ThreadRuntime
{
public:
  /// Must be created by the thread that calls Run.
  /// @param threads number of threads; 0: all cores
  /// @param progress None, or callable(fraction, stage); must outlive this object
  /// @throws ValueError if threads is negative
  PythonRuntime(int threads, nanobind::handle progress);

  /// Calls work without the GIL, which the thread must hold. Throws exceptions that Python raised.
  void Run(const std::function<void()>& work);

  /// Calls Python inside Run, from the thread that called Run. Throws Aborted if Python raises.
  void CallPython(const std::function<void()>& call);

  /// Divides long ranges, also on one thread, so that they can be stopped.
  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override;
  void Progress(double fraction, const char* stage) override;

private:
  using Clock = std::chrono::steady_clock;

  void RunPieces(std::int64_t begin, std::int64_t end, std::int64_t length,
    const std::function<void(std::int64_t, std::int64_t)>& body);
  void Look(Clock::time_point now);

  const nanobind::handle Callable;
  const std::thread::id Caller = std::this_thread::get_id();
  std::atomic<bool> IsStopped{ false };
  std::exception_ptr Raised; // exception of Python; set once
  Clock::time_point NextLook, NextReport;
  std::string Reported; // last reported stage
};

} // namespace vfm
