/**
 * Ranks that are threads of one process: the same pipeline as under MPI, without it.
 */
#pragma once

#include "Ranks.h"

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
  std::vector<Bytes> Gather(const Bytes& mine) override
  {
    return this->Hub.Gather(this->Mine, mine);
  }
  void Sum(std::vector<std::int64_t>& values) override;
  double Max(double value) override;

private:
  ThreadHub& Hub;
  int Mine;
};

/// Runs body(ranks) on count threads at once.
void RunOnRanks(int count, const std::function<void(Ranks&)>& body);

} // namespace testing
} // namespace vfm
