#include "ControllerRanks.h"

#include "Base/Runtime.h"

#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <limits>

namespace vfm
{
namespace
{

constexpr int MessageTag = 7501; // of all messages; MPI keeps their order
constexpr std::size_t LongestMessage = std::size_t(1) << 30; // MPI counts bytes in an int

/// Calls transfer(first byte, length) for the pieces of a message.
template <class Transfer>
void ForPieces(std::size_t size, const Transfer& transfer)
{
  for (std::size_t first = 0; first < size; first += LongestMessage)
  {
    transfer(first, static_cast<int>(std::min(LongestMessage, size - first)));
  }
}

void TransferAtOnce(vtkMPIController* controller, const std::vector<int>& peers,
  const std::vector<Bytes>& outgoing, std::vector<Bytes>& incoming)
{
  std::vector<vtkMPICommunicator::Request> requests;
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    ForPieces(incoming[p].size(),
      [&](std::size_t first, int length)
      {
        requests.emplace_back();
        controller->NoBlockReceive(
          incoming[p].data() + first, length, peers[p], MessageTag, requests.back());
      });
  }
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    ForPieces(outgoing[p].size(),
      [&](std::size_t first, int length)
      {
        requests.emplace_back();
        controller->NoBlockSend(
          outgoing[p].data() + first, length, peers[p], MessageTag, requests.back());
      });
  }
  if (!requests.empty())
  {
    controller->WaitAll(static_cast<int>(requests.size()), requests.data());
  }
}

/// Every rank serves its pairs in the order (lower rank, higher rank), so no ring of ranks can wait.
void TransferInPairs(vtkMultiProcessController* controller, const std::vector<int>& peers,
  const std::vector<Bytes>& outgoing, std::vector<Bytes>& incoming)
{
  const int rank = controller->GetLocalProcessId();
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    const auto send = [&]
    {
      ForPieces(outgoing[p].size(),
        [&](std::size_t first, int length)
        { controller->Send(outgoing[p].data() + first, length, peers[p], MessageTag); });
    };
    const auto receive = [&]
    {
      ForPieces(incoming[p].size(),
        [&](std::size_t first, int length)
        { controller->Receive(incoming[p].data() + first, length, peers[p], MessageTag); });
    };
    if (rank < peers[p])
    {
      send();
      receive();
    }
    else
    {
      receive();
      send();
    }
  }
}

} // namespace

ControllerRanks::ControllerRanks(vtkMultiProcessController* controller) : Controller(controller)
{
  if (controller)
  {
    this->MyRank = controller->GetLocalProcessId();
    this->NumberOfRanks = controller->GetNumberOfProcesses();
  }
}

void ControllerRanks::Transfer(
  const std::vector<int>& peers, const std::vector<Bytes>& outgoing, std::vector<Bytes>& incoming)
{
  if (vtkMPIController* mpi = vtkMPIController::SafeDownCast(this->Controller))
  {
    TransferAtOnce(mpi, peers, outgoing, incoming);
  }
  else
  {
    TransferInPairs(this->Controller, peers, outgoing, incoming);
  }
}

std::vector<Bytes> ControllerRanks::MakeIncoming(
  const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
{
  std::vector<Bytes> mySizes, theirSizes(peers.size(), Bytes(sizeof(std::int64_t)));
  for (const Bytes& bytes : outgoing)
  {
    mySizes.push_back(
      ToBytes(std::vector<std::int64_t>{ static_cast<std::int64_t>(bytes.size()) }));
  }
  this->Transfer(peers, mySizes, theirSizes);
  std::vector<Bytes> incoming;
  for (const Bytes& size : theirSizes)
  {
    incoming.emplace_back(static_cast<std::size_t>(FromBytes<std::int64_t>(size)[0]));
  }
  return incoming;
}

std::vector<Bytes> ControllerRanks::Exchange(
  const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
{
  if (peers.empty())
  {
    return {};
  }
  ++this->Sent.Exchanges;
  for (const Bytes& bytes : outgoing)
  {
    this->Sent.Messages += bytes.empty() ? 1 : 2;
    this->Sent.Bytes += static_cast<std::int64_t>(bytes.size() + sizeof(std::int64_t));
  }
  std::vector<Bytes> incoming = this->MakeIncoming(peers, outgoing);
  this->Transfer(peers, outgoing, incoming);
  return incoming;
}

std::vector<Bytes> ControllerRanks::Gather(const Bytes& mine)
{
  if (this->NumberOfRanks == 1)
  {
    return { mine };
  }
  ++this->Sent.Collectives;
  this->Sent.CollectiveBytes += static_cast<std::int64_t>(mine.size());
  const vtkIdType size = static_cast<vtkIdType>(mine.size());
  std::vector<vtkIdType> sizes(this->NumberOfRanks), offsets(this->NumberOfRanks + 1, 0);
  this->Controller->AllGather(&size, sizes.data(), 1);
  for (int rank = 0; rank < this->NumberOfRanks; ++rank)
  {
    offsets[rank + 1] = offsets[rank] + sizes[rank];
  }
  if (offsets.back() > std::numeric_limits<int>::max())
  {
    throw InputError("The ranks want to share " + std::to_string(offsets.back()) +
      " bytes with all others, more than MPI can count. Give each rank fewer blocks.");
  }
  Bytes all(offsets.back());
  this->Controller->AllGatherV(mine.data(), all.data(), size, sizes.data(), offsets.data());
  std::vector<Bytes> result;
  for (int rank = 0; rank < this->NumberOfRanks; ++rank)
  {
    result.emplace_back(all.begin() + offsets[rank], all.begin() + offsets[rank + 1]);
  }
  return result;
}

void ControllerRanks::Sum(std::vector<std::int64_t>& values)
{
  if (this->NumberOfRanks > 1 && !values.empty())
  {
    ++this->Sent.Collectives;
    this->Sent.CollectiveBytes += static_cast<std::int64_t>(values.size() * sizeof(values[0]));
    const std::vector<std::int64_t> mine = values;
    this->Controller->AllReduce(
      mine.data(), values.data(), static_cast<vtkIdType>(values.size()), vtkCommunicator::SUM_OP);
  }
}

double ControllerRanks::Max(double value)
{
  if (this->NumberOfRanks == 1)
  {
    return value;
  }
  ++this->Sent.Collectives;
  this->Sent.CollectiveBytes += sizeof(value);
  double greatest = value;
  this->Controller->AllReduce(&value, &greatest, 1, vtkCommunicator::MAX_OP);
  return greatest;
}

} // namespace vfm
