/**
 * UnnamedFile: a file that the system removes when the process ends, in whatever way.
 */
#pragma once

#include <memory>
#include <string>

#include <sys/types.h>

namespace vfm
{

/// Open file in a folder, without a name until Link gives it one (O_TMPFILE of Linux).
class UnnamedFile
{
public:
  static constexpr int LargestCount = 64; ///< of a process, which may open 1024 files or fewer

  /// Creates an empty file.
  /// @param mode  permissions; reduced by the mask of the process
  /// @return null if the file system has no such files, as NFS, if /proc is not mounted, or if the
  ///   process has the largest number of them
  static std::unique_ptr<UnnamedFile> Create(const std::string& folder, mode_t mode);
  ~UnnamedFile();
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  int Descriptor() const { return this->File; }
  /// Returns a path by which this process can open the file.
  std::string Path() const;
  /// Gives the file a name in its file system. Returns whether it is done; otherwise, errno tells
  /// the reason.
  bool Link(const std::string& path) const;

private:
  explicit UnnamedFile(int file) : File(file) {}

  const int File;
};

} // namespace vfm
