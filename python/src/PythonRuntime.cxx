#include "PythonRuntime.h"

#include <algorithm>
#include <utility>

namespace vfm
{
namespace
{

constexpr std::chrono::milliseconds BetweenLooks(100), BetweenTellings(50);
// Few pieces, because the start of a body can take some hundredths of the time of its loop.
constexpr int FirstPieces = 64; // the first piece is this fraction of the work of a thread
constexpr int Growth = 8;       // growth of the size after a short piece
constexpr std::chrono::milliseconds LongPiece(200);

int CountThreads(int threads)
{
  if (threads < 0)
  {
    throw nanobind::value_error("threads must be 0, for all cores, or more.");
  }
  return ChooseThreads(threads, 1);
}

} // namespace

PythonRuntime::PythonRuntime(int threads, nanobind::handle progress) :
  ThreadRuntime(CountThreads(threads)), Callable(progress)
{
}

void PythonRuntime::Run(const std::function<void()>& work)
{
  try
  {
    const nanobind::gil_scoped_release release;
    work();
  }
  catch (const Aborted&)
  {
    std::rethrow_exception(std::exchange(this->Raised, nullptr)); // only CallPython throws Aborted
  }
}

void PythonRuntime::CallPython(const std::function<void()>& call)
{
  try
  {
    const nanobind::gil_scoped_acquire acquire;
    call();
  }
  catch (...)
  {
    this->Raised = std::current_exception();
    this->IsStopped = true;
    throw Aborted();
  }
}

/// Throws Aborted if the run must stop; checks for signals on the calling thread.
void PythonRuntime::Look(Clock::time_point now)
{
  if (this->IsStopped)
  {
    throw Aborted();
  }
  if (std::this_thread::get_id() == this->Caller && now >= this->NextLook)
  {
    this->CallPython(
      []
      {
        if (PyErr_CheckSignals() != 0)
        {
          throw nanobind::python_error();
        }
      });
    this->NextLook = Clock::now() + BetweenLooks;
  }
}

void PythonRuntime::For(std::int64_t first, std::int64_t last,
  const std::function<void(std::int64_t, std::int64_t)>& body)
{
  const std::int64_t length =
    std::max<std::int64_t>(1, (last - first) / (FirstPieces * std::int64_t(this->Count)));
  this->ThreadRuntime::For(first, last,
    [&](std::int64_t begin, std::int64_t end) { this->RunPieces(begin, end, length, body); });
}

/// Runs a range in pieces of the given length, which grows while pieces take little time.
void PythonRuntime::RunPieces(std::int64_t begin, std::int64_t end, std::int64_t length,
  const std::function<void(std::int64_t, std::int64_t)>& body)
{
  Clock::time_point start = Clock::now();
  for (;;)
  {
    this->Look(start);
    const std::int64_t next = begin + std::min(length, end - begin);
    body(begin, next);
    if (next == end)
    {
      return;
    }
    begin = next;
    const Clock::time_point now = Clock::now();
    if (now - start < LongPiece / Growth)
    {
      length *= Growth;
    }
    else if (now - start > LongPiece)
    {
      length = std::max<std::int64_t>(1, length / Growth);
    }
    start = now;
  }
}

void PythonRuntime::Progress(double fraction, const char* stage)
{
  const Clock::time_point now = Clock::now();
  this->Look(now);
  if (this->Callable.is_none() || (now < this->NextReport && this->Reported == stage))
  {
    return;
  }
  this->CallPython([&] { this->Callable(fraction, stage); });
  this->Reported = stage;
  this->NextReport = Clock::now() + BetweenTellings;
}

} // namespace vfm
