#include "HostCommunicator.h"

#include "Base/Runtime.h"

#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"

#include <new>

namespace vfm
{
namespace
{

bool IsMpiRunning()
{
  int begun = 0, ended = 0;
  MPI_Initialized(&begun);
  MPI_Finalized(&ended);
  return begun && !ended;
}

vtkSmartPointer<vtkMultiProcessController> MakeController(MPI_Comm communicator)
{
  vtkNew<vtkMPICommunicator> ranks;
  vtkMPICommunicatorOpaqueComm handle(&communicator);
  ranks->InitializeExternal(&handle);
  vtkNew<vtkMPIController> controller;
  controller->SetCommunicator(ranks);
  return controller;
}

} // namespace

HostCommunicator::~HostCommunicator()
{
  this->Free();
}

void HostCommunicator::Free()
{
  this->Controller = nullptr;
  if (this->Mine != MPI_COMM_NULL && IsMpiRunning())
  {
    MPI_Comm_free(&this->Mine);
  }
  this->Mine = MPI_COMM_NULL;
}

void HostCommunicator::Set(int communicator)
{
  if (!IsMpiRunning())
  {
    throw InputError("A communicator was given, but MPI does not run.");
  }
  const MPI_Comm given = MPI_Comm_f2c(communicator);
  if (given == MPI_COMM_NULL)
  {
    throw InputError(std::to_string(communicator) +
      " is no communicator. From C, give MPI_Comm_c2f(communicator).");
  }
  if (given != this->Given)
  {
    this->Free();
    this->Given = given;
  }
}

vtkMultiProcessController* HostCommunicator::GetController()
{
  if (!this->Controller && IsMpiRunning())
  {
    MPI_Comm_dup(this->Given == MPI_COMM_NULL ? MPI_COMM_WORLD : this->Given, &this->Mine);
    int isMade = 1, areMade = 0;
    try
    {
      this->Controller = MakeController(this->Mine);
    }
    catch (const std::bad_alloc&)
    {
      isMade = 0;
    }
    MPI_Allreduce(&isMade, &areMade, 1, MPI_INT, MPI_MIN, this->Mine);
    if (!areMade)
    {
      this->Free();
      throw std::bad_alloc();
    }
  }
  return this->Controller;
}

} // namespace vfm
