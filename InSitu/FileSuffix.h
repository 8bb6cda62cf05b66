/**
 * FileSuffix: the ends of file names, in lower or upper case.
 */
#pragma once

#include "ParseText.h"

#include <string>

namespace vfm
{

/// suffix: with its dot.
inline bool HasSuffix(const std::string& path, const std::string& suffix)
{
  return path.size() > suffix.size() &&
    IsSameWord(path.substr(path.size() - suffix.size()), suffix);
}

} // namespace vfm
