/**
 * Sorted lists.
 */
#pragma once

#include <algorithm>
#include <cstdint>

namespace vfm
{

/// Sorts a list and leaves one of equal items.
template <class List>
void SortUnique(List& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// The position of an item in a sorted list, or -1.
template <class List, class Item>
std::int64_t FindSorted(const List& items, const Item& item)
{
  const auto at = std::lower_bound(items.begin(), items.end(), item);
  return at != items.end() && *at == item ? at - items.begin() : -1;
}

/// Calls body(first, last) for the runs of items that alike(first item, other item) tells to belong together.
template <class Iterator, class IsEqual, class Body>
void ForRuns(Iterator begin, Iterator end, const IsEqual& alike, const Body& body)
{
  for (Iterator first = begin, last = begin; first != end; first = last)
  {
    last = std::find_if(first, end, [&](const auto& item) { return !alike(*first, item); });
    body(first, last);
  }
}

} // namespace vfm
