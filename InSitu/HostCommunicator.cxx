#include "HostCommunicator.h"

#include <string>

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

} // namespace

HostCommunicator::~HostCommunicator()
{
  this->Free();
}

void HostCommunicator::Free()
{
  this->OfDuplicate.reset();
  if (this->Duplicate != MPI_COMM_NULL && IsMpiRunning())
  {
    MPI_Comm_free(&this->Duplicate);
  }
  this->Duplicate = MPI_COMM_NULL;
}

void HostCommunicator::Set(int communicator)
{
  if (!IsMpiRunning())
  {
    throw InputError("A communicator was given, but MPI is not running.");
  }
  const MPI_Comm given = MPI_Comm_f2c(communicator);
  if (given == MPI_COMM_NULL)
  {
    throw InputError(std::to_string(communicator) +
      " is not a communicator. From C, pass MPI_Comm_c2f(communicator).");
  }
  if (given != this->Given)
  {
    this->Free();
    this->Given = given;
  }
}

Ranks& HostCommunicator::GetRanks()
{
  if (!this->OfDuplicate && IsMpiRunning())
  {
    if (this->Duplicate == MPI_COMM_NULL)
    {
      MPI_Comm_dup(this->Given == MPI_COMM_NULL ? MPI_COMM_WORLD : this->Given, &this->Duplicate);
    }
    this->OfDuplicate.emplace(this->Duplicate);
  }
  return this->OfDuplicate ? *this->OfDuplicate : this->Alone;
}

} // namespace vfm
