#include "MpiTransport.h"

namespace vfm
{
namespace
{

constexpr int MessageTag = 7501; // tag of all messages; MPI keeps their order

static_assert(sizeof(MPI_Request) <= sizeof(Transport::Transfer::Request),
  "MPI_Request does not fit into Transfer::Request");

MPI_Request* RequestOf(Transport::Transfer& transfer)
{
  return reinterpret_cast<MPI_Request*>(&transfer.Request);
}

/// Returns memory that receives discarded messages.
char* Waste()
{
  static char waste[Transport::LongestPiece];
  return waste;
}

int RankIn(MPI_Comm communicator)
{
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

int CountIn(MPI_Comm communicator)
{
  int count = 1;
  MPI_Comm_size(communicator, &count);
  return count;
}

} // namespace

void MpiTransport::Begin(Transfer& transfer) noexcept
{
  char* data = transfer.Data ? transfer.Data : Waste();
  const int size = static_cast<int>(transfer.Size), other = transfer.Other;
  MPI_Request* request = RequestOf(transfer);
  if (transfer.IsSent)
  {
    MPI_Isend(data, size, MPI_BYTE, other, MessageTag, this->Communicator, request);
  }
  else
  {
    MPI_Irecv(data, size, MPI_BYTE, other, MessageTag, this->Communicator, request);
  }
}

void MpiTransport::Wait(Transfer& transfer) noexcept
{
  MPI_Wait(RequestOf(transfer), MPI_STATUS_IGNORE);
}

bool MpiTransport::HasArrived(int from) noexcept
{
  int arrived = 0;
  MPI_Iprobe(from, MessageTag, this->Communicator, &arrived, MPI_STATUS_IGNORE);
  return arrived;
}

MpiRanks::MpiRanks(MPI_Comm communicator) :
  MpiTransport(communicator), MessageRanks(*this, RankIn(communicator), CountIn(communicator))
{
}

} // namespace vfm
