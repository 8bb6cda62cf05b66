/**
 * KeyMerge: combines the values that several ranks have for the same key, in log2 P messages per
 * rank, whoever has the key.
 *
 * Each key travels to a rank of its own, its home, along the edges of a hypercube of ranks: one bit
 * of the number of the rank after the other. Equal keys that meet are merged there, so no rank
 * receives more than one message per bit, even if all ranks have a key. The way is stored, and
 * values of any kind travel along it, there and back.
 *
 *      rank 3 (11) --- bit 0 ---> rank 2 (10) --- bit 1 ---> rank 0 (00), the home
 *      rank 1 (01) --- bit 0 ---> rank 0 (00) ------------------^
 */
#pragma once

#include "Ranks/MeetingRank.h"
#include "Ranks/Ranks.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace vfm
{

/// Returns the number of ranks that can be homes: the largest power of two that is at most the
/// number of ranks. Not collective.
inline int CountHomes(const Ranks& ranks)
{
  int homes = 1;
  while (homes <= ranks.Count() / 2)
  {
    homes *= 2;
  }
  return homes;
}

/// Homes of keys by their first part only: keys that begin with the same number, such as that of an
/// island or a component, have one home.
class HomeOfFirst
{
public:
  explicit HomeOfFirst(const Ranks& ranks) : Homes(CountHomes(ranks)) {}
  template <std::size_t Length>
  int operator()(const std::array<std::int64_t, Length>& key) const
  {
    return MeetingRank(key[0], this->Homes);
  }

private:
  int Homes;
};

/// Returns the places of keys in ascending order.
template <class Key>
std::vector<std::size_t> OrderOf(const std::vector<Key>& keys)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (!std::is_sorted(keys.begin(), keys.end()))
  {
    std::sort(order.begin(), order.end(),
      [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  }
  return order;
}

/// Ways of the keys of all ranks to their homes and back. The ranks must outlive it. On a single
/// rank it copies and sends nothing.
/// @tparam Key  trivially copyable, with operators < and ==
template <class Key>
class KeyMerge
{
public:
  KeyMerge() = default;
  /// Finds the ways.
  /// @param keys  keys of this rank, ascending, each once
  /// @param home  home(key) is a number below CountHomes, the same on all ranks
  /// @pre Collective over `ranks`.
  template <class Home>
  KeyMerge(std::vector<Key> keys, const Home& home, Ranks& ranks) : Group(&ranks)
  {
    const int homes = CountHomes(ranks), rank = ranks.Rank();
    if (rank >= homes) // it gives all keys to its partner
    {
      keys = this->AddStage(rank - homes, keys, [](const Key&) { return true; });
    }
    else if (rank + homes < ranks.Count())
    {
      keys = this->AddStage(rank + homes, keys, [](const Key&) { return false; });
    }
    for (int bit = 1; rank < homes && bit < homes; bit *= 2)
    {
      keys = this->AddStage(
        rank ^ bit, keys, [&](const Key& key) { return ((home(key) ^ rank) & bit) != 0; });
    }
    this->AtHome = std::move(keys);
  }
  /// Finds the ways to homes from a hash of the keys.
  /// @pre As above; MeetingRank takes the type of keys.
  KeyMerge(std::vector<Key> keys, Ranks& ranks) :
    KeyMerge(
      std::move(keys),
      [homes = CountHomes(ranks)](const Key& key) { return MeetingRank(key, homes); }, ranks)
  {
  }

  /// Returns the keys of all ranks whose home is this rank, ascending.
  const std::vector<Key>& HomeKeys() const { return this->AtHome; }

  /// Sends values to the homes of their keys.
  /// @param values  `width` values per key of this rank, trivially copyable
  /// @param join  join(a, b) combines value b into a; commutative and associative
  /// @return `width` values per key of HomeKeys
  /// @pre Collective.
  template <class T, class Join>
  std::vector<T> ToHome(std::vector<T> values, std::size_t width, const Join& join) const
  {
    for (const Stage& stage : this->Stages)
    {
      const std::vector<T> received = this->Swap(stage.Partner, Pick(values, stage.Sent, width));
      std::vector<T> next(width * stage.Next);
      Put(Pick(values, stage.Kept, width), stage.KeptTo, width, next);
      for (std::size_t i = 0; i < received.size(); ++i)
      {
        T& to = next[width * stage.ReceivedTo[i / width] + i % width];
        if (stage.IsNew[i / width])
        {
          to = received[i];
        }
        else
        {
          join(to, received[i]);
        }
      }
      values = std::move(next);
    }
    return values;
  }

  /// Sends values from the homes of their keys to all ranks that have the keys.
  /// @param values  `width` values per key of HomeKeys, trivially copyable
  /// @return `width` values per key of this rank
  /// @pre Collective.
  template <class T>
  std::vector<T> FromHome(std::vector<T> values, std::size_t width) const
  {
    for (auto stage = this->Stages.rbegin(); stage != this->Stages.rend(); ++stage)
    {
      const std::vector<T> received =
        this->Swap(stage->Partner, Pick(values, stage->ReceivedTo, width));
      std::vector<T> before(width * (stage->Sent.size() + stage->Kept.size()));
      Put(Pick(values, stage->KeptTo, width), stage->Kept, width, before);
      Put(received, stage->Sent, width, before);
      values = std::move(before);
    }
    return values;
  }

  /// Replaces the values of each key by their combination over all ranks that have the key.
  /// @param values  `width` values per key of this rank, trivially copyable
  /// @param join  as in ToHome
  /// @pre Collective.
  template <class T, class Join>
  void Merge(std::vector<T>& values, std::size_t width, const Join& join) const
  {
    values = this->FromHome(this->ToHome(std::move(values), width, join), width);
  }

private:
  /// Exchange with one rank. Keys are positions in the list before or after it.
  struct Stage
  {
    int Partner;
    std::vector<int> Sent, Kept;         // before
    std::vector<int> KeptTo, ReceivedTo; // after
    std::vector<unsigned char> IsNew;    // whether each received key was not kept here too
    std::size_t Next;                    // number of keys after it
  };

  /// Returns the keys after an exchange with a rank.
  template <class IsSent>
  std::vector<Key> AddStage(int partner, const std::vector<Key>& keys, const IsSent& isSent)
  {
    Stage stage{ partner, {}, {}, {}, {}, {}, 0 };
    std::vector<Key> sent, kept;
    for (std::size_t k = 0; k < keys.size(); ++k)
    {
      const bool goes = isSent(keys[k]);
      (goes ? stage.Sent : stage.Kept).push_back(static_cast<int>(k));
      (goes ? sent : kept).push_back(keys[k]);
    }
    const std::vector<Key> received = this->Swap(partner, sent);
    std::vector<Key> next;
    next.reserve(kept.size() + received.size());
    std::set_union(
      kept.begin(), kept.end(), received.begin(), received.end(), std::back_inserter(next));
    stage.KeptTo = FindPlaces(kept, next);
    stage.ReceivedTo = FindPlaces(received, next);
    std::vector<unsigned char> isKept(next.size(), 0);
    for (int place : stage.KeptTo)
    {
      isKept[place] = 1;
    }
    for (int place : stage.ReceivedTo)
    {
      stage.IsNew.push_back(!isKept[place]);
    }
    stage.Next = next.size();
    this->Stages.push_back(std::move(stage));
    return next;
  }

  /// Returns the places of keys in a list that contains them; both are ascending.
  static std::vector<int> FindPlaces(const std::vector<Key>& keys, const std::vector<Key>& list)
  {
    std::vector<int> places;
    places.reserve(keys.size());
    std::size_t at = 0;
    for (const Key& key : keys)
    {
      while (list[at] < key)
      {
        ++at;
      }
      places.push_back(static_cast<int>(at));
    }
    return places;
  }

  template <class T>
  std::vector<T> Swap(int partner, const std::vector<T>& items) const
  {
    return FromBytes<T>(this->Group->Exchange({ partner }, { ToBytes(items) })[0]);
  }

  template <class T>
  static std::vector<T> Pick(
    const std::vector<T>& values, const std::vector<int>& places, std::size_t width)
  {
    std::vector<T> picked;
    picked.reserve(width * places.size());
    for (int place : places)
    {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(width * place);
      picked.insert(picked.end(), first, first + static_cast<std::ptrdiff_t>(width));
    }
    return picked;
  }

  template <class T>
  static void Put(const std::vector<T>& values, const std::vector<int>& places, std::size_t width,
    std::vector<T>& to)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(width * i), width,
        to.begin() + static_cast<std::ptrdiff_t>(width * places[i]));
    }
  }

  Ranks* Group = nullptr;
  std::vector<Stage> Stages;
  std::vector<Key> AtHome;
};

} // namespace vfm
