#include "Meshes/Files/UnnamedFile.h"

#include <atomic>
#include <fcntl.h>
#include <unistd.h>

namespace vfm
{
namespace
{

std::atomic<int> Count{ 0 };

/// Returns the descriptor, or -1.
int OpenUnnamed([[maybe_unused]] const char* folder, [[maybe_unused]] mode_t mode)
{
#ifdef O_TMPFILE
  return open(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
#else
  return -1;
#endif
}

} // namespace

std::unique_ptr<UnnamedFile> UnnamedFile::Create(const std::string& folder, mode_t mode)
{
  if (++Count > LargestCount)
  {
    --Count;
    return nullptr;
  }
  std::unique_ptr<UnnamedFile> created(new UnnamedFile(OpenUnnamed(folder.c_str(), mode)));
  const bool isUsable = created->File >= 0 && access(created->Path().c_str(), F_OK) == 0;
  return isUsable ? std::move(created) : nullptr;
}

UnnamedFile::~UnnamedFile()
{
  if (this->File >= 0)
  {
    close(this->File);
  }
  --Count;
}

std::string UnnamedFile::Path() const
{
  return "/proc/self/fd/" + std::to_string(this->File);
}

bool UnnamedFile::Link(const std::string& path) const
{
  return linkat(AT_FDCWD, this->Path().c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

} // namespace vfm
