/**
 * MpiTransport: the transport of MessageRanks over an MPI communicator, without VTK.
 */
#pragma once

#include "Ranks/MessageRanks.h"

#include <mpi.h>

namespace vfm
{

/// Transport over an MPI communicator. It needs the tag 7501 for itself.
class MpiTransport : public Transport
{
public:
  explicit MpiTransport(MPI_Comm communicator) : Communicator(communicator) {}
  void Begin(Transfer& transfer) noexcept override;
  void Wait(Transfer& transfer) noexcept override;
  bool HasArrived(int from) noexcept override;

private:
  MPI_Comm Communicator;
};

/// Ranks of an MPI communicator. They exchange failures also with a ControllerRanks of
/// the same communicator.
class MpiRanks : private MpiTransport, public MessageRanks
{
public:
  /// @param communicator  must outlive this object
  explicit MpiRanks(MPI_Comm communicator);
};

} // namespace vfm
