/**
 * The program: reads the command line, runs the impact, hands its fields to the sinks.
 *
 * Exit status 0: done; 1: the command line, a file, a mesh or a script, on all ranks alike, told by
 * rank 0. Instability and lack of memory, which may hit one rank alone, abort all of them.
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
      throw std::runtime_error("an output failed, as told above");
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
    // mpiexec ends the others when one has left: ParaView would print a stack.
    std::signal(SIGTERM, SIG_DFL);
  }
  MPI_Finalize();
  return status;
}
