/**
 * SculptorSink: meshes ball and plate at each output step with the C interface (InSitu/Sculptor.h).
 * It writes the meshes as FOLDER/impact_SSSS.pvtu and prints the time needed.
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
  /// Makes the folder.
  /// @throws std::runtime_error  if the folder or the mesher cannot be made
  /// @pre Collective
  SculptorSink(MPI_Comm communicator, const std::string& folder);
  /// @pre Collective
  ~SculptorSink() override;
  SculptorSink(const SculptorSink&) = delete;
  SculptorSink& operator=(const SculptorSink&) = delete;

  /// Meshes the fields and writes the mesh.
  /// @throws std::runtime_error  if meshing or writing fails, on all ranks
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
