#include "ThreadRanks.h"

#include <algorithm>
#include <exception>
#include <thread>

namespace vfm
{
namespace testing
{

void ThreadHub::Put(int from, int to, const Bytes& bytes)
{
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->Mail[{ from, to }].push_back(bytes);
  this->Changed.notify_all();
}

Bytes ThreadHub::Take(int from, int to)
{
  std::unique_lock<std::mutex> guard(this->Lock);
  std::deque<Bytes>& mail = this->Mail[{ from, to }];
  this->Changed.wait(guard, [&] { return !mail.empty(); });
  Bytes bytes = mail.front();
  mail.pop_front();
  return bytes;
}

std::vector<Bytes> ThreadHub::Gather(int rank, const Bytes& mine)
{
  std::unique_lock<std::mutex> guard(this->Lock);
  const int round = this->Round;
  this->Slots[rank] = mine;
  if (++this->Arrived == this->Count)
  {
    this->Complete = this->Slots;
    this->Arrived = 0;
    ++this->Round;
    this->Changed.notify_all();
  }
  this->Changed.wait(guard, [&] { return this->Round != round; });
  return this->Complete;
}

std::vector<Bytes> ThreadRanks::Exchange(
  const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
{
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    ++this->Counted.Messages;
    this->Counted.MessageBytes += static_cast<std::int64_t>(outgoing[p].size());
    this->Hub.Put(this->Mine, peers[p], outgoing[p]);
  }
  std::vector<Bytes> incoming;
  for (int peer : peers)
  {
    incoming.push_back(this->Hub.Take(peer, this->Mine));
  }
  return incoming;
}

std::vector<Bytes> ThreadRanks::Gather(const Bytes& mine)
{
  std::vector<Bytes> all = this->Hub.Gather(this->Mine, mine);
  ++this->Counted.Gathers;
  for (const Bytes& bytes : all)
  {
    this->Counted.GatheredBytes += static_cast<std::int64_t>(bytes.size());
  }
  return all;
}

void ThreadRanks::Sum(std::vector<std::int64_t>& values)
{
  ++this->Counted.Reductions;
  std::vector<std::int64_t> sums(values.size(), 0);
  for (const Bytes& bytes : this->Hub.Gather(this->Mine, ToBytes(values)))
  {
    const std::vector<std::int64_t> items = FromBytes<std::int64_t>(bytes);
    std::transform(
      sums.begin(), sums.end(), items.begin(), sums.begin(), std::plus<std::int64_t>());
  }
  values = sums;
}

double ThreadRanks::Max(double value)
{
  ++this->Counted.Reductions;
  double largest = value;
  for (const Bytes& bytes : this->Hub.Gather(this->Mine, ToBytes(std::vector<double>{ value })))
  {
    largest = std::max(largest, FromBytes<double>(bytes)[0]);
  }
  return largest;
}

void RunOnRanks(int count, const std::function<void(ThreadRanks&)>& body)
{
  ThreadHub hub(count);
  std::vector<std::thread> threads;
  std::vector<std::exception_ptr> thrown(count);
  for (int rank = 0; rank < count; ++rank)
  {
    threads.emplace_back(
      [&hub, &body, &thrown, rank]
      {
        try
        {
          ThreadRanks ranks(hub, rank);
          body(ranks);
        }
        catch (...)
        {
          thrown[rank] = std::current_exception();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::exception_ptr& error : thrown)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
}

} // namespace testing
} // namespace vfm
