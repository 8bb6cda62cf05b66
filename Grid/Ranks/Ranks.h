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
  [[noreturn]] virtual void Fail(const Failure& mine) { throw FailedTogether(mine); }
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

/// The items of all ranks, in the order of the ranks.
template <class T>
std::vector<T> GatherItems(Ranks& ranks, const std::vector<T>& mine)
{
  std::vector<T> all;
  for (const Bytes& bytes : ranks.Gather(ToBytes(mine)))
  {
    const std::vector<T> items = FromBytes<T>(bytes);
    all.insert(all.end(), items.begin(), items.end());
  }
  return all;
}

} // namespace vfm
