/**
 * CatalystSink: passes the fields to ParaView Catalyst scripts at each output step, without a copy.
 *
 * A script that fails at a step does not stop the simulation. Rank 0 reports the error at once, and
 * the program returns a non-zero exit status at its end.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "Fields.h"

namespace impact
{

class CatalystSink : public Sink
{
public:
  /// Loads the scripts. A process can have only one CatalystSink.
  /// @param[in] scripts  paths of Catalyst scripts, for example of Examples/catalyst_mesh.py
  /// @throws std::runtime_error  if a script cannot be loaded
  /// @pre Collective
  CatalystSink(MPI_Comm communicator, const std::vector<std::string>& scripts);

  void Take(const Fields& fields) override;
  bool HasFailed() const override { return this->Failed; }

private:
  vfm::CatalystAdaptor Catalyst;
  int Rank = 0;
  bool Failed = false;
};

} // namespace impact
