/// If a rank fails at any place, all ranks fail with its message, and all can continue afterwards.
#include "ThreadRanks.h"

#include "Ranks/WorkTogether.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Steps = 8;

/// Place where a rank throws: before a step, or after the last.
struct Fault
{
  int Rank = -1, Step = 0;
};

/// Work of the ranks in their own frame, which does not know frames around it.
using Body = std::function<void(Ranks& ranks)>;

void ThrowAt(const Ranks& ranks, int step, const std::vector<Fault>& faults)
{
  for (const Fault& fault : faults)
  {
    if (fault.Rank == ranks.Rank() && fault.Step == step)
    {
      throw InputError("rank " + std::to_string(fault.Rank) + " at " + std::to_string(step));
    }
  }
}

Bytes MakeMessage(int from, int to, int step)
{
  const std::size_t sizes[] = { 0, 8, 112, 113, 5000, Transport::LongestPiece + 1 };
  const int which = from + to + step;
  return Bytes(sizes[which % 12 == 5 ? 5 : which % 5], static_cast<char>(from + 3 * to + step));
}

void ExchangeInStep(Ranks& ranks, int step)
{
  std::vector<int> peers;
  std::vector<Bytes> outgoing;
  for (int other = 0; other < ranks.Count(); ++other)
  {
    if (other != ranks.Rank() && (other + ranks.Rank()) % 3 != step % 3)
    {
      peers.push_back(other);
      outgoing.push_back(MakeMessage(ranks.Rank(), other, step));
    }
  }
  const std::vector<Bytes> incoming = ranks.Exchange(peers, outgoing);
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    EXPECT_EQ(incoming[p], MakeMessage(peers[p], ranks.Rank(), step));
  }
}

void ReduceInStep(Ranks& ranks, int step)
{
  const int rank = ranks.Rank(), count = ranks.Count();
  if (step % 2 == 0)
  {
    std::vector<std::int64_t> sums{ rank, 1, step };
    ranks.Sum(sums);
    EXPECT_EQ(sums, (std::vector<std::int64_t>{ count * (count - 1) / 2, count, step * count }));
    EXPECT_EQ(ranks.Max(-rank), 0.0);
    return;
  }
  const std::vector<Bytes> all = ranks.Gather(MakeMessage(rank, rank, step));
  for (int other = 0; other < count; ++other)
  {
    EXPECT_EQ(all[other], MakeMessage(other, other, step));
  }
}

/// Exchanges all kinds of messages in turn.
void DoSteps(Ranks& ranks, const std::vector<Fault>& faults)
{
  for (int step = 0; step < Steps; ++step)
  {
    ThrowAt(ranks, step, faults);
    step % 3 == 2 ? ReduceInStep(ranks, step / 3) : ExchangeInStep(ranks, step);
  }
  ThrowAt(ranks, Steps, faults);
}

