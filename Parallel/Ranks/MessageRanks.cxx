#include "Ranks/MessageRanks.h"

#include <algorithm>
#include <array>
#include <new>
#include <thread>

namespace vfm
{
namespace
{

constexpr std::int8_t Settled = -1; // in Heard: the rank knows that this rank failed

/// Calls transfer(first byte, size) for the pieces of a message.
template <class Transfer>
void ForPieces(std::size_t size, const Transfer& transfer)
{
  for (std::size_t first = 0; first < size; first += Transport::LongestPiece)
  {
    transfer(first, std::min(Transport::LongestPiece, size - first));
  }
}

std::size_t CountPieces(std::size_t size)
{
  return (size + Transport::LongestPiece - 1) / Transport::LongestPiece;
}

Transport::Transfer MakeTransfer(const void* data, std::size_t size, int other, bool isSent)
{
  char* bytes = const_cast<char*>(static_cast<const char*>(data));
  return { bytes, size, other, isSent, false, nullptr, nullptr };
}

void AddItem(std::int64_t rank, const Bytes& item, Bytes& list)
{
  const std::int64_t numbers[2] = { rank, static_cast<std::int64_t>(item.size()) };
  const std::size_t size = list.size();
  list.resize(size + sizeof(numbers) + item.size());
  std::memcpy(list.data() + size, numbers, sizeof(numbers));
  std::copy(item.begin(), item.end(), list.begin() + size + sizeof(numbers));
}

std::vector<Bytes> TakeItems(const Bytes& list, int count)
{
  std::vector<Bytes> items(count);
  for (auto at = list.begin(); at != list.end();)
  {
    std::int64_t numbers[2]; // rank and size
    std::memcpy(numbers, &*at, sizeof(numbers));
    at += sizeof(numbers);
    items[numbers[0]].assign(at, at + numbers[1]);
    at += numbers[1];
  }
  return items;
}

} // namespace

/// Messages that this rank sends to its peers and receives from them. All memory for sending is
/// allocated before the first message is sent.
class MessageRanks::LargeMessages
{
public:
  LargeMessages(Transport& way, const std::vector<int>& peers, const std::vector<Bytes>& outgoing,
    std::int32_t where) :
    Way(way), Peers(peers), Heads(peers.size()), Incoming(peers.size())
  {
    std::size_t pieces = 0;
    for (std::size_t p = 0; p < peers.size(); ++p)
    {
      this->Heads[p].Size = static_cast<std::int64_t>(outgoing[p].size());
      this->Heads[p].Where = where;
      pieces += 1 + CountPieces(this->Heads[p].SizeAfter());
      if (!outgoing[p].empty() && this->Heads[p].SizeAfter() == 0)
      {
        std::memcpy(this->Heads[p].Small, outgoing[p].data(), outgoing[p].size());
      }
    }
    this->Sends.reserve(pieces);
    for (std::size_t p = 0; p < peers.size(); ++p)
    {
      this->Add(&this->Heads[p], sizeof(Head), peers[p], true, this->Sends);
      this->Add(outgoing[p].data(), this->Heads[p].SizeAfter(), peers[p], true, this->Sends);
    }
    this->Received.resize(peers.size());
  }

  void Begin() noexcept { this->BeginAll(this->Sends); }
  void WaitForSent() noexcept { this->WaitForAll(this->Sends); }

  /// Receives the messages that belong to the heads in Received.
  std::vector<Bytes> Receive()
  {
    std::vector<Transport::Transfer> pieces;
    for (std::size_t p = 0; p < this->Peers.size(); ++p)
    {
      const Head& head = this->Received[p];
      Bytes& bytes = this->Incoming[p];
      bytes.assign(head.Small, head.Small + (head.SizeAfter() ? 0 : head.Size));
      bytes.resize(static_cast<std::size_t>(head.Size));
      this->Add(bytes.data(), head.SizeAfter(), this->Peers[p], false, pieces);
    }
    this->BeginAll(pieces);
    this->WaitForAll(pieces);
    return std::move(this->Incoming);
  }

