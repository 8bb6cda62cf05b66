#include "SculptorSink.h"

#include "Sculptor.h"
#include "WorkTogether.h"

#include <cinttypes>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace impact
{
namespace
{

/// Replaces each time by its maximum over the ranks.
void ReduceSeconds(double* seconds, int count, MPI_Comm communicator)
{
  const std::vector<double> mine(seconds, seconds + count);
  MPI_Allreduce(mine.data(), seconds, count, MPI_DOUBLE, MPI_MAX, communicator);
}

} // namespace

SculptorSink::SculptorSink(MPI_Comm communicator, const std::string& folder) :
  Communicator(communicator), Folder(folder)
{
  MakeFolder(communicator, folder);
  this->Check(sculptor_create(&this->Sculptor));
  this->Check(sculptor_set_communicator(this->Sculptor, MPI_Comm_c2f(communicator)));
}

SculptorSink::~SculptorSink()
{
  sculptor_delete(this->Sculptor);
}

void SculptorSink::Check(int code) const
{
  if (code != SCULPTOR_OK)
  {
    throw std::runtime_error(sculptor_error_text(this->Sculptor));
  }
}

/// Passes pointers to the fields; no value is copied.
void SculptorSink::HandOver(const Fields& fields)
{
  double box[6];
  int intervals[3];
  for (int a = 0; a < 3; ++a)
  {
    box[a] = fields.Origin[a] + fields.Spacing[a] * static_cast<double>(fields.Lower[a]);
    box[3 + a] = fields.Origin[a] + fields.Spacing[a] * static_cast<double>(fields.Upper[a]);
    intervals[a] = static_cast<int>(fields.Upper[a] - fields.Lower[a]);
  }
  this->Check(sculptor_clear_fields(this->Sculptor));
  this->Check(sculptor_set_box(this->Sculptor, box, intervals));
  this->Check(sculptor_set_neighbours(this->Sculptor, fields.Neighbours.data()));
  this->Check(sculptor_add_material(this->Sculptor, "ball", fields.Ball));
  this->Check(sculptor_add_material(this->Sculptor, "plate", fields.Plate));
  this->Check(sculptor_add_state(this->Sculptor, "velocity", 3, fields.Velocity));
  this->Check(sculptor_add_state(this->Sculptor, "damage", 1, fields.Damage));
}

void SculptorSink::Take(const Fields& fields)
{
  double times[4] = { MPI_Wtime() };
  this->HandOver(fields);
  times[1] = MPI_Wtime();
  this->Check(sculptor_make_mesh(this->Sculptor, 0));
  times[2] = MPI_Wtime();
  char name[32];
  std::snprintf(name, sizeof(name), "/impact_%04" PRId64 ".pvtu", fields.Step);
  this->Check(sculptor_write(this->Sculptor, (this->Folder + name).c_str()));
  times[3] = MPI_Wtime();
  double seconds[3] = { times[1] - times[0], times[2] - times[1], times[3] - times[2] };
  ReduceSeconds(seconds, 3, this->Communicator);
  this->Report(fields, seconds);
}

void SculptorSink::Report(const Fields& fields, const double* seconds) const
{
  std::int64_t points = 0, elements = 0, all = 0;
  int corners = 0, rank = 0;
  double fragments = 0, quality = 0;
  this->Check(sculptor_get_counts(this->Sculptor, &points, &elements, &corners));
  this->Check(sculptor_get_number(this->Sculptor, "NumberOfFragments", 0, &fragments));
  this->Check(sculptor_get_number(this->Sculptor, "MinimumScaledJacobian", 0, &quality));
  MPI_Reduce(&elements, &all, 1, MPI_INT64_T, MPI_SUM, 0, this->Communicator);
  MPI_Comm_rank(this->Communicator, &rank);
  if (rank == 0)
  {
    std::printf("mesh of step %" PRId64 ": %" PRId64
                " hexahedra, %.0f fragments, scaled Jacobian >= %.3f; "
                "hand-over %.6f s, mesh %.2f s, file %.2f s\n",
      fields.Step, all, fragments, quality, seconds[0], seconds[1], seconds[2]);
  }
}

} // namespace impact
