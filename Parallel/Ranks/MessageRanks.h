/**
 * MessageRanks: ranks that exchange messages over a transport such as MPI or threads.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <cstddef>

namespace vfm
{

/// Transport of bytes between ranks. Bytes from one rank to another arrive in
/// order. No function throws.
class Transport
{
public:
  /// State of bytes that are being sent or received.
  struct Transfer
  {
    char* Data;
    std::size_t Size;
    int Other; ///< the other rank
    bool IsSent, IsDone;
    Transfer* Next;
    void* Request; ///< data of the transport
  };

  virtual ~Transport() = default;
  /// Begins to send or to receive at most LongestPiece bytes. The transfer and its bytes must not
  /// move before Wait returns.
  virtual void Begin(Transfer& transfer) noexcept = 0;
  /// Waits until a transfer is complete.
  virtual void Wait(Transfer& transfer) noexcept = 0;
  /// Returns whether bytes from a rank can be received without waiting.
  virtual bool HasArrived(int from) noexcept = 0;

  static constexpr std::size_t LongestPiece = std::size_t(1) << 20;
};

/// Ranks on a transport. Ranks wait for each other only by waiting for messages. Each
/// message begins with a head that holds its size, or says that the sender failed. Small
/// messages are inside the head.
///
/// Failures. A rank that fails sends a failure head to all others and discards their messages until
/// each has replied with a failure head. A rank that receives one fails with the same error.
/// Afterwards no message is under way. This needs no memory. Messages between two ranks keep their
/// order, so each rank detects a failure at the same place in every run. If an error was swallowed,
/// ranks can be in different frames; they fail too as soon as one waits for the other.
class MessageRanks : public Ranks
{
public:
  /// @param transport  must outlive this object
  /// @param rank,count  number of this rank and of ranks
  MessageRanks(Transport& transport, int rank, int count);
  MessageRanks(const MessageRanks&) = delete;
  MessageRanks& operator=(const MessageRanks&) = delete;
  int Rank() const override { return this->MyRank; }
  int Count() const override { return this->NumberOfRanks; }

  std::vector<Bytes> Exchange(
    const std::vector<int>& peers, const std::vector<Bytes>& outgoing) override;
  /// Gather, Sum and Max take log2 P rounds of messages on P ranks.
  std::vector<Bytes> Gather(const Bytes& mine) override;
  void Sum(std::vector<std::int64_t>& values) override;
  using Ranks::Max;
  void Max(std::vector<double>& values) override;

  bool Enter(Frame frame) noexcept override;
  void Leave() override;
  [[noreturn]] void Fail(const Failure& mine) override;

  /// Communication of this rank since construction. A gather is counted by the bytes that it
  /// returns, and a reduction by those that it reduces, not by their messages.
  struct Traffic
  {
    std::int64_t Exchanges = 0, Messages = 0, MessageBytes = 0;
    std::int64_t Reductions = 0, ReducedBytes = 0, Gathers = 0, GatheredBytes = 0;
  };
  const Traffic& Sent() const { return this->Counted; }

private:
  /// Begin of a message.
  struct Head
  {
    std::int64_t Size = 0;   ///< size of the message in bytes
    std::int32_t Failed = 0; ///< 0, or 1 + the frame that failed; then the message is a Failure
    std::int32_t Where = 0;  ///< 2 * frame of the sender, + 1 if the sender is leaving it
    char Small[112] = {};    ///< the message, if it fits
    /// Returns the number of bytes that follow the head.
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
  template <class Value, class Join>
  void Reduce(std::vector<Value>& values, const Join& join);

  void Receive(void* data, std::size_t size, int from) noexcept;
  Head ReceiveHead(int from) noexcept;
  std::int32_t Where(bool isLeaving) const noexcept;
  bool IsFailure(const Head& head, std::int32_t where, int from) noexcept;
  void Drop(std::int64_t size, int from) noexcept;
  Head MakeFailedHead() const noexcept;
  void ReceiveFromAll() noexcept;
  void Settle() noexcept;
  [[noreturn]] void ThrowKnown();

  Transport& Way;
  const int MyRank, NumberOfRanks;
  Frame Within = Frame::Inner;
  bool IsInFrame = false, HasFailed = false;
  std::int8_t HeardOfFew[4096] = {};    ///< memory of Heard, allocated before any work
  std::vector<std::int8_t> HeardOfMany; ///< memory of Heard if there are more ranks
  std::int8_t* Heard; ///< while this rank fails: Head::Failed of the last head from each rank
  Failure Known;      ///< smallest failure known so far
  Traffic Counted;
};

} // namespace vfm
