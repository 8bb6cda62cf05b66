/**
 * PythonRuntime: loops on threads of their own without the lock of Python, progress told to a callable, and Ctrl-C.
 *
 * The thread that called asks Python for signals at the start of loops and inside of long ones, some ten times a second at most. What a signal,
 * the callable of progress or another call of Python raises stops all threads and is thrown on by Run as it was raised.
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
  /// Made by the thread that runs. threads: 0 for all cores; progress: None, or callable(fraction, stage), to outlive this. Throws ValueError on
  /// a negative number of threads.
  PythonRuntime(int threads, nanobind::handle progress);

  /// Does the work without the lock of Python, which the thread must have. Throws what Python raised meanwhile.
  void Run(const std::function<void()>& work);

  /// Calls Python inside of Run, from the thread that called it. Throws Aborted when the call raises.
  void CallPython(const std::function<void()>& call);

  /// Long ranges are cut, also on one thread, so that they can be stopped.
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
  std::exception_ptr Raised; // by Python; set once
  Clock::time_point NextLook, NextReport;
  std::string Reported; // the last stage
};

} // namespace vfm
