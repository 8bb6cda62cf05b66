/// Calls that change files, at one of which a signal arrives or the disk becomes full. Loaded
/// before all other libraries (LD_PRELOAD), they replace those of the C library. Settings are
/// environment variables:
/// - VFM_FAULT_FOLDER: calls count if their file is in this folder
/// - VFM_FAULT_AT: number of the call, from 1. Half of the bytes of a write are written before
/// - VFM_FAULT: number of the signal; 0: this and all further writes fail, as on a full disk
/// - VFM_FAULT_RANK: rank of Open MPI that counts; no value: every process
/// - VFM_FAULT_PARENT: if 1, the parent process, such as mpiexec, gets the signal
/// - VFM_FAULT_LOG: file to which each call appends a line
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <atomic>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

std::atomic<long> Calls{ 0 };

const char* Setting(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool IsCounting()
{
  static const bool isCounting = *Setting("VFM_FAULT_FOLDER") &&
    (!*Setting("VFM_FAULT_RANK") ||
      std::strcmp(Setting("VFM_FAULT_RANK"), Setting("OMPI_COMM_WORLD_RANK")) == 0);
  return isCounting;
}

bool IsInFolder(const char* path)
{
  const char* folder = Setting("VFM_FAULT_FOLDER");
  return IsCounting() && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

struct Path
{
  char Text[4096] = "";
};

/// Returns the path of an open file. It allocates nothing, because handlers of signals write too.
Path PathOf(int file)
{
  Path path;
  char link[32];
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", file);
  const ssize_t length = IsCounting() ? readlink(link, path.Text, sizeof(path.Text) - 1) : 0;
  path.Text[std::max<ssize_t>(length, 0)] = '\0';
  return path;
}

template <class Function>
Function* Next(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void Log(const char* call, const char* path)
{
  const char* log = Setting("VFM_FAULT_LOG");
  if (!*log)
  {
    return;
  }
  const int file =
    Next<int(const char*, int, ...)>("open")(log, O_WRONLY | O_CREAT | O_APPEND, 0666);
  dprintf(file, "%s %s\n", call, path);
  Next<int(int)>("close")(file);
}

/// Sends the signal, and waits until the process has handled it.
/// @param isLong  waits longer, because the signal can be handled during this call
void SendSignal(bool isLong)
{
  const bool toParent = std::strcmp(Setting("VFM_FAULT_PARENT"), "1") == 0;
  kill(toParent ? getppid() : getpid(), std::atoi(Setting("VFM_FAULT")));
  timespec rest{ isLong ? 2 : 0, 50 * 1000000L };
  while (nanosleep(&rest, &rest) != 0 && errno == EINTR)
  {
  }
}

/// Counts a call.
/// @return 0: it takes place; 1: the signal arrives at it; 2: the disk is full
int Count(const char* call, const char* path)
{
  if (!IsInFolder(path))
  {
    return 0;
  }
  Log(call, path);
  const long at = std::atol(Setting("VFM_FAULT_AT"));
  const long number = ++Calls;
  if (std::atoi(Setting("VFM_FAULT")) == 0)
  {
    return at > 0 && number >= at ? 2 : 0;
  }
  return number == at ? 1 : 0;
}

/// Counts a call that creates, names, closes or renames a file.
void CountSimple(const char* call, const char* path)
{
  if (Count(call, path) == 1)
  {
    SendSignal(false);
  }
}

template <class Write>
ssize_t CountWrite(const char* call, int file, std::size_t size, const Write& write)
{
  const int fault = Count(call, PathOf(file).Text);
  if (fault == 2)
  {
    errno = ENOSPC;
    return -1;
  }
  if (fault == 1)
  {
    const ssize_t half = write((size + 1) / 2);
    SendSignal(true);
    return half;
  }
  return write(size);
}

void CountOpen(const char* path, int flags)
{
  const bool isUnnamed = (flags & O_TMPFILE) == O_TMPFILE;
  if ((flags & (O_CREAT | O_TRUNC)) || isUnnamed)
  {
    CountSimple("open", path);
  }
}

} // namespace

extern "C"
{
  int open(const char* path, int flags, ...)
  {
    va_list more;
    va_start(more, flags);
    const mode_t mode = va_arg(more, mode_t);
    va_end(more);
    CountOpen(path, flags);
    return Next<int(const char*, int, ...)>("open")(path, flags, mode);
  }
  int open64(const char* path, int flags, ...)
  {
    va_list more;
    va_start(more, flags);
    const mode_t mode = va_arg(more, mode_t);
    va_end(more);
    CountOpen(path, flags);
    return Next<int(const char*, int, ...)>("open64")(path, flags, mode);
  }
  ssize_t write(int file, const void* bytes, size_t size)
  {
    static auto* const next = Next<ssize_t(int, const void*, size_t)>("write");
    return CountWrite(
      "write", file, size, [&](std::size_t part) { return next(file, bytes, part); });
  }
  ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at)
  {
    return CountWrite("pwrite", file, size,
      [&](std::size_t part) {
        return Next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(file, bytes, part, at);
      });
  }
  ssize_t pwrite(int file, const void* bytes, size_t size, off_t at)
  {
    return CountWrite("pwrite", file, size,
      [&](std::size_t part)
      { return Next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(file, bytes, part, at); });
  }
  int fsync(int file)
  {
    return static_cast<int>(
      CountWrite("fsync", file, 1, [&](std::size_t) { return Next<int(int)>("fsync")(file); }));
  }
  int rename(const char* from, const char* to) noexcept
  {
    CountSimple("rename", to);
    return Next<int(const char*, const char*)>("rename")(from, to);
  }
  int linkat(int fromFolder, const char* from, int folder, const char* to, int flags) noexcept
  {
    CountSimple("linkat", to);
    return Next<int(int, const char*, int, const char*, int)>("linkat")(
      fromFolder, from, folder, to, flags);
  }
  int unlink(const char* path) noexcept
  {
    CountSimple("unlink", path);
    return Next<int(const char*)>("unlink")(path);
  }
  int mkdir(const char* path, mode_t mode) noexcept
  {
    CountSimple("mkdir", path);
    return Next<int(const char*, mode_t)>("mkdir")(path, mode);
  }
  int close(int file)
  {
    CountSimple("close", PathOf(file).Text);
    return Next<int(int)>("close")(file);
  }
}
