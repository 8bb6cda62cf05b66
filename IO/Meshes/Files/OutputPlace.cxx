#include "Meshes/Files/OutputPlace.h"

#include "Meshes/Files/UnfinishedPath.h"
#include "Ranks/Errors.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace vfm
{
namespace
{

using FileStatus = struct stat;
namespace fs = std::filesystem;

constexpr int MaximumLinks = 40;               // as in Linux
constexpr std::size_t LongestPartOfName = 150; // of 255 bytes
constexpr std::size_t LongestHost = 40;

[[noreturn]] void ThrowReason(int number)
{
  throw InputError(std::strerror(number) + std::string("."));
}

/// Returns whether a path names an open file of the process, such as the target of /dev/stdout.
bool IsOpenFile(const std::string& path)
{
  return path.rfind("/proc/", 0) == 0 || path.rfind("/dev/fd/", 0) == 0;
}

fs::path FollowLinks(fs::path path)
{
  std::error_code isNoLink;
  for (int links = 0; links < MaximumLinks && !IsOpenFile(path.string()); ++links)
  {
    const fs::path target = fs::read_symlink(path, isNoLink);
    if (isNoLink)
    {
      return path;
    }
    path = path.parent_path() / target; // the target, if that is absolute
  }
  return path;
}

/// Creates an empty file, which no other process has, in the folder of a file.
/// @param mode  permissions; reduced by the mask of the process
/// @return descriptor and path of the file
std::pair<int, std::string> CreateBeside(const fs::path& path, mode_t mode)
{
  static std::atomic<int> next{ 0 };
  const std::string start = "." + path.filename().string().substr(0, LongestPartOfName) + "." +
    NameOfHost() + "-" + std::to_string(getpid()) + "-";
  for (;;)
  {
    const fs::path beside = path.parent_path() / (start + std::to_string(next++) + ".part");
    const int file = open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file >= 0)
    {
      return { file, beside.string() };
    }
    if (errno != EEXIST) // of a process with the same number that was killed
    {
      ThrowReason(errno);
    }
  }
}

} // namespace

std::string NameOfHost()
{
  char name[LongestHost + 1] = "";
  gethostname(name, LongestHost); // cut names need not end with 0
  return name;
}

OutputPlace CreateOutput(const std::string& path)
{
  const fs::path followed = FollowLinks(fs::absolute(path));
  OutputPlace place{ followed.string(), nullptr };
  constexpr mode_t usual = 0666;
  FileStatus old{};
  const bool isOld = stat(followed.c_str(), &old) == 0;
  if (isOld && S_ISDIR(old.st_mode))
  {
    ThrowReason(EISDIR);
  }
  if (IsOpenFile(followed.string()) || (isOld && !S_ISREG(old.st_mode)))
  {
    return place;
  }
  if (isOld && access(followed.c_str(), W_OK) != 0)
  {
    ThrowReason(errno);
  }
  const auto held = HoldUnfinishedPaths();
  const auto [file, begun] = CreateBeside(followed, usual);
  place.Begun = std::make_unique<UnfinishedPath>(begun, UnfinishedPath::Kind::File);
  if (isOld && (old.st_uid == geteuid() || fchown(file, old.st_uid, old.st_gid) == 0))
  {
    fchmod(file, old.st_mode & 0777);
  }
  close(file);
  return place;
}

} // namespace vfm
