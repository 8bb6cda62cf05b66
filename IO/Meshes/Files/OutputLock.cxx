#include "Meshes/Files/OutputLock.h"

#include "Ranks/Errors.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace vfm
{
namespace
{

using FileStatus = struct stat;
constexpr std::chrono::seconds LongestWait(10);
constexpr std::chrono::milliseconds Pause(5);

/// Returns whether a path still names an open file, which another process may have removed.
bool IsNamed(int file, const std::string& path)
{
  FileStatus open{}, named{};
  return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 &&
    open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

} // namespace

OutputLock::OutputLock(const std::string& path)
{
  const std::filesystem::path file(path);
  const std::string lock =
    (file.parent_path() / ("." + file.filename().string() + ".lock")).string();
  const auto end = std::chrono::steady_clock::now() + LongestWait;
  while (!this->Try(lock))
  {
    if (std::chrono::steady_clock::now() > end)
    {
      throw InputError("another process is writing files of the same names and has locked " + lock +
        " for more than ten seconds.");
    }
    std::this_thread::sleep_for(Pause);
  }
}

OutputLock::~OutputLock()
{
  this->Created.reset();
  if (this->File >= 0)
  {
    close(this->File);
  }
}

/// Returns whether the name is locked now, or its file system has no locks.
bool OutputLock::Try(const std::string& path)
{
  const auto held = HoldUnfinishedPaths();
  constexpr mode_t mode = 0666;
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, mode);
  if (file < 0 && errno != EACCES) // EACCES: the lock of another user
  {
    throw InputError(path + ": " + std::strerror(errno) + ".");
  }
  const bool isLocked = file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0;
  if (isLocked ? IsNamed(file, path) : file >= 0 && errno != EWOULDBLOCK)
  {
    this->Created = std::make_unique<UnfinishedPath>(path, UnfinishedPath::Kind::File);
    this->File = file;
    return true;
  }
  if (file >= 0)
  {
    close(file);
  }
  return false;
}

} // namespace vfm
