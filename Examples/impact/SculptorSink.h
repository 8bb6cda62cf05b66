/**
 * SculptorSink: meshes ball and plate inside the simulation by the C interface (InSitu/Sculptor.h)
 * at each output step, writes the meshes as FOLDER/impact_SSSS.pvtu and tells how long that took.
 */
#pragma once

#include "Fields.h"

#include <mpi.h>

#include <string>

namespace impact
{

class SculptorSink : public Sink
{
public:
  /// Collective. Makes the folder. Throws std::runtime_error.
  SculptorSink(MPI_Comm communicator, const std::string& folder);
  /// Collective.
  ~SculptorSink() override;
  SculptorSink(const SculptorSink&) = delete;
  SculptorSink& operator=(const SculptorSink&) = delete;

  /// Throws std::runtime_error on all ranks when the fields cannot be meshed or the file not be
  /// written.
  void Take(const Fields& fields) override;

private:
  void HandOver(const Fields& fields);
  void Check(int code) const;
  void Report(const Fields& fields, const double* seconds) const;

  MPI_Comm Communicator;
  std::string Folder;
  int Sculptor = 0;
};

} // namespace impact
