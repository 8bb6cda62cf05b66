/**
 * OutputLock: lets only one process at a time replace the files of a name.
 */
#pragma once

#include "Meshes/Files/UnfinishedPath.h"

#include <memory>
#include <string>

namespace vfm
{

/// Lock of a name, as the file .NAME.lock in its folder. The file is removed with the lock. A lock
/// of a process that was killed is no lock. File systems without flock have no locks.
class OutputLock
{
public:
  /// Waits until no other process has the lock, at most ten seconds.
  /// @throws InputError  if another process still has it, or if the file cannot be created
  explicit OutputLock(const std::string& path);
  ~OutputLock();
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

private:
  bool Try(const std::string& path);

  std::unique_ptr<UnfinishedPath> Created;
  int File = -1;
};

} // namespace vfm
