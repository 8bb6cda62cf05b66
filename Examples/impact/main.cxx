/**
 * The program `impact`: reads the command line, runs the simulation, passes its fields to sinks.
 *
 * Exit status 0: success. 1: error in the command line, a file, a mesh or a script, on all ranks;
 * rank 0 prints the message. Instability and lack of memory may occur on one rank and abort all.
 */
#include "Impact.h"
#include "MakeSinks.h"

#include <csignal>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace
{

void Run(int argc, char** argv)
{
  const impact::Options options = impact::ParseOptions(argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (options.Help)
  {
    std::fputs(rank == 0 ? impact::DescribeOptions().c_str() : "", stdout);
    return;
  }
  impact::Impact run(MPI_COMM_WORLD, options);
  const std::vector<std::unique_ptr<impact::Sink>> sinks =
    impact::MakeSinks(options, run.GetDomain());
  std::vector<impact::Sink*> takers;
  for (const auto& sink : sinks)
  {
    takers.push_back(sink.get());
  }
  run.Run(takers);
  for (const impact::Sink* sink : takers)
  {
    if (sink->HasFailed())
    {
      throw std::runtime_error("an output failed; see the messages above");
    }
  }
}

void Abort(int rank, const std::exception& error)
{
  std::fprintf(stderr, "impact, rank %d: %s\n", rank, error.what());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank = 0, status = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try
  {
    Run(argc, argv);
  }
  catch (const std::overflow_error& error)
  {
    Abort(rank, error);
  }
  catch (const std::bad_alloc& error)
  {
    Abort(rank, error);
  }
  catch (const std::exception& error)
  {
    if (rank == 0)
    {
      std::fprintf(stderr, "impact: %s\n", error.what());
    }
    status = 1;
    // mpiexec terminates the other ranks when one has exited, and ParaView's handler of SIGTERM
    // would print a stack trace.
    std::signal(SIGTERM, SIG_DFL);
  }
  MPI_Finalize();
  return status;
}
