#include "CatalystSink.h"

#include <cinttypes>
#include <cstdio>
#include <stdexcept>

#include <mpi.h>

namespace impact
{
namespace
{

/// Returns pointers to the fields; no value is copied.
vfm::HostGrid Describe(const Fields& fields)
{
  vfm::HostBox box{ { fields.Lower, fields.Upper },
    { vfm::MakeHostArray("ball", fields.Ball), vfm::MakeHostArray("plate", fields.Plate),
      vfm::MakeHostArray("velocity", fields.Velocity, 3),
      vfm::MakeHostArray("density", fields.Density),
      vfm::MakeHostArray("damage", fields.Damage) } };
  return { fields.Origin, fields.Spacing, fields.GlobalCells, { std::move(box) } };
}

} // namespace

CatalystSink::CatalystSink(MPI_Comm communicator, const std::vector<std::string>& scripts) :
  Catalyst(communicator, scripts)
{
  MPI_Comm_rank(communicator, &this->Rank);
  if (!this->Catalyst.GetError().empty())
  {
    throw std::runtime_error(this->Catalyst.GetError());
  }
}

void CatalystSink::Take(const Fields& fields)
{
  const int before = this->Catalyst.GetNumberOfStepsMade();
  const double start = MPI_Wtime();
  const bool done =
    this->Catalyst.Process(Describe(fields), fields.Time, static_cast<int>(fields.Step));
  const double seconds = MPI_Wtime() - start;
  this->Failed = this->Failed || !done;
  if (this->Rank == 0)
  {
    std::printf("Catalyst at step %" PRId64 ": %s, %.6f s\n", fields.Step,
      this->Catalyst.GetNumberOfStepsMade() > before ? "handed over" : "not requested", seconds);
  }
  if (!done && this->Rank == 0)
  {
    std::fprintf(
      stderr, "Catalyst, step %" PRId64 ": %s\n", fields.Step, this->Catalyst.GetError().c_str());
  }
}

} // namespace impact
