/**
 * MpiTransport: messages of MessageRanks over a communicator of MPI; needs no VTK.
 */
#pragma once

#include "Ranks/MessageRanks.h"

#include <mpi.h>

namespace vfm
{

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

/// The processes of a communicator. These and a ControllerRanks of the same communicator hear of each other's failures.
class MpiRanks : private MpiTransport, public MessageRanks
{
public:
  /// The communicator must outlive this.
  explicit MpiRanks(MPI_Comm communicator);
};

} // namespace vfm
