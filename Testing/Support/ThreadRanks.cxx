#include "ThreadRanks.h"

#include <exception>
#include <thread>

namespace vfm
{
namespace testing
{

void ThreadHub::Put(int to, int from, Transport::Transfer& transfer) noexcept
{
  Box& box = this->BoxOf(to, from);
  const std::lock_guard<std::mutex> guard(box.Lock);
  (box.First ? box.Last->Next : box.First) = &transfer;
  box.Last = &transfer;
  box.Changed.notify_all();
}

void ThreadHub::WaitForTaken(int to, int from, Transport::Transfer& transfer) noexcept
{
  Box& box = this->BoxOf(to, from);
  std::unique_lock<std::mutex> guard(box.Lock);
  box.Changed.wait(guard, [&] { return transfer.IsDone; });
}

void ThreadHub::Take(int to, int from, Transport::Transfer& transfer) noexcept
{
  Box& box = this->BoxOf(to, from);
  std::unique_lock<std::mutex> guard(box.Lock);
  box.Changed.wait(guard, [&] { return box.First; });
  Transport::Transfer& sent = *box.First;
  if (sent.Size != transfer.Size)
  {
    std::terminate(); // the ranks disagree on the sequence of messages
  }
  if (transfer.Data && transfer.Size > 0)
  {
    std::memcpy(transfer.Data, sent.Data, sent.Size);
  }
  box.First = sent.Next;
  sent.IsDone = true;
  box.Changed.notify_all();
}

bool ThreadHub::HasAny(int to, int from) noexcept
{
  Box& box = this->BoxOf(to, from);
  const std::lock_guard<std::mutex> guard(box.Lock);
  return box.First;
}

void ThreadTransport::Begin(Transfer& transfer) noexcept
{
  if (transfer.IsSent)
  {
    this->Hub.Put(transfer.Other, this->Self, transfer);
  }
}

void ThreadTransport::Wait(Transfer& transfer) noexcept
{
  if (transfer.IsSent)
  {
    this->Hub.WaitForTaken(transfer.Other, this->Self, transfer);
  }
  else
  {
    this->Hub.Take(this->Self, transfer.Other, transfer);
  }
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
