#include "RunApart.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace vfm
{
namespace testing
{
namespace
{

using Clock = std::chrono::steady_clock;

/// Returns the address space of this process in bytes.
std::size_t MeasureAddressSpace()
{
  unsigned long pages = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file || std::fscanf(file, "%lu", &pages) != 1)
  {
    throw std::runtime_error("cannot read /proc/self/statm");
  }
  std::fclose(file);
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void LimitMemory(std::size_t memory)
{
  if (memory > 0)
  {
    const rlim_t most = MeasureAddressSpace() + memory;
    const rlimit limit{ most, most };
    setrlimit(RLIMIT_AS, &limit);
  }
}

/// Never returns.
[[noreturn]] void Work(const std::function<std::string()>& work, std::size_t memory, int pipe)
{
  LimitMemory(memory);
  const std::string text = work();
  for (std::size_t at = 0; at < text.size();)
  {
    const ssize_t written = write(pipe, text.data() + at, text.size() - at);
    if (written <= 0)
    {
      std::_Exit(1);
    }
    at += static_cast<std::size_t>(written);
  }
  std::_Exit(0);
}

/// Reads to the end; returns false after a timeout.
bool ReadAll(int pipe, int seconds, std::string& text)
{
  const Clock::time_point end = Clock::now() + std::chrono::seconds(seconds);
  pollfd ready{ pipe, POLLIN, 0 };
  char bytes[4096];
  for (;;)
  {
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) <= 0)
    {
      return false;
    }
    const ssize_t got = read(pipe, bytes, sizeof bytes);
    if (got <= 0)
    {
      return true;
    }
    text.append(bytes, static_cast<std::size_t>(got));
  }
}

} // namespace

ApartResult RunApart(const std::function<std::string()>& work, int seconds, std::size_t memory)
{
  int ends[2];
  std::fflush(nullptr);
  pid_t process = 0;
  if (pipe(ends) != 0 || (process = fork()) < 0)
  {
    throw std::runtime_error("cannot start a process for the work");
  }
  if (process == 0)
  {
    close(ends[0]);
    Work(work, memory, ends[1]);
  }
  close(ends[1]);
  ApartResult result;
  const bool hasEnded = ReadAll(ends[0], seconds, result.Text);
  close(ends[0]);
  if (!hasEnded)
  {
    kill(process, SIGKILL);
  }
  int status = 0;
  waitpid(process, &status, 0);
  if (!hasEnded)
  {
    result.Failure = "no end within " + std::to_string(seconds) + " s";
  }
  else if (WIFSIGNALED(status))
  {
    result.Failure = std::string("crash: ") + strsignal(WTERMSIG(status));
  }
  else if (WEXITSTATUS(status) != 0)
  {
    result.Failure = "the process ended with " + std::to_string(WEXITSTATUS(status));
  }
  return result;
}

} // namespace testing
} // namespace vfm