  std::vector<Head> Received; ///< head from each peer

private:
  static void Add(const void* data, std::size_t size, int other, bool isSent,
    std::vector<Transport::Transfer>& transfers)
  {
    ForPieces(size,
      [&](std::size_t first, std::size_t length)
      {
        transfers.push_back(
          MakeTransfer(static_cast<const char*>(data) + first, length, other, isSent));
      });
  }
  void BeginAll(std::vector<Transport::Transfer>& transfers) noexcept
  {
    for (Transport::Transfer& transfer : transfers)
    {
      this->Way.Begin(transfer);
    }
  }
  void WaitForAll(std::vector<Transport::Transfer>& transfers) noexcept
  {
    for (Transport::Transfer& transfer : transfers)
    {
      this->Way.Wait(transfer);
    }
  }

  Transport& Way;
  const std::vector<int>& Peers;
  std::vector<Head> Heads; // heads to each peer
  std::vector<Transport::Transfer> Sends;
  std::vector<Bytes> Incoming;
};

/// Sends messages to any number of ranks without allocating memory. At most 128 messages are under
/// way at a time; beyond that it relies on the transport to buffer a few kB.
class MessageRanks::SmallMessages
{
public:
  explicit SmallMessages(Transport& way) : Way(way) {}
  ~SmallMessages()
  {
    for (std::size_t i = 0; i < std::min(this->Count, this->Slots.size()); ++i)
    {
      this->Way.Wait(this->Slots[i]);
    }
  }
  SmallMessages(const SmallMessages&) = delete;
  SmallMessages& operator=(const SmallMessages&) = delete;

