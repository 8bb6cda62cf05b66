#include "ControllerRanks.h"

#include "MpiTransport.h"

#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"

namespace vfm
{
namespace
{

int CountProcesses(vtkMultiProcessController* controller)
{
  const int count = controller ? controller->GetNumberOfProcesses() : 1;
  if (count > 1 && !vtkMPIController::SafeDownCast(controller))
  {
    throw InputError(
      "The controller has several ranks but is not a vtkMPIController: use a vtkMPIController.");
  }
  return count;
}

MpiTransport TransportOf(vtkMPIController* controller)
{
  auto* communicator = static_cast<vtkMPICommunicator*>(controller->GetCommunicator());
  return MpiTransport(*communicator->GetMPIComm()->GetHandle());
}

} // namespace

ControllerTransport::ControllerTransport(vtkMultiProcessController* controller) :
  Controller(vtkMPIController::SafeDownCast(controller))
{
}

void ControllerTransport::Begin(Transfer& transfer) noexcept
{
  TransportOf(this->Controller).Begin(transfer);
}

void ControllerTransport::Wait(Transfer& transfer) noexcept
{
  TransportOf(this->Controller).Wait(transfer);
}

bool ControllerTransport::HasArrived(int from) noexcept
{
  return TransportOf(this->Controller).HasArrived(from);
}

ControllerRanks::ControllerRanks(vtkMultiProcessController* controller) :
  ControllerTransport(controller),
  MessageRanks(*this, controller ? controller->GetLocalProcessId() : 0, CountProcesses(controller))
{
}

} // namespace vfm
