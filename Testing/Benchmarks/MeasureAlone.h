/**
 * Measuring tools of benchmarks: the clock, the peak memory of a process, and separate processes.
 */
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vfm
{
namespace testing
{

/// Returns the time in seconds.
inline double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the memory of this process now, and at its peak.
inline std::size_t CurrentBytes()
{
  std::size_t total = 0, resident = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r"))
  {
    if (std::fscanf(file, "%zu %zu", &total, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}
inline std::size_t PeakBytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Returns the result of measure(), which runs in a separate process, so that its peak memory is
/// measured separately. Empty if the process fails.
template <class Measure>
std::vector<double> MeasureAlone(std::size_t count, const Measure& measure)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return {};
  }
  const ssize_t bytes = static_cast<ssize_t>(count * sizeof(double));
  if (fork() == 0)
  {
    const std::vector<double> values = measure();
    _exit(write(ends[1], values.data(), bytes) == bytes ? 0 : 1);
  }
  close(ends[1]);
  std::vector<double> values(count);
  const bool complete = read(ends[0], values.data(), bytes) == bytes;
  wait(nullptr);
  close(ends[0]);
  return complete ? values : std::vector<double>();
}

} // namespace testing
} // namespace vfm
