/**
 * CatalystSink: hands the fields to ParaView Catalyst scripts at each output step, without a copy.
 *
 * A script that fails at a step does not stop the simulation: rank 0 tells what went wrong, and the
 * program's exit status does at the end.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "Fields.h"

namespace impact
{

class CatalystSink : public Sink
{
public:
  /// Collective; one in a process. scripts: paths, as of Examples/catalyst_mesh.py. Throws
  /// std::runtime_error where one cannot be loaded.
  CatalystSink(MPI_Comm communicator, const std::vector<std::string>& scripts);

  void Take(const Fields& fields) override;
  bool HasFailed() const override { return this->Failed; }

private:
  vfm::CatalystAdaptor Catalyst;
  int Rank = 0;
  bool Failed = false;
};

} // namespace impact
