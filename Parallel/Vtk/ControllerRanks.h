/**
 * ControllerRanks: the ranks of a vtkMultiProcessController as Ranks of the Grid library.
 */
#pragma once

#include "Ranks/MessageRanks.h"

class vtkMPIController;
class vtkMultiProcessController;

namespace vfm
{

/// Transport over the communicator of a vtkMPIController; null for a single rank.
class ControllerTransport : public Transport
{
public:
  explicit ControllerTransport(vtkMultiProcessController* controller);
  void Begin(Transfer& transfer) noexcept override;
  void Wait(Transfer& transfer) noexcept override;
  bool HasArrived(int from) noexcept override;

private:
  vtkMPIController* Controller;
};

/// Ranks of a controller. On up to 4096 ranks the construction allocates no memory, so it works
/// even if there is none left.
class ControllerRanks : private ControllerTransport, public MessageRanks
{
public:
  /// @param controller  must outlive this object; null for a single rank
  /// @throws InputError  if there are several ranks and the controller is not a vtkMPIController
  explicit ControllerRanks(vtkMultiProcessController* controller);
};

} // namespace vfm
