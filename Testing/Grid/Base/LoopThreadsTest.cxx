/**
 * Threads that persist between loops: each item is processed once; exceptions, nested loops,
 * sleeping threads.
 */
#include "Base/LoopThreads.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <stdexcept>

using namespace vfm;

namespace
{

using Clock = std::chrono::steady_clock;

/// Keeps a thread busy.
void Work(std::chrono::microseconds time)
{
  for (const Clock::time_point end = Clock::now() + time; Clock::now() < end;)
  {
  }
}

/// Returns how often each item of a loop was processed.
std::vector<int> CountItems(LoopThreads& threads, int count, int items, int microseconds)
{
  std::vector<int> done(items, 0);
  threads.For(count, 0, items,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        Work(std::chrono::microseconds(microseconds));
        ++done[i];
      }
    });
  return done;
}

} // namespace

TEST(LoopThreads, DoEachItemOnce)
{
  for (int count : { 1, 2, 3, 8 })
  {
    LoopThreads threads;
    for (int items : { 0, 1, 2, 3, 100, 1000 })
    {
      EXPECT_EQ(CountItems(threads, count, items, 0), std::vector<int>(items, 1));
      EXPECT_EQ(CountItems(threads, count, items, 5), std::vector<int>(items, 1));
    }
    for (int loop = 0; loop < 300; ++loop)
    {
      ASSERT_EQ(CountItems(threads, count, 40, loop % 4), std::vector<int>(40, 1)) << loop;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2)); // the threads fall asleep
    EXPECT_EQ(CountItems(threads, count, 100, 5), std::vector<int>(100, 1));
  }
}

TEST(LoopThreads, ShareOnlyLongLoops)
{
  LoopThreads threads;
  std::mutex lock;
  std::set<std::thread::id> workers;
  const auto collect = [&](std::int64_t begin, std::int64_t end)
  {
    Work(std::chrono::milliseconds(2 * (end - begin)));
    const std::lock_guard<std::mutex> guard(lock);
    workers.insert(std::this_thread::get_id());
  };
  for (int tries = 0; tries < 100 && workers.size() < 2; ++tries)
  {
    threads.For(2, 0, 20, collect);
  }
  EXPECT_EQ(workers.size(), 2u);
  // Most loops run on one thread. If this thread waits for its core, it finds a loop long.
  int alone = 0;
  for (int loop = 0; loop < 100; ++loop)
  {
    workers.clear();
    threads.For(2, 0, 1000,
      [&](std::int64_t, std::int64_t)
      {
        const std::lock_guard<std::mutex> guard(lock);
        workers.insert(std::this_thread::get_id());
      });
    alone += workers == std::set<std::thread::id>{ std::this_thread::get_id() };
  }
  EXPECT_GT(alone, 50);
}

TEST(LoopThreads, ThrowTheFirstException)
{
  LoopThreads threads;
  std::atomic<int> done(0);
  const auto fail = [&](std::int64_t begin, std::int64_t end)
  {
    Work(std::chrono::microseconds(20 * (end - begin)));
    done += static_cast<int>(end - begin);
    throw std::runtime_error("fails");
  };
  for (int loop = 0; loop < 20; ++loop)
  {
    done = 0;
    EXPECT_THROW(threads.For(3, 0, 50, fail), std::runtime_error);
    EXPECT_EQ(done, 50);
    EXPECT_EQ(CountItems(threads, 3, 50, 2), std::vector<int>(50, 1));
  }
}

TEST(LoopThreads, RunInnerLoopsOnOneThread)
{
  LoopThreads threads;
  std::vector<int> done(40 * 30, 0);
  threads.For(3, 0, 40,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const std::thread::id outer = std::this_thread::get_id();
        threads.For(3, 0, 30,
          [&](std::int64_t first, std::int64_t last)
          {
            EXPECT_EQ(std::this_thread::get_id(), outer);
            for (std::int64_t j = first; j < last; ++j)
            {
              Work(std::chrono::microseconds(3));
              ++done[30 * i + j];
            }
          });
      }
    });
  EXPECT_EQ(done, std::vector<int>(40 * 30, 1));
}
