/**
 * Ranks: the interface to the ranks that share a grid, and functions that exchange lists.
 */
#pragma once

#include "Ranks/Errors.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace vfm
{

using Bytes = std::vector<char>;

/// Group of ranks. The base class is a single rank without communication; MessageRanks is a
/// group of any number of ranks. Every call is collective unless stated otherwise. One thread of
/// each rank may call.
class Ranks
{
public:
  virtual ~Ranks() = default;
  /// Returns the number of this rank, from 0. Not collective.
  virtual int Rank() const { return 0; }
  /// Returns the number of ranks. Not collective.
  virtual int Count() const { return 1; }

  /// Sends outgoing[i] to rank peers[i] and returns the message received from each peer.
  /// @param peers  ascending ranks other than this one; if a is a peer of b, b is a peer of a
  /// @pre Collective among peers; other ranks need not call.
  virtual std::vector<Bytes> Exchange(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
  {
    (void)peers;
    return outgoing;
  }
  /// Returns the bytes that each rank passes, in the order of ranks, on all ranks.
  virtual std::vector<Bytes> Gather(const Bytes& mine) { return { mine }; }
  /// Replaces each value by its sum over all ranks. All ranks pass the same number of values.
  virtual void Sum(std::vector<std::int64_t>& values) { (void)values; }
  /// Replaces each value by its maximum over all ranks. All ranks pass the same number of values.
  virtual void Max(std::vector<double>& values) { (void)values; }

  /// Returns the maximum over all ranks.
  double Max(double value)
  {
    std::vector<double> values{ value };
    this->Max(values);
    return values[0];
  }

  /// Returns whether the value is true on at least one rank.
  bool Any(bool value) { return this->Max(value ? 1.0 : 0.0) > 0.0; }

  /// Kinds of frames, from the outermost to the innermost. A frame is a piece of collective work
  /// with common error handling (WorkTogether.h). Frames of different groups of the same ranks may
  /// nest, even if the libraries that open them do not know of each other.
  enum class Frame
  {
    Program, ///< a whole program
    Stage,   ///< a step of a program or host
    Filter,  ///< a filter as VTK runs it
    Inner    ///< a step inside a filter
  };
  ///@{ Only for WorkTogether.
  /// Enter begins a frame. Inside another frame of this group it does nothing and returns false.
  /// Leave ends the frame after all ranks have called it. Fail ends the frame with an error: all
  /// ranks throw the same error.
  virtual bool Enter(Frame frame) noexcept
  {
    (void)frame;
    return true;
  }
  virtual void Leave() {}
  [[noreturn]] virtual void Fail(const Failure& mine) { throw InputError(mine); }
  ///@}
};

/// Returns the bytes of a list.
/// @tparam T  trivially copyable type
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

/// Returns the list from its bytes (ToBytes).
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

/// Returns the items of several messages (ToBytes) in one list, in the order of the messages.
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

/// Returns the items of all ranks, in the order of the ranks.
/// @pre Collective over `ranks`.
template <class T>
std::vector<T> GatherItems(Ranks& ranks, const std::vector<T>& mine)
{
  return JoinItems<T>(ranks.Gather(ToBytes(mine)));
}

/// Returns one message per list (ToBytes).
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

/// Sends lists[i] to rank peers[i] and returns all items received, in the order of the peers.
/// @pre Collective among peers.
template <class T>
std::vector<T> ExchangeItems(
  Ranks& ranks, const std::vector<int>& peers, const std::vector<std::vector<T>>& lists)
{
  return JoinItems<T>(ranks.Exchange(peers, PackLists(lists)));
}

} // namespace vfm
