/**
 * FileSuffix: tests of the suffix of a file name, in lower or upper case.
 */
#pragma once

#include "Base/ParseText.h"

#include <algorithm>
#include <string>
#include <vector>

namespace vfm
{

/// Tests whether a path ends with a suffix, in lower or upper case.
/// @param suffix  suffix with its dot, in lower case
inline bool HasSuffix(const std::string& path, const std::string& suffix)
{
  return path.size() > suffix.size() &&
    std::equal(suffix.rbegin(), suffix.rend(), path.rbegin(),
      [](char requested, char given) { return requested == ToLower(given); });
}

/// Tests whether a path ends with any of the suffixes.
inline bool HasSuffix(const std::string& path, const std::vector<std::string>& suffixes)
{
  return std::any_of(suffixes.begin(), suffixes.end(),
    [&path](const std::string& suffix) { return HasSuffix(path, suffix); });
}

} // namespace vfm