  /// Begins to send data, which must not change before this object is destroyed.
  void Send(const void* data, std::size_t size, int to) noexcept
  {
    Transport::Transfer& slot = this->Slots[this->Count % this->Slots.size()];
    if (this->Count++ >= this->Slots.size())
    {
      this->Way.Wait(slot);
    }
    slot = MakeTransfer(data, size, to, true);
    this->Way.Begin(slot);
  }

private:
  Transport& Way;
  std::array<Transport::Transfer, 128> Slots;
  std::size_t Count = 0;
};

MessageRanks::MessageRanks(Transport& transport, int rank, int count) :
  Way(transport), MyRank(rank), NumberOfRanks(count), Heard(this->HeardOfFew)
{
  if (static_cast<std::size_t>(count) > sizeof(this->HeardOfFew))
  {
    this->HeardOfMany.resize(count, 0);
    this->Heard = this->HeardOfMany.data();
  }
}

void MessageRanks::Receive(void* data, std::size_t size, int from) noexcept
{
  Transport::Transfer transfer = MakeTransfer(data, size, from, false);
  this->Way.Begin(transfer);
  this->Way.Wait(transfer);
}

/// Receives a head. If it reports a failure, receives and stores that too.
MessageRanks::Head MessageRanks::ReceiveHead(int from) noexcept
{
  Head head;
  this->Receive(&head, sizeof(head), from);
  if (head.Failed)
  {
    Failure told;
    this->Receive(&told, sizeof(told), from);
    this->Heard[from] = static_cast<std::int8_t>(head.Failed);
    const bool isInside = head.Failed > this->MakeFailedHead().Failed;
    if (this->Known.Rank == Failure::NoRank || (!isInside && told < this->Known))
    {
      this->Known = told;
    }
  }
  return head;
}

std::int32_t MessageRanks::Where(bool isLeaving) const noexcept
{
  return 2 * static_cast<std::int32_t>(this->Within) + isLeaving;
}

/// Returns whether the sender failed or is in another frame than this rank, which is
/// stored as a failure.
bool MessageRanks::IsFailure(const Head& head, std::int32_t where, int from) noexcept
{
  const bool isElsewhere = !head.Failed && head.Where != where;
  if (isElsewhere && this->Known.Rank == Failure::NoRank)
  {
    char text[128];
    const int first = std::min(from, this->MyRank), second = std::max(from, this->MyRank);
    std::snprintf(text, sizeof(text),
      "Ranks %d and %d are in different collective steps: one of them failed without reporting it.",
      first, second);
    this->Known = Failure(first, ErrorCode::Unknown, text);
  }
  return head.Failed || isElsewhere;
}

void MessageRanks::Drop(std::int64_t size, int from) noexcept
{
  ForPieces(static_cast<std::size_t>(size),
    [&](std::size_t, std::size_t length) { this->Receive(nullptr, length, from); });
}

MessageRanks::Head MessageRanks::MakeFailedHead() const noexcept
{
  Head head;
  head.Size = sizeof(Failure);
  head.Failed = 1 + static_cast<std::int32_t>(this->Within);
  return head;
}

/// Discards messages until every rank has reported that it failed. It receives from all ranks at
/// once, because a rank may be waiting until another rank receives its message.
void MessageRanks::ReceiveFromAll() noexcept
{
  for (bool isWaiting = true; isWaiting;)
  {
    isWaiting = false;
    for (int other = 0; other < this->NumberOfRanks; ++other)
    {
      if (other == this->MyRank || this->Heard[other] != 0)
      {
        continue;
      }
      isWaiting = true;
      if (this->Way.HasArrived(other))
      {
        const Head head = this->ReceiveHead(other);
        this->Drop(head.Failed ? 0 : head.SizeAfter(), other);
      }
    }
    std::this_thread::yield();
  }
}

/// Sends the known failure to all other ranks and waits until all have reported theirs. A rank that
/// fails in a frame inside this one is sent the failure again, until it fails in the frame of this
/// rank. From all failures reported in one frame, all ranks select the same one.
void MessageRanks::Settle() noexcept
{
  const Failure told = this->Known;
  const Head head = this->MakeFailedHead();
  for (bool again = true; again;)
  {
    again = false;
    SmallMessages messages(this->Way);
    for (int other = 0; other < this->NumberOfRanks; ++other)
    {
      if (other != this->MyRank && this->Heard[other] != Settled)
      {
        messages.Send(&head, sizeof(head), other);
        messages.Send(&told, sizeof(told), other);
      }
    }
    this->ReceiveFromAll();
    for (int other = 0; other < this->NumberOfRanks; ++other)
    {
      const bool isInside = this->Heard[other] > head.Failed;
      this->Heard[other] = isInside ? 0 : Settled;
      again = again || isInside;
    }
  }
  std::fill_n(this->Heard, this->NumberOfRanks, 0);
  this->HasFailed = this->IsInFrame;
}

void MessageRanks::ThrowKnown()
{
  const InputError error(this->Known);
  if (!this->IsInFrame)
  {
    this->Known = Failure();
  }
  throw error;
}

bool MessageRanks::Enter(Frame frame) noexcept
{
  if (this->IsInFrame)
  {
    return false;
  }
  this->IsInFrame = true;
  this->Within = frame;
  return true;
}

/// Waits until all ranks have reached the end of the frame (a dissemination barrier).
/// It needs no memory.
void MessageRanks::Leave()
{
  for (int step = 1; step < this->NumberOfRanks; step *= 2)
  {
    Head mine;
    mine.Where = this->Where(true);
    SmallMessages messages(this->Way);
    messages.Send(&mine, sizeof(mine), (this->MyRank + step) % this->NumberOfRanks);
    const int from = (this->MyRank - step + this->NumberOfRanks) % this->NumberOfRanks;
    const Head head = this->ReceiveHead(from);
    if (this->IsFailure(head, mine.Where, from))
    {
      this->Drop(head.Failed ? 0 : head.SizeAfter(), from);
      this->Settle();
      this->ThrowKnown();
    }
  }
  this->IsInFrame = false;
  this->Within = Frame::Inner;
}

void MessageRanks::Fail(const Failure& mine)
{
  if (!this->HasFailed)
  {
    this->Known = mine;
    this->Settle();
  }
  this->IsInFrame = this->HasFailed = false;
  this->Within = Frame::Inner;
  this->ThrowKnown();
}

std::vector<Bytes> MessageRanks::Swap(
  const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
{
  if (this->HasFailed)
  {
    this->ThrowKnown();
  }
  const std::int32_t where = this->Where(false);
  LargeMessages messages(this->Way, peers, outgoing, where);
  messages.Begin();
  bool failed = false;
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    messages.Received[p] = this->ReceiveHead(peers[p]);
    failed = this->IsFailure(messages.Received[p], where, peers[p]) || failed;
  }
  try
  {
    std::vector<Bytes> incoming;
    if (!failed)
    {
      incoming = messages.Receive();
      messages.WaitForSent();
      return incoming;
    }
  }
  catch (const std::bad_alloc&) // before anything was received
  {
    this->Known = LackOfMemory(this->MyRank, this->NumberOfRanks);
  }
  for (std::size_t p = 0; p < peers.size(); ++p)
  {
    const Head& head = messages.Received[p];
    this->Drop(head.Failed ? 0 : head.SizeAfter(), peers[p]);
  }
  this->Settle();
  messages.WaitForSent();
  this->ThrowKnown();
}

std::vector<Bytes> MessageRanks::Exchange(
  const std::vector<int>& peers, const std::vector<Bytes>& outgoing)
{
  if (peers.empty())
  {
    return {};
  }
  ++this->Counted.Exchanges;
  for (const Bytes& bytes : outgoing)
  {
    ++this->Counted.Messages;
    this->Counted.MessageBytes += static_cast<std::int64_t>(bytes.size());
  }
  return this->Swap(peers, outgoing);
}

/// Merges the bytes of all ranks by recursive doubling. Ranks beyond the largest power of two take
/// part through one rank below it.
/// @param merge  merge(bytes, others) must not depend on the order
template <class Merge>
void MessageRanks::Combine(Bytes& mine, const Merge& merge)
{
  int whole = 1;
  while (2 * whole <= this->NumberOfRanks)
  {
    whole *= 2;
  }
  const auto swap = [this](int peer, const Bytes& bytes)
  { return std::move(this->Swap({ peer }, { bytes })[0]); };
  if (this->MyRank >= whole)
  {
    swap(this->MyRank - whole, mine);
    mine = swap(this->MyRank - whole, {});
    return;
  }
  const bool hasGuest = this->MyRank + whole < this->NumberOfRanks;
  if (hasGuest)
  {
    merge(mine, swap(this->MyRank + whole, {}));
  }
  for (int step = 1; step < whole; step *= 2)
  {
    merge(mine, swap(this->MyRank ^ step, mine));
  }
  if (hasGuest)
  {
    swap(this->MyRank + whole, mine);
  }
}

std::vector<Bytes> MessageRanks::Gather(const Bytes& mine)
{
  ++this->Counted.Gathers;
  Bytes list;
  AddItem(this->MyRank, mine, list);
  this->Combine(list,
    [](Bytes& all, const Bytes& others) { all.insert(all.end(), others.begin(), others.end()); });
  std::vector<Bytes> items = TakeItems(list, this->NumberOfRanks);
  for (const Bytes& item : items)
  {
    this->Counted.GatheredBytes += static_cast<std::int64_t>(item.size());
  }
  return items;
}

/// Replaces each value by join of the values of all ranks.
template <class Value, class Join>
void MessageRanks::Reduce(std::vector<Value>& values, const Join& join)
{
  if (values.empty())
  {
    return;
  }
  Bytes bytes = ToBytes(values);
  ++this->Counted.Reductions;
  this->Counted.ReducedBytes += static_cast<std::int64_t>(bytes.size());
  this->Combine(bytes,
    [&join](Bytes& mine, const Bytes& others)
    {
      std::vector<Value> joined = FromBytes<Value>(mine);
      const std::vector<Value> theirs = FromBytes<Value>(others);
      std::transform(joined.begin(), joined.end(), theirs.begin(), joined.begin(), join);
      mine = ToBytes(joined);
    });
  values = FromBytes<Value>(bytes);
}

void MessageRanks::Sum(std::vector<std::int64_t>& values)
{
  this->Reduce(values, std::plus<std::int64_t>());
}

void MessageRanks::Max(std::vector<double>& values)
{
  this->Reduce(values, [](double a, double b) { return std::max(a, b); });
}

} // namespace vfm
