/**
 * Random cases of the mesher with all checks:
 *
 *   FuzzMeshes [--seed S] [--count N] [--periodic] [--print]
 *
 * Runs the seeds S to S + N - 1, prints a line for each failure and a table at the end, and returns
 * 1 if any failed. Seeds run in a separate process, so that a crash or hang is a failure as any
 * other. A single seed runs in this process (for a debugger); --print writes its input first.
 */
#include "Outcome.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

using namespace vfm::testing;

namespace
{

constexpr int PatienceMs = 300000; // limit of one case

struct Arguments
{
  unsigned First = 0, Count = 1;
  bool IsPeriodic = false, Prints = false;
};

unsigned ReadNumber(const char* text)
{
  char* end = nullptr;
  const unsigned long value = std::strtoul(text, &end, 10);
  if (end == text || *end || value > 4294967295UL)
  {
    throw std::invalid_argument(std::string(text) + " is not a number");
  }
  return static_cast<unsigned>(value);
}

Arguments ReadArguments(int argc, char** argv)
{
  Arguments arguments;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--print")
    {
      arguments.Prints = true;
    }
    else if (name == "--periodic")
    {
      arguments.IsPeriodic = true;
    }
    else if ((name == "--seed" || name == "--count") && i + 1 < argc)
    {
      (name == "--seed" ? arguments.First : arguments.Count) = ReadNumber(argv[++i]);
    }
    else
    {
      throw std::invalid_argument("FuzzMeshes [--seed S] [--count N] [--periodic] [--print]");
    }
  }
  return arguments;
}

/// A process that runs seeds and reports each before and after.
class Worker
{
public:
  Worker(unsigned first, unsigned end, bool isPeriodic)
  {
    int ends[2];
    std::fflush(nullptr);
    if (pipe(ends) != 0 || (this->Process = fork()) < 0)
    {
      throw std::runtime_error("cannot start a process for the seeds");
    }
    if (this->Process == 0)
    {
      close(ends[0]);
      for (unsigned seed = first; seed != end; ++seed)
      {
        const auto tell = [&](const Outcome& outcome)
        {
          if (write(ends[1], &outcome, sizeof outcome) != sizeof outcome)
          {
            std::_Exit(1);
          }
        };
        tell(RunSeed(seed, isPeriodic, tell));
      }
      std::_Exit(0);
    }
    close(ends[1]);
    this->Pipe = ends[0];
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() { close(this->Pipe); }

  /// Receives the next report; returns false if there is none. Stop returns the reason.
  bool Listen(Outcome& outcome)
  {
    std::size_t got = 0;
    pollfd ready{ this->Pipe, POLLIN, 0 };
    while (got < sizeof outcome)
    {
      if (poll(&ready, 1, PatienceMs) <= 0)
      {
        this->IsLate = true;
        return false;
      }
      const ssize_t more =
        read(this->Pipe, reinterpret_cast<char*>(&outcome) + got, sizeof outcome - got);
      if (more <= 0)
      {
        return false;
      }
      got += static_cast<std::size_t>(more);
    }
    return true;
  }

  /// Ends the process; returns an empty string or its problem.
  std::string Stop()
  {
    if (this->IsLate)
    {
      kill(this->Process, SIGKILL);
    }
    int status = 0;
    waitpid(this->Process, &status, 0);
    if (this->IsLate)
    {
      return "no end within " + std::to_string(PatienceMs / 1000) + " s";
    }
    return WIFSIGNALED(status)
      ? std::string("crash: ") + strsignal(WTERMSIG(status))
      : (WEXITSTATUS(status) == 0 ? "" : "the process stopped with an error");
  }

private:
  pid_t Process = 0;
  int Pipe = -1;
  bool IsLate = false;
};

/// Runs seeds; starts a new process after each seed that ends one.
void RunSeeds(unsigned first, unsigned end, bool isPeriodic, Summary& summary)
{
  while (first != end)
  {
    Worker worker(first, end, isPeriodic);
    Outcome last, told;
    last.Seed = first;
    while (worker.Listen(told))
    {
      last = told;
      if (told.HasEnded)
      {
        summary.Add(told);
        last = Outcome();
        last.Seed = first = told.Seed + 1;
      }
    }
    const std::string problem = worker.Stop();
    if (!problem.empty())
    {
      std::snprintf(last.Problem, sizeof last.Problem, "%s", problem.c_str());
      summary.Add(last);
      first = last.Seed + 1;
    }
  }
}

void RunAlone(const Arguments& arguments, Summary& summary)
{
  if (arguments.Prints)
  {
    PrintCase(MakeFuzzCase(arguments.First, arguments.IsPeriodic));
  }
  summary.Add(RunSeed(arguments.First, arguments.IsPeriodic,
    [](const Outcome& outcome)
    {
      std::printf("seed %u: %s, %s\n", outcome.Seed, outcome.Method, outcome.Words);
      std::fflush(stdout);
    }));
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Arguments arguments = ReadArguments(argc, argv);
    Summary summary;
    if (arguments.Count == 1)
    {
      RunAlone(arguments, summary);
    }
    else
    {
      RunSeeds(arguments.First, arguments.First + arguments.Count, arguments.IsPeriodic, summary);
    }
    summary.Print();
    return summary.Failures() > 0 ? 1 : 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
