#include "ControllerRanks.h"

#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"

namespace vfm
{
namespace
{

constexpr int MessageTag = 7501; // of all messages; MPI keeps their order

int CountProcesses(vtkMultiProcessController* controller)
{
  const int count = controller ? controller->GetNumberOfProcesses() : 1;
  if (count > 1 && !vtkMPIController::SafeDownCast(controller))
  {
    throw InputError("Only a vtkMPIController can be used on several processes.");
  }
  return count;
}

MPI_Comm CommunicatorOf(vtkMPIController* controller)
{
  auto* communicator = static_cast<vtkMPICommunicator*>(controller->GetCommunicator());
  return *communicator->GetMPIComm()->GetHandle();
}

static_assert(sizeof(MPI_Request) <= sizeof(Transport::Transfer::Request), "no place for requests");

MPI_Request* RequestOf(Transport::Transfer& transfer)
{
  return reinterpret_cast<MPI_Request*>(&transfer.Request);
}

/// Where messages go that nobody wants.
char* Waste()
{
  static char waste[Transport::LongestPiece];
  return waste;
}

} // namespace

ControllerTransport::ControllerTransport(vtkMultiProcessController* controller) :
  Controller(vtkMPIController::SafeDownCast(controller))
{
}

void ControllerTransport::Begin(Transfer& transfer) noexcept
{
  const MPI_Comm communicator = CommunicatorOf(this->Controller);
  char* data = transfer.Data ? transfer.Data : Waste();
  const int size = static_cast<int>(transfer.Size);
  if (transfer.IsSent)
  {
    MPI_Isend(data, size, MPI_BYTE, transfer.Other, MessageTag, communicator, RequestOf(transfer));
  }
  else
  {
    MPI_Irecv(data, size, MPI_BYTE, transfer.Other, MessageTag, communicator, RequestOf(transfer));
  }
}

void ControllerTransport::Wait(Transfer& transfer) noexcept
{
  MPI_Wait(RequestOf(transfer), MPI_STATUS_IGNORE);
}

bool ControllerTransport::HasArrived(int from) noexcept
{
  int arrived = 0;
  MPI_Iprobe(from, MessageTag, CommunicatorOf(this->Controller), &arrived, MPI_STATUS_IGNORE);
  return arrived;
}

ControllerRanks::ControllerRanks(vtkMultiProcessController* controller) :
  ControllerTransport(controller),
  MessageRanks(*this, controller ? controller->GetLocalProcessId() : 0, CountProcesses(controller))
{
}

} // namespace vfm
