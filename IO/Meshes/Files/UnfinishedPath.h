/**
 * UnfinishedPath: removes a file or folder that is not completed, also if a signal ends the
 * program.
 */
#pragma once

#include <mutex>
#include <string>

namespace vfm
{

/// Guard that removes a file, or an empty folder, in its destructor, unless Keep was called. A list
/// of the process contains all paths that are guarded.
class UnfinishedPath
{
public:
  enum class Kind
  {
    File,
    Folder
  };

  UnfinishedPath(std::string path, Kind kind);
  ~UnfinishedPath();
  UnfinishedPath(const UnfinishedPath&) = delete;
  UnfinishedPath& operator=(const UnfinishedPath&) = delete;

  const std::string& Path() const { return this->ThePath; }
  /// Takes the path from the list.
  void Keep();

  /// Removes the file or folder.
  void Remove() const;

private:
  const std::string ThePath;
  const Kind TheKind;
  bool IsKept = false;
};

/// Prevents RemoveUnfinishedPaths until the lock is released: a path that is created, renamed or
/// removed meanwhile is in the list, or is finished, before a signal ends the program.
std::unique_lock<std::recursive_mutex> HoldUnfinishedPaths();

/// Removes all paths in the list, the last one first. Threads that guard further paths then wait
/// for ever.
/// @pre The process ends afterwards. The caller is not a signal handler.
void RemoveUnfinishedPaths();

} // namespace vfm
