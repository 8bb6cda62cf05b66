/**
 * EntityNumbers: numbers over all ranks of the surfaces, curves or vertices that one rank touches.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Base/Sorted.h"
#include "Ranks/NumberLimit.h"
#include "Ranks/NumberOwnedKeys.h"

#include <utility>

namespace vfm
{

/// Keys of entities of one rank, ascending, each once.
template <class Key>
struct EntityKeys
{
  std::vector<Key> Keys;
  std::vector<unsigned char> IsOwned; ///< whether this rank owns a part of the entity

  EntityKeys() = default;
  /// @param items  keys and whether this rank owns a part of the entity; in any order, repeated
  explicit EntityKeys(std::vector<std::pair<Key, bool>> items)
  {
    std::sort(items.begin(), items.end());
    for (std::pair<Key, bool>& item : items)
    {
      if (this->Keys.empty() || this->Keys.back() != item.first)
      {
        this->Keys.push_back(std::move(item.first));
        this->IsOwned.push_back(0);
      }
      this->IsOwned.back() |= item.second ? 1 : 0;
    }
  }
};

/// Entities that one rank touches, ascending by key and by number. Parts that ranks see at their
/// border may have keys that no rank owns; they are no entities.
template <class Key>
struct EntityNumbers
{
  std::vector<Key> Keys;
  std::vector<int> Ids;                ///< number over all ranks of each key, from 1
  std::vector<unsigned char> IsShared; ///< whether other ranks touch the entity too
  Index Total = 0;                     ///< number of entities of all ranks

  EntityNumbers() = default;
  /// @param keys  ascending, each once
  /// @param numbers  of the keys
  /// @param things  plural, such as "surfaces"
  /// @throws InputError  on all ranks if 32 bits cannot number the entities
  EntityNumbers(std::vector<Key> keys, const OwnedKeyNumbers& numbers, const char* things) :
    Total(numbers.Total)
  {
    CheckNumberLimit(numbers.Total, things);
    for (std::size_t k = 0; k < keys.size(); ++k)
    {
      if (numbers.Numbers[k] >= 0)
      {
        this->Keys.push_back(std::move(keys[k]));
        this->Ids.push_back(static_cast<int>(numbers.Numbers[k]) + 1);
        this->IsShared.push_back(numbers.IsShared[k]);
      }
    }
  }

  /// Returns the row of a key, or -1 if it is no entity.
  Index FindRow(const Key& key) const { return FindSorted(this->Keys, key); }
  /// Returns the number of an entity, or 0 if it is none.
  int Find(const Key& key) const
  {
    const Index row = this->FindRow(key);
    return row < 0 ? 0 : this->Ids[row];
  }
};

/// Rows of one rank of which other ranks have some too, and the ways to combine their values.
class SharedRows
{
public:
  /// @param ids  number over all ranks of each row, ascending
  /// @param isShared  whether other ranks have the row too
  /// @pre Collective.
  SharedRows(
    const std::vector<int>& ids, const std::vector<unsigned char>& isShared, Ranks& ranks) :
    Rows(ListRows(isShared)), Ways(Pick(ids, Rows), ranks)
  {
  }

  /// Replaces the values of each row by their combination over all ranks that have it.
  /// @param values  `width` values per row, trivially copyable
  /// @param join  as for KeyMerge
  /// @pre Collective.
  template <class T, class Join>
  void Merge(std::vector<T>& values, std::size_t width, const Join& join) const
  {
    std::vector<T> shared;
    shared.reserve(width * this->Rows.size());
    for (Index row : this->Rows)
    {
      std::copy_n(values.begin() + width * row, width, std::back_inserter(shared));
    }
    this->Ways.Merge(shared, width, join);
    for (std::size_t s = 0; s < this->Rows.size(); ++s)
    {
      std::copy_n(shared.begin() + width * s, width, values.begin() + width * this->Rows[s]);
    }
  }

private:
  static std::vector<Index> ListRows(const std::vector<unsigned char>& isShared)
  {
    std::vector<Index> rows;
    for (std::size_t row = 0; row < isShared.size(); ++row)
    {
      if (isShared[row])
      {
        rows.push_back(static_cast<Index>(row));
      }
    }
    return rows;
  }
  static std::vector<Index> Pick(const std::vector<int>& ids, const std::vector<Index>& rows)
  {
    std::vector<Index> picked;
    for (Index row : rows)
    {
      picked.push_back(ids[row]);
    }
    return picked;
  }

  std::vector<Index> Rows;
  KeyMerge<Index> Ways;
};

/// Numbers sets over all ranks, in lexicographic order. Sets may have any length.
/// @param sets  ascending numbers from 1 to `largest`
/// @throws InputError  on all ranks if 32 bits cannot number them
/// @pre Collective.
EntityNumbers<std::vector<int>> NumberSets(
  EntityKeys<std::vector<int>> sets, Index largest, const char* things, Ranks& ranks);

} // namespace vfm
