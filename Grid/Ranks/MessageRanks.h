/**
 * MessageRanks: ranks that send messages over a transport (MPI, threads).
 *
 * Waiting for a message is the only way of waiting for others. Each begins with a head, which tells its size or that the
 * sender has failed; small messages are in the head. Messages between two ranks stay in order, so each rank finds a failure at
 * the same place in every run. A rank that fails sends this head to all others and drops what they send until theirs comes; one that
 * receives it fails likewise. Then nothing is on its way. All this needs no memory. Ranks that are not in the same work, as one whose
 * failure was swallowed, fail too when they wait for each other.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <cstddef>

namespace vfm
{

/// Moves bytes between processes; those from one to another arrive in order. Nothing here throws.
class Transport
{
public:
  /// Bytes under way.
  struct Transfer
  {
    char* Data;
    std::size_t Size;
    int Other; ///< rank
    bool IsSent, IsDone;
    Transfer* Next;
    void* Request; ///< of the transport
  };

  virtual ~Transport() = default;
  /// Begins to send or to receive all of the bytes, at most LongestPiece; both must stay until Wait returns.
  virtual void Begin(Transfer& transfer) noexcept = 0;
  virtual void Wait(Transfer& transfer) noexcept = 0;
  /// Whether something from that rank can be received.
  virtual bool HasArrived(int from) noexcept = 0;

  static constexpr std::size_t LongestPiece = std::size_t(1) << 20;
};

class MessageRanks : public Ranks
{
public:
  /// The transport must outlive this.
  MessageRanks(Transport& transport, int rank, int count);
  MessageRanks(const MessageRanks&) = delete;
  MessageRanks& operator=(const MessageRanks&) = delete;
  int Rank() const override { return this->MyRank; }
  int Count() const override { return this->NumberOfRanks; }

  std::vector<Bytes> Exchange(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing) override;
  /// These take log2 P rounds of messages.
  std::vector<Bytes> Gather(const Bytes& mine) override;
  void Sum(std::vector<std::int64_t>& values) override;
  double Max(double value) override;

  bool Enter(Frame frame) noexcept override;
  void Leave() override;
  [[noreturn]] void Fail(const Failure& mine) override;

  /// What this rank sent since it was made. A gather counts with what it brings in, not with its messages.
  struct Traffic
  {
    std::int64_t Exchanges = 0, Messages = 0, MessageBytes = 0;
    std::int64_t Reductions = 0, Gathers = 0, GatheredBytes = 0;
  };
  const Traffic& Sent() const { return this->Counted; }

private:
  /// The begin of a message.
  struct Head
  {
    std::int64_t Size = 0;   ///< of the message
    std::int32_t Failed = 0; ///< else 1 + the frame that failed, and the message is a Failure
    std::int32_t Where = 0;  ///< the sender is: its frame, and whether it is about to leave it
    char Small[112] = {};    ///< the message, when it is not longer
    std::int64_t SizeAfter() const
    {
      return this->Size > std::int64_t(sizeof(this->Small)) ? this->Size : 0;
    }
  };
  class LargeMessages;
  class SmallMessages;

  std::vector<Bytes> Swap(const std::vector<int>& peers, const std::vector<Bytes>& outgoing);
  template <class Merge>
  void Combine(Bytes& mine, const Merge& merge);

  void Receive(void* data, std::size_t size, int from) noexcept;
  Head ReceiveHead(int from) noexcept;
  std::int32_t Where(bool isLeaving) const noexcept;
  bool IsFailure(const Head& head, std::int32_t where, int from) noexcept;
  void Drop(std::int64_t size, int from) noexcept;
  Head MakeFailedHead() const noexcept;
  void HearOfAll() noexcept;
  void Settle() noexcept;
  [[noreturn]] void ThrowKnown();

  Transport& Way;
  const int MyRank, NumberOfRanks;
  Frame Within = Frame::Inner;
  bool IsInFrame = false, HasFailed = false;
  std::int8_t HeardOfFew[4096] = {};    ///< there before any work begins
  std::vector<std::int8_t> HeardOfMany; ///< in place of these, where ranks are more
  std::int8_t* Heard; ///< by rank, while this one fails: Head::Failed of its last head
  Failure Known;      ///< what is known of the failure
  Traffic Counted;
};

} // namespace vfm
