/**
 * FieldArray: numbers or texts that tell of a mesh as a whole.
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
    Values; ///< tuple by tuple
  int Components = 1;
};

/// One of so many components as rows have.
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
