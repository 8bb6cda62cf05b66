/**
 * CatalystSink: hands the fields to ParaView Catalyst scripts at each output step, without a copy.
 *
 * A script that fails does not stop the simulation: rank 0 tells what went wrong.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "Fields.h"

namespace impact
{

class CatalystSink : public Sink
{
public:
  /// Collective; one in a process. scripts: paths, as of Examples/catalyst_mesh.py.
  CatalystSink(MPI_Comm communicator, const std::vector<std::string>& scripts);

  void Take(const Fields& fields) override;

private:
  vfm::CatalystAdaptor Catalyst;
  int Rank = 0;
};

} // namespace impact
