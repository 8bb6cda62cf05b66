/**
 * FieldArray: an array that belongs to the mesh as a whole, with integers, reals or texts.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vfm
{

struct FieldArray
{
  std::string Name;
  std::variant<std::vector<int>, std::vector<Index>, std::vector<double>, std::vector<std::string>>
    Values; ///< shape (tuples, Components), row-major
  int Components = 1;
};

/// Returns an array with one tuple per row.
template <class Value, std::size_t Length>
FieldArray FieldOfRows(std::string name, const std::vector<std::array<Value, Length>>& rows)
{
  std::vector<Value> values;
  values.reserve(Length * rows.size());
  for (const std::array<Value, Length>& row : rows)
  {
    values.insert(values.end(), row.begin(), row.end());
  }
  return { std::move(name), std::move(values), static_cast<int>(Length) };
}

} // namespace vfm
