/**
 * Functions on sorted lists.
 */
#pragma once

#include <algorithm>
#include <cstdint>

namespace vfm
{

/// Sorts a list and removes duplicates.
template <class List>
void SortUnique(List& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Returns the position of an item in a sorted list, or -1 if the list does not contain it.
template <class List, class Item>
std::int64_t FindSorted(const List& items, const Item& item)
{
  const auto at = std::lower_bound(items.begin(), items.end(), item);
  return at != items.end() && *at == item ? at - items.begin() : -1;
}

/// Calls body(first, last) for each run of consecutive items that are equal.
/// @param isEqual  isEqual(first item of the run, other item) returns whether the item
///   belongs to the run
template <class Iterator, class IsEqual, class Body>
void ForRuns(Iterator begin, Iterator end, const IsEqual& isEqual, const Body& body)
{
  for (Iterator first = begin, last = begin; first != end; first = last)
  {
    last = std::find_if(first, end, [&](const auto& item) { return !isEqual(*first, item); });
    body(first, last);
  }
}

} // namespace vfm
