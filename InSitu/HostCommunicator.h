/**
 * HostCommunicator: the ranks of a host code's MPI communicator, with messages of their own.
 */
#pragma once

#include "MpiTransport.h"

#include <optional>

namespace vfm
{

class HostCommunicator
{
public:
  HostCommunicator() = default;
  /// Frees the duplicate; collective unless MPI has ended.
  ~HostCommunicator();
  HostCommunicator(const HostCommunicator&) = delete;
  HostCommunicator& operator=(const HostCommunicator&) = delete;

  /// The ranks of a Fortran handle. Throws InputError when MPI does not run or it is no communicator.
  void Set(int communicator);
  /// Collective when called first: the ranks of a duplicate of what was Set, or of MPI_COMM_WORLD; this process alone where MPI does not
  /// run. They belong to this.
  Ranks& GetRanks();

private:
  void Free();

  MPI_Comm Given = MPI_COMM_NULL, Duplicate = MPI_COMM_NULL;
  std::optional<MpiRanks> OfDuplicate;
  Ranks Alone;
};

} // namespace vfm
