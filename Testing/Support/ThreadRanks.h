/**
 * Ranks that are threads of one process: the same pipeline as under MPI, without it.
 */
#pragma once

#include "Base/Ranks.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>

namespace vfm
{
namespace testing
{

/// Where the ranks meet.
class ThreadHub
{
public:
  explicit ThreadHub(int count) : Count(count), Slots(count) {}

  void Put(int from, int to, const Bytes& bytes);
  Bytes Take(int from, int to);
  std::vector<Bytes> Gather(int rank, const Bytes& mine);

  const int Count;

private:
  std::mutex Lock;
  std::condition_variable Changed;
  std::map<std::pair<int, int>, std::deque<Bytes>> Mail;
  std::vector<Bytes> Slots, Complete;
  int Arrived = 0, Round = 0;
};

class ThreadRanks : public Ranks
{
public:
  ThreadRanks(ThreadHub& hub, int rank) : Hub(hub), Mine(rank) {}
  int Rank() const override { return this->Mine; }
  int Count() const override { return this->Hub.Count; }
  std::vector<Bytes> Exchange(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing) override;
  std::vector<Bytes> Gather(const Bytes& mine) override;
  void Sum(std::vector<std::int64_t>& values) override;
  double Max(double value) override;

  /// What this rank sent so far. A gather counts with what it brings in.
  struct Traffic
  {
    std::int64_t Messages = 0, MessageBytes = 0, Reductions = 0, Gathers = 0, GatheredBytes = 0;
  };
  const Traffic& Sent() const { return this->Counted; }

private:
  ThreadHub& Hub;
  int Mine;
  Traffic Counted;
};

/// Runs body(ranks) on count threads at once. Throws what the lowest rank threw, once all have ended.
void RunOnRanks(int count, const std::function<void(ThreadRanks&)>& body);

} // namespace testing
} // namespace vfm
