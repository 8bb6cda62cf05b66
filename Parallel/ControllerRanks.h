/**
 * ControllerRanks: the processes of a vtkMultiProcessController as the Ranks of the Grid code.
 */
#pragma once

#include "Ranks/MessageRanks.h"

class vtkMPIController;
class vtkMultiProcessController;

namespace vfm
{

/// Messages of a vtkMPIController, of any size; null for one process.
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

/// Makes no use of memory, so that it can be made where there is none, on up to 4096 ranks.
class ControllerRanks : private ControllerTransport, public MessageRanks
{
public:
  /// The controller must outlive this; null for one process. One of several processes is a vtkMPIController, or InputError is thrown.
  explicit ControllerRanks(vtkMultiProcessController* controller);
};

} // namespace vfm
