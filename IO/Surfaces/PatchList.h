/**
 * PatchList: numbers of the patches of a surface by their names.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

#include <map>

namespace vfm
{

/// Patches in the order in which a file names them first.
class PatchList
{
public:
  /// Returns the patch of a name. The first call with a name adds it.
  int Find(const std::string& name)
  {
    const auto [found, isNew] = this->Numbers.emplace(name, static_cast<int>(this->Numbers.size()));
    if (isNew)
    {
      this->Names.push_back(name);
    }
    return found->second;
  }
  /// Stores the names of the patches that have triangles, and renumbers the patches.
  void Finish(SurfaceFile& file) const;

private:
  std::map<std::string, int> Numbers;
  std::vector<std::string> Names;
};

} // namespace vfm
