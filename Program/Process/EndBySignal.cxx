#include "Process/EndBySignal.h"

#include "Meshes/Files/UnfinishedPath.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace vfm
{
namespace
{

using Action = struct sigaction;

struct Ending
{
  int Signal;
  const char* Name;
};
constexpr Ending Endings[] = { { SIGTERM, "SIGTERM" }, { SIGINT, "SIGINT" }, { SIGHUP, "SIGHUP" } };

constexpr int FirstStatus = 128; ///< as in shells: the exit status of signal 0

std::atomic<bool> IsSilent{ false };
int Ends[2] = { -1, -1 }; ///< of the pipe from the handler to the thread that ends the program

/// The signal handler: hands the signal over to a thread, which may lock and write.
void SendSignal(int signal)
{
  const int error = errno;
  const unsigned char byte = static_cast<unsigned char>(signal);
  if (write(Ends[1], &byte, 1) != 1)
  {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
  errno = error;
}

/// Waits for a signal and ends the program by it.
void WaitForSignal()
{
  unsigned char byte = 0;
  while (read(Ends[0], &byte, 1) != 1)
  {
  }
  RemoveUnfinishedPaths();
  std::string name;
  for (const Ending& ending : Endings)
  {
    name = ending.Signal == byte ? ending.Name : name;
  }
  const std::string line = "sculptor: ended by " + name + "; unfinished files are removed.\n";
  if (!IsSilent && write(STDERR_FILENO, line.data(), line.size()) < 0)
  {
    errno = 0; // there is no other place to report it
  }
  std::signal(byte, SIG_DFL);
  kill(getpid(), byte);
  _exit(FirstStatus + byte); // the first process of a container, which the signal does not end
}

/// Returns whether the thread that waits for signals runs.
bool StartThread()
{
  try
  {
    std::thread(WaitForSignal).detach();
    return true;
  }
  catch (const std::system_error&) // the user has too many threads
  {
    return false;
  }
}

} // namespace

void HandleSignals()
{
  std::signal(SIGXFSZ, SIG_IGN);
  if (pipe2(Ends, O_CLOEXEC) != 0 || !StartThread())
  {
    return; // signals then end the program at once
  }
  for (const Ending& ending : Endings)
  {
    Action old{}, handled{};
    handled.sa_handler = SendSignal;
    handled.sa_flags = SA_RESTART;
    sigemptyset(&handled.sa_mask);
    if (sigaction(ending.Signal, nullptr, &old) == 0 && old.sa_handler != SIG_IGN)
    {
      sigaction(ending.Signal, &handled, nullptr);
    }
  }
}

void HandleSignalsSilently()
{
  IsSilent = true;
}

} // namespace vfm