/// Returns the message with which the work ends on each rank; empty if it succeeds.
std::vector<std::string> RunTogether(ThreadHub& hub, Ranks::Frame frame, const Body& body)
{
  std::vector<std::string> messages(hub.Count);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < hub.Count; ++rank)
  {
    threads.emplace_back(
      [&, rank]
      {
        ThreadRanks ranks(hub, rank);
        try
        {
          WorkTogether(
            ranks, [&] { body(ranks); }, frame);
        }
        catch (const InputError& error)
        {
          messages[rank] = error.what();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return messages;
}

} // namespace

TEST(WorkTogether, OneRankFailsAnywhere)
{
  for (int count : { 1, 2, 3, 5 })
  {
    ThreadHub hub(count);
    for (int step = 0; step <= Steps; ++step)
    {
      const Fault fault{ step % count, step };
      for (const bool isFaulty : { true, false })
      {
        const std::vector<Fault> faults =
          isFaulty ? std::vector<Fault>{ fault } : std::vector<Fault>();
        const std::string expected =
          isFaulty ? "rank " + std::to_string(fault.Rank) + " at " + std::to_string(step) : "";
        EXPECT_EQ(
          RunTogether(hub, Ranks::Frame::Inner, [&](Ranks& ranks) { DoSteps(ranks, faults); }),
          std::vector<std::string>(count, expected));
      }
    }
  }
}

TEST(WorkTogether, SeveralRanksFail)
{
  constexpr int count = 5;
  ThreadHub hub(count);
  for (int step = 0; step <= Steps; ++step)
  {
    for (int other = step % 2; other <= Steps; other += 2)
    {
      const std::vector<Fault> faults{ { 1, step }, { 3, other } };
      const auto run = [&] {
        return RunTogether(hub, Ranks::Frame::Inner, [&](Ranks& ranks) { DoSteps(ranks, faults); });
      };
      const std::vector<std::string> messages = run();
      EXPECT_EQ(messages, std::vector<std::string>(count, messages[0]));
      EXPECT_EQ(messages, run()) << "the same in every run";
      if (step == other)
      {
        EXPECT_EQ(messages[0], "rank 1 at " + std::to_string(step));
      }
    }
  }
}

/// Frames lie inside others that they do not know, as with another library. The filters
/// swallow their errors, as VTK does.
TEST(WorkTogether, FramesInsideOfOthers)
{
  constexpr int count = 4, filters = 3;
  ThreadHub hub(count);
  for (int place = 0; place <= filters; ++place) // before this filter, or after the last
  {
    for (int step = -1; step <= Steps; ++step) // -1: outside the filter's frame
    {
      const Fault fault{ (place + step + 1) % count, step };
      std::vector<int> failed(count, 0);
      const std::vector<std::string> messages = RunTogether(hub, Ranks::Frame::Stage,
        [&](Ranks& outer)
        {
          for (int filter = 0; filter < filters; ++filter)
          {
            const std::vector<Fault> faults =
              filter == place ? std::vector<Fault>{ fault } : std::vector<Fault>();
            ThrowAt(outer, -1, faults);
            ThreadRanks inner(hub, outer.Rank());
            try
            {
              WorkTogether(inner, [&] { DoSteps(inner, faults); });
            }
            catch (const InputError&)
            {
              ++failed[outer.Rank()];
            }
          }
          if (place == filters && fault.Rank == outer.Rank())
          {
            throw InputError("after all");
          }
        });
      const std::string expected = place == filters ? "after all"
        : step < 0 ? "rank " + std::to_string(fault.Rank) + " at -1"
                   : "";
      EXPECT_EQ(messages, std::vector<std::string>(count, expected)) << place << " " << step;
      const int left = place < filters && step < 0 ? filters - place : place < filters;
      for (int rank = 0; rank < count; ++rank)
      {
        const bool threwOutside = step < 0 && rank == fault.Rank;
        EXPECT_EQ(failed[rank], threwOutside ? 0 : left) << place << " " << step << " " << rank;
      }
    }
  }
}

/// A rank misses a collective step of the others because it failed in code that does not report. No
/// rank waits for it, and its later messages are not taken for messages of that step.
TEST(WorkTogether, FailuresThatAreNotReported)
{
  for (int count : { 2, 3, 5 })
  {
    ThreadHub hub(count);
    for (int missing = 0; missing < count; ++missing)
    {
      // true: to another step of the outer frame; false: to its end
      for (const bool goesOn : { false, true })
      {
        const auto run = [&](bool isMissing)
        {
          return RunTogether(hub, Ranks::Frame::Stage,
            [&](Ranks& outer)
            {
              ThreadRanks inner(hub, outer.Rank());
              try
              {
                if (!isMissing || outer.Rank() != missing)
                {
                  WorkTogether(inner, [&] { DoSteps(inner, {}); });
                }
              }
              catch (const InputError&)
              {
              }
              if (goesOn)
              {
                outer.Max(0.0);
              }
            });
        };
        const std::vector<std::string> messages = run(true);
        EXPECT_NE(messages[0].find("different collective steps"), std::string::npos) << messages[0];
        EXPECT_EQ(messages, std::vector<std::string>(count, messages[0]));
        EXPECT_EQ(run(false), std::vector<std::string>(count, "")) << "all can go on afterwards";
      }
    }
  }
}

TEST(WorkTogether, AnyExceptionAndOnlyOnce)
{
  ThreadHub hub(3);
  const auto run = [&](const Body& body) { return RunTogether(hub, Ranks::Frame::Inner, body); };
  const auto all = [](const char* text) { return std::vector<std::string>(3, text); };
  EXPECT_EQ(run(
              [](Ranks& ranks)
              {
                if (ranks.Rank() == 2)
                {
                  throw std::bad_alloc();
                }
              }),
    all("Not enough memory on rank 2."));
  EXPECT_EQ(run(
              [](Ranks& ranks)
              {
                if (ranks.Rank() == 1)
                {
                  throw 5;
                }
                ranks.Max(0.0);
              }),
    all("An unknown failure."));
  // Nested work of the same ranks does not open its own frame.
  EXPECT_EQ(run(
              [](Ranks& ranks)
              {
                WorkTogether(ranks, [&] { ThrowAt(ranks, 0, { { 1, 0 } }); });
                ranks.Gather(Bytes());
              }),
    all("rank 1 at 0"));
  EXPECT_EQ(run([](Ranks& ranks) { EXPECT_TRUE(ranks.Any(ranks.Rank() == 1)); }), all(""));
}

TEST(WorkTogether, LongTextsAreCut)
{
  Ranks alone;
  try
  {
    WorkTogether(alone, [] { throw InputError(std::string(5000, 'x')); });
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(error.what(), std::string(Failure::LongestText - 1, 'x'));
  }
}
