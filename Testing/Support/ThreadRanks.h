/**
 * Ranks that are threads of one process: the same pipeline as under MPI, without MPI. A message
 * waits until it is received, as large messages do under MPI.
 */
#pragma once

#include "Ranks/MessageRanks.h"

#include <condition_variable>
#include <functional>
#include <mutex>

namespace vfm
{
namespace testing
{

/// Connects the transports of all ranks.
class ThreadHub
{
public:
  explicit ThreadHub(int count) : Count(count), Boxes(count * count) {}

  void Put(int to, int from, Transport::Transfer& transfer) noexcept;
  void WaitForTaken(int to, int from, Transport::Transfer& transfer) noexcept;
  void Take(int to, int from, Transport::Transfer& transfer) noexcept;
  bool HasAny(int to, int from) noexcept;

  const int Count;

private:
  /// Messages from one rank to another that are not received yet.
  struct Box
  {
    std::mutex Lock;
    std::condition_variable Changed;
    Transport::Transfer *First = nullptr, *Last = nullptr;
  };
  Box& BoxOf(int to, int from) { return this->Boxes[to * this->Count + from]; }

  std::vector<Box> Boxes;
};

class ThreadTransport : public Transport
{
public:
  ThreadTransport(ThreadHub& hub, int rank) : Hub(hub), Self(rank) {}
  void Begin(Transfer& transfer) noexcept override;
  void Wait(Transfer& transfer) noexcept override;
  bool HasArrived(int from) noexcept override { return this->Hub.HasAny(this->Self, from); }

private:
  ThreadHub& Hub;
  int Self;
};

class ThreadRanks : private ThreadTransport, public MessageRanks
{
public:
  ThreadRanks(ThreadHub& hub, int rank) :
    ThreadTransport(hub, rank), MessageRanks(*this, rank, hub.Count)
  {
  }
};

/// Runs body(ranks) on count threads. After all have ended, throws the exception
/// of the lowest rank that failed.
void RunOnRanks(int count, const std::function<void(ThreadRanks&)>& body);

} // namespace testing
} // namespace vfm
