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

/// Calls create(name) with names in the folder of a file, until it returns true.
/// @return the name of that call
/// @throws InputError  if it returns false for another reason than a file of that name
template <class Create>
std::string NameBeside(const fs::path& path, const Create& create)
{
  static std::atomic<int> next{ 0 };
  const std::string start = "." + path.filename().string().substr(0, LongestPartOfName) + "." +
    NameOfHost() + "-" + std::to_string(getpid()) + "-";
  for (;;)
  {
    const fs::path beside = path.parent_path() / (start + std::to_string(next++) + ".part");
    if (create(beside.string()))
    {
      return beside.string();
    }
    if (errno != EEXIST) // of a process with the same number that was killed
    {
      ThrowReason(errno);
    }
  }
}

/// Gives a file the owner and the permissions of the one that it replaces.
void CopyRights(const FileStatus& old, int file)
{
  if (old.st_uid == geteuid() || fchown(file, old.st_uid, old.st_gid) == 0)
  {
    fchmod(file, old.st_mode & 0777);
  }
}

} // namespace

std::string NameOfHost()
{
  char name[LongestHost + 1] = "";
  gethostname(name, LongestHost); // cut names need not end with 0
  return name;
}

void OutputPlace::Name()
{
  const auto held = HoldUnfinishedPaths();
  const auto link = [this](const std::string& name) { return this->Unnamed->Link(name); };
  this->Begun =
    std::make_unique<UnfinishedPath>(NameBeside(this->Final, link), UnfinishedPath::Kind::File);
  this->Unnamed.reset();
}

std::string FindFinalPath(const std::string& path)
{
  return FollowLinks(fs::absolute(path)).string();
}

bool IsWrittenInPlace(const std::string& path)
{
  const std::string final = FindFinalPath(path);
  std::error_code error;
  const fs::file_status status = fs::status(final, error);
  return IsOpenFile(final) ||
    (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

OutputPlace CreateOutput(const std::string& path, Naming naming)
{
  const fs::path followed = FindFinalPath(path);
  OutputPlace place{ followed.string(), nullptr, nullptr };
  constexpr mode_t usual = 0666;
  FileStatus old{};
  const bool isOld = stat(followed.c_str(), &old) == 0;
  if (isOld && S_ISDIR(old.st_mode))
  {
    ThrowReason(EISDIR);
  }
  if (IsWrittenInPlace(path))
  {
    return place;
  }
  if (isOld && access(followed.c_str(), W_OK) != 0)
  {
    ThrowReason(errno);
  }
  if (naming == Naming::Late)
  {
    place.Unnamed = UnnamedFile::Create(followed.parent_path().string(), usual);
  }
  if (place.Unnamed)
  {
    if (isOld)
    {
      CopyRights(old, place.Unnamed->Descriptor());
    }
    return place;
  }
  int file = -1;
  const auto create = [&file](const std::string& name)
  {
    file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, usual);
    return file >= 0;
  };
  const auto held = HoldUnfinishedPaths();
  place.Begun =
    std::make_unique<UnfinishedPath>(NameBeside(followed, create), UnfinishedPath::Kind::File);
  if (isOld)
  {
    CopyRights(old, file);
  }
  close(file);
  return place;
}

} // namespace vfm
