/**
 * FindMaterial: materials that the user selects by names or ids.
 */
#pragma once

#include "Base/ParseText.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

namespace vfm
{

/// Names of materials by id.
using NamesById = std::map<int, std::string>;

/// Returns the id of the material with a name, else the material of an id, or nothing.
inline std::optional<int> FindMaterial(const std::string& text, const NamesById& names)
{
  const auto named = std::find_if(
    names.begin(), names.end(), [&text](const auto& material) { return material.second == text; });
  if (named != names.end())
  {
    return named->first;
  }
  const std::optional<int> id = ParseCount(text, 0, std::numeric_limits<int>::max());
  return id && names.count(*id) > 0 ? id : std::nullopt;
}

/// Returns all names with their ids, for messages.
inline std::string ListMaterials(const NamesById& names)
{
  std::vector<std::string> texts;
  for (const auto& [id, name] : names)
  {
    texts.push_back(name + " (" + std::to_string(id) + ")");
  }
  return JoinTexts(texts);
}

} // namespace vfm
