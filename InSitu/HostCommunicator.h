/**
 * HostCommunicator: the ranks of an MPI communicator of a host. A duplicate of the communicator
 * keeps messages separate from messages of the host.
 */
#pragma once

#include "MpiTransport.h"

#include <optional>

namespace vfm
{

/// Owner of the duplicate and of its Ranks.
class HostCommunicator
{
public:
  HostCommunicator() = default;
  /// Frees the duplicate, if there is one.
  /// @pre Collective unless MPI has been finalized
  ~HostCommunicator();
  HostCommunicator(const HostCommunicator&) = delete;
  HostCommunicator& operator=(const HostCommunicator&) = delete;

  /// Sets the communicator by its Fortran handle. A duplicate of another communicator is freed.
  /// @throws InputError  if MPI is not running or the handle is MPI_COMM_NULL
  /// @pre Collective if another communicator was duplicated before
  void Set(int communicator);
  /// Returns the ranks of a duplicate of the communicator that was set, otherwise of
  /// MPI_COMM_WORLD. If MPI is not running, this process is the only rank.
  /// @pre Collective at the first call, which makes the duplicate
  Ranks& GetRanks();

private:
  void Free();

  MPI_Comm Given = MPI_COMM_NULL, Duplicate = MPI_COMM_NULL;
  std::optional<MpiRanks> OfDuplicate;
  Ranks Alone;
};

} // namespace vfm
