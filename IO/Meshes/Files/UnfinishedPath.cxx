#include "Meshes/Files/UnfinishedPath.h"

#include <algorithm>
#include <unistd.h>
#include <vector>

namespace vfm
{
namespace
{

struct List
{
  std::recursive_mutex Mutex;
  std::vector<const UnfinishedPath*> Paths;
};

/// Returns the list, which is never destroyed, because a thread may use it until the process ends.
List& GetList()
{
  static List* const list = new List;
  return *list;
}

} // namespace

UnfinishedPath::UnfinishedPath(std::string path, Kind kind) :
  ThePath(std::move(path)), TheKind(kind)
{
  const auto held = HoldUnfinishedPaths();
  GetList().Paths.push_back(this);
}

UnfinishedPath::~UnfinishedPath()
{
  const auto held = HoldUnfinishedPaths();
  if (!this->IsKept)
  {
    this->Remove();
    this->Keep();
  }
}

void UnfinishedPath::Keep()
{
  const auto held = HoldUnfinishedPaths();
  std::vector<const UnfinishedPath*>& paths = GetList().Paths;
  paths.erase(std::remove(paths.begin(), paths.end(), this), paths.end());
  this->IsKept = true;
}

void UnfinishedPath::Remove() const
{
  // A file that is gone and a folder with files of others are no errors.
  this->TheKind == Kind::File ? unlink(this->ThePath.c_str()) : rmdir(this->ThePath.c_str());
}

std::unique_lock<std::recursive_mutex> HoldUnfinishedPaths()
{
  return std::unique_lock(GetList().Mutex);
}

void RemoveUnfinishedPaths()
{
  List& list = GetList();
  list.Mutex.lock();
  std::for_each(
    list.Paths.rbegin(), list.Paths.rend(), [](const UnfinishedPath* path) { path->Remove(); });
}

} // namespace vfm
