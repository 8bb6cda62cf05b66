#include "Base/LoopThreads.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace vfm
{
namespace
{

using Clock = std::chrono::steady_clock;

constexpr double LeastShared = 40e-6; // seconds; loops with less work left run on one thread
constexpr double LeastRange = 10e-6;  // seconds per range; makes the cost of taking it negligible
constexpr std::chrono::microseconds Watching(100);
constexpr int RangesOfThread = 16; // maximum; a body may have a fixed cost per range
constexpr int FirstRanges = 64;    // the first range is 1/64 of the share of a thread

double SecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void Pause()
{
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

/// Returns whether a condition becomes true within the time Watching.
template <class Condition>
bool Watch(const Condition& isTrue)
{
  for (const Clock::time_point end = Clock::now() + Watching; Clock::now() < end;)
  {
    for (int i = 0; i < 32; ++i)
    {
      if (isTrue())
      {
        return true;
      }
      Pause();
    }
  }
  return false;
}

} // namespace

LoopThreads::~LoopThreads()
{
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    this->IsEnding = true;
  }
  this->HasLoop.notify_all();
  for (std::thread& other : this->Others)
  {
    other.join();
  }
}

void LoopThreads::For(int threads, std::int64_t first, std::int64_t last, const Body& body)
{
  if (first >= last)
  {
    return;
  }
  if (threads < 2 || last - first < 2 || this->IsLooping)
  {
    body(first, last);
    return;
  }
  this->IsLooping = true;
  this->TheBody = &body;
  this->Last = last;
  if (last - first <= threads * RangesOfThread)
  {
    this->RunItems(first, threads);
  }
  else
  {
    this->RunMany(first, threads);
  }
  this->IsLooping = false;
  if (this->Thrown)
  {
    std::rethrow_exception(std::exchange(this->Thrown, nullptr));
  }
}

/// Runs a loop of few items, one item per range. Threads that spin take items at once. Sleeping
/// threads are woken after the first item if the remaining work exceeds LeastShared.
void LoopThreads::RunItems(std::int64_t first, int threads)
{
  this->Grain = 1;
  this->Open(first);
  const Clock::time_point begin = Clock::now();
  if (this->RunNext() &&
    SecondsSince(begin) * static_cast<double>(this->Last - first - 1) > LeastShared)
  {
    this->Wake(threads - 1);
  }
  this->Finish();
}

/// Runs ranges on this thread, each twice as long as the one before. Once the time per item
/// shows that the remaining work exceeds LeastShared, it sets the length of ranges and
/// wakes the other threads.
void LoopThreads::RunMany(std::int64_t first, int threads)
{
  const double share = static_cast<double>(this->Last - first) / threads;
  std::int64_t length = 1 + static_cast<std::int64_t>(share / FirstRanges);
  while (first < this->Last)
  {
    length = std::min(length, this->Last - first);
    const Clock::time_point begin = Clock::now();
    this->RunRange(first, first + length);
    const double item = SecondsSince(begin) / static_cast<double>(length);
    first += length;
    if (item * static_cast<double>(this->Last - first) > LeastShared)
    {
      this->Grain = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::max(share / RangesOfThread, LeastRange / item)));
      this->Open(first);
      this->Wake(threads - 1);
      this->Finish();
      return;
    }
    length *= 2;
  }
}

void LoopThreads::Start(int others)
{
  if (this->HasStarted)
  {
    return;
  }
  this->HasStarted = true;
  this->Spins = others < static_cast<int>(std::thread::hardware_concurrency());
  try
  {
    this->Others.reserve(others);
    while (static_cast<int>(this->Others.size()) < others)
    {
      this->Others.emplace_back([this] { this->Work(); });
    }
  }
  catch (const std::exception&) // the threads started so far do the work
  {
  }
}

void LoopThreads::Open(std::int64_t first)
{
  this->Begin.store(first, std::memory_order_relaxed);
  this->State = (this->State / Next + 1) * Next | IsOpen;
}

void LoopThreads::Wake(int others)
{
  this->Start(others);
  if (this->Sleeping > 0)
  {
    {
      // With the lock, no thread is between its check and its sleep.
      const std::lock_guard<std::mutex> guard(this->Lock);
    }
    this->HasLoop.notify_all();
  }
}

void LoopThreads::Finish()
{
  this->RunRanges();
  this->State.fetch_and(~IsOpen);
  this->WaitForOthers();
}

void LoopThreads::RunRange(std::int64_t begin, std::int64_t end) noexcept
{
  try
  {
    (*this->TheBody)(begin, end);
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    if (!this->Thrown)
    {
      this->Thrown = std::current_exception();
    }
  }
}

/// Runs the next range. Returns whether there was one.
bool LoopThreads::RunNext() noexcept
{
  const std::int64_t grain = this->Grain, begin = this->Begin.fetch_add(grain);
  if (begin >= this->Last)
  {
    return false;
  }
  this->RunRange(begin, std::min(this->Last, begin + grain));
  return true;
}

void LoopThreads::RunRanges() noexcept
{
  while (this->RunNext())
  {
  }
}

void LoopThreads::WaitForOthers()
{
  const auto isDone = [this] { return (this->State & Working) == 0; };
  if (isDone() || (this->Spins && Watch(isDone)))
  {
    return;
  }
  std::unique_lock<std::mutex> guard(this->Lock);
  this->IsWaiting = true;
  this->HasDone.wait(guard, isDone);
  this->IsWaiting = false;
}

void LoopThreads::Work() noexcept
{
  std::uint64_t done = 0; // number of the last loop that this thread joined
  for (;;)
  {
    std::uint64_t state = this->WaitForLoop(done);
    if (this->IsEnding)
    {
      return;
    }
    if (!this->State.compare_exchange_strong(state, state + 1))
    {
      continue;
    }
    done = state / Next;
    this->RunRanges();
    if ((this->State.fetch_sub(1) & Working) == 1 && this->IsWaiting)
    {
      {
        const std::lock_guard<std::mutex> guard(this->Lock);
      }
      this->HasDone.notify_one();
    }
  }
}

/// Waits for an open loop other than `done`, or for the end. Returns its state.
std::uint64_t LoopThreads::WaitForLoop(std::uint64_t done)
{
  std::uint64_t state = this->State;
  const auto isNew = [&] { return this->IsNew(state = this->State, done); };
  if (!isNew() && !(this->Spins && Watch(isNew)))
  {
    std::unique_lock<std::mutex> guard(this->Lock);
    ++this->Sleeping;
    this->HasLoop.wait(guard, isNew);
    --this->Sleeping;
  }
  return state;
}

} // namespace vfm
