/**
 * The processes that share a grid. The base class is the serial program: one rank, nothing to exchange.
 * MessageRanks is any number of them. Every call is collective unless it says otherwise.
 */
#pragma once

#include "Ranks/Errors.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace vfm
{

using Bytes = std::vector<char>;

class Ranks
{
public:
  virtual ~Ranks() = default;
  virtual int Rank() const { return 0; }
  virtual int Count() const { return 1; }

  /// Sends outgoing[i] to rank peers[i] and returns what peers[i] sent here. Peers are ascending and mutual; only the
  /// peers need to call.
  virtual std::vector<Bytes> Exchange(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
  {
    (void)peers;
    return outgoing;
  }
  /// What every rank gave, by rank, on all ranks.
  virtual std::vector<Bytes> Gather(const Bytes& mine) { return { mine }; }
  /// Sums over the ranks, element by element, in place.
  virtual void Sum(std::vector<std::int64_t>& values) { (void)values; }
  virtual double Max(double value) { return value; }

  bool Any(bool value) { return this->Max(value ? 1.0 : 0.0) > 0.0; }

  /// What is inside of what, from the outside in, where works on the same processes do not know each other: a program, what it does in
  /// turn, a filter as VTK runs it, and what it does.
  enum class Frame
  {
    Program,
    Stage,
    Filter,
    Inner
  };
  ///@{ For WorkTogether alone. Enter: false inside a frame. Leave: when all ranks do. Fail: throws on all ranks.
  virtual bool Enter(Frame frame) noexcept
  {
    (void)frame;
    return true;
  }
  virtual void Leave() {}
  [[noreturn]] virtual void Fail(const Failure& mine) { throw InputError(mine); }
  ///@}
};

template <class T>
Bytes ToBytes(const std::vector<T>& items)
{
  Bytes bytes(items.size() * sizeof(T));
  if (!items.empty())
  {
    std::memcpy(bytes.data(), items.data(), bytes.size());
  }
  return bytes;
}

template <class T>
std::vector<T> FromBytes(const Bytes& bytes)
{
  std::vector<T> items(bytes.size() / sizeof(T));
  if (!items.empty())
  {
    std::memcpy(items.data(), bytes.data(), bytes.size());
  }
  return items;
}

/// The items of some messages, one message after the other.
template <class T>
std::vector<T> JoinItems(const std::vector<Bytes>& messages)
{
  std::vector<T> all;
  for (const Bytes& bytes : messages)
  {
    const std::vector<T> items = FromBytes<T>(bytes);
    all.insert(all.end(), items.begin(), items.end());
  }
  return all;
}

/// The items of all ranks, in the order of the ranks.
template <class T>
std::vector<T> GatherItems(Ranks& ranks, const std::vector<T>& mine)
{
  return JoinItems<T>(ranks.Gather(ToBytes(mine)));
}

/// One message per list.
template <class T>
std::vector<Bytes> PackLists(const std::vector<std::vector<T>>& lists)
{
  std::vector<Bytes> messages;
  for (const std::vector<T>& list : lists)
  {
    messages.push_back(ToBytes(list));
  }
  return messages;
}

/// Sends lists[i] to rank peers[i] and returns the list that each peer sent here. Peers are as for Ranks::Exchange.
template <class T>
std::vector<std::vector<T>> ExchangeLists(
  Ranks& ranks, const std::vector<int>& peers, const std::vector<std::vector<T>>& lists)
{
  std::vector<std::vector<T>> received;
  for (const Bytes& message : ranks.Exchange(peers, PackLists(lists)))
  {
    received.push_back(FromBytes<T>(message));
  }
  return received;
}

/// The same; returns all items that came, in the order of the peers.
template <class T>
std::vector<T> ExchangeItems(
  Ranks& ranks, const std::vector<int>& peers, const std::vector<std::vector<T>>& lists)
{
  return JoinItems<T>(ranks.Exchange(peers, PackLists(lists)));
}

} // namespace vfm
