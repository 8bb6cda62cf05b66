/**
 * ControllerRanks: the processes of a vtkMultiProcessController as the Ranks of the Grid code.
 *
 * No controller, or a controller of one process, is the serial program. With a vtkMPIController, Exchange is
 * non-blocking point-to-point; with any other it sends and receives pair by pair, the pairs in one global order.
 * Messages and bytes are counted.
 */
#pragma once

#include "Base/Ranks.h"

class vtkMultiProcessController;

namespace vfm
{

class ControllerRanks : public Ranks
{
public:
  /// The controller must outlive this; null for one process.
  explicit ControllerRanks(vtkMultiProcessController* controller);
  int Rank() const override { return this->MyRank; }
  int Count() const override { return this->NumberOfRanks; }

  /// Messages of any size: large ones go in pieces.
  std::vector<Bytes> Exchange(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing) override;
  /// Throws InputError on all ranks when all bytes together exceed 2^31 - 1, which is more than MPI can count.
  std::vector<Bytes> Gather(const Bytes& mine) override;
  void Sum(std::vector<std::int64_t>& values) override;
  double Max(double value) override;

  /// What this rank gave away since it was made.
  struct Traffic
  {
    std::int64_t Exchanges = 0, Messages = 0, Bytes = 0; ///< point-to-point
    std::int64_t Collectives = 0, CollectiveBytes = 0;
  };
  const Traffic& GetTraffic() const { return this->Sent; }

private:
  std::vector<Bytes> MakeIncoming(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing);
  void Transfer(const std::vector<int>& peers, const std::vector<Bytes>& outgoing,
    std::vector<Bytes>& incoming);

  vtkMultiProcessController* Controller;
  int MyRank = 0, NumberOfRanks = 1;
  Traffic Sent;
};

} // namespace vfm
