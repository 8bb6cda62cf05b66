#include "VtkFiles/PackedBlocks.h"

#include "InputTrust.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <new>
#include <zlib.h>

namespace vfm
{
namespace
{

constexpr std::int64_t MostBytes = std::int64_t(1) << 50; // in an array
constexpr std::size_t BufferSize = 1 << 16;

[[noreturn]] void RejectLength()
{
  throw InputError("has fewer compressed bytes than its header says: the file ends.");
}

/// State and buffers of zlib.
struct Inflater
{
  Inflater()
  {
    if (inflateInit(&this->State) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { inflateEnd(&this->State); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream State{};
  std::vector<unsigned char> From = std::vector<unsigned char>(BufferSize);
  std::vector<unsigned char> To = std::vector<unsigned char>(BufferSize);
};

/// Unpacks a block. Returns whether it has the size.
bool Inflate(Inflater& inflater, StoredBytes& stored, std::int64_t packed, std::int64_t size,
  const TakeBytes& take)
{
  z_stream& state = inflater.State;
  std::int64_t found = 0;
  int result = inflateReset(&state);
  while (packed > 0)
  {
    const auto part = std::min<std::size_t>(BufferSize, static_cast<std::size_t>(packed));
    if (stored.Read(inflater.From.data(), part) < part)
    {
      RejectLength();
    }
    packed -= static_cast<std::int64_t>(part);
    state.next_in = inflater.From.data();
    state.avail_in = static_cast<unsigned>(part);
    do
    {
      state.next_out = inflater.To.data();
      state.avail_out = static_cast<unsigned>(BufferSize);
      result = result == Z_STREAM_END ? result : inflate(&state, Z_NO_FLUSH);
      const std::size_t count = BufferSize - state.avail_out;
      found += static_cast<std::int64_t>(count);
      if ((result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) || found > size)
      {
        return false;
      }
      take(inflater.To.data(), count);
    } while (result != Z_STREAM_END && state.avail_out == 0);
  }
  return result == Z_STREAM_END && found == size;
}

} // namespace

std::int64_t ReadVtkLength(StoredBytes& stored, const VtkStorage& storage)
{
  unsigned char bytes[8];
  const std::size_t size = storage.HeaderSize;
  if (stored.Read(bytes, size) < size)
  {
    throw InputError("ends inside its header.");
  }
  std::uint64_t value = 0;
  for (std::size_t b = 0; b < size; ++b)
  {
    value = value << 8 | bytes[storage.IsBigEndian ? b : size - 1 - b];
  }
  if (value > static_cast<std::uint64_t>(MostBytes))
  {
    throw InputError("has a length of " + std::to_string(value) + " bytes.");
  }
  return static_cast<std::int64_t>(value);
}

PackedBlocks::PackedBlocks(StoredBytes& stored, const VtkStorage& storage) :
  Stored(stored), Storage(storage)
{
  const std::int64_t blocks = ReadVtkLength(stored, storage);
  this->Size = ReadVtkLength(stored, storage);
  const std::int64_t last = ReadVtkLength(stored, storage), left = stored.CountLeft();
  if (blocks > left / storage.HeaderSize || last > this->Size)
  {
    throw InputError("has a header that contradicts itself.");
  }
  this->Last = last > 0 ? last : this->Size;
  const double bytes = blocks == 0
    ? 0.0
    : static_cast<double>(blocks - 1) * static_cast<double>(this->Size) +
      static_cast<double>(this->Last);
  const bool isTrusted = InputTrust::IsGiven() && bytes <= static_cast<double>(MostBytes);
  if (bytes > storage.LargestRatio * static_cast<double>(left) && !isTrusted)
  {
    throw InputError("has more values than its compressed data can contain.");
  }
  this->Unpacked = static_cast<std::int64_t>(bytes);
  this->Sizes.resize(static_cast<std::size_t>(blocks));
  this->ReadSizes();
}

void PackedBlocks::ReadSizes()
{
  for (std::int64_t& size : this->Sizes)
  {
    size = ReadVtkLength(this->Stored, this->Storage);
  }
  this->Stored.BeginText();
  std::int64_t left = this->Stored.CountLeft();
  for (std::int64_t size : this->Sizes)
  {
    left -= size;
    if (left < 0)
    {
      RejectLength();
    }
  }
}

void PackedBlocks::Unpack(const TakeBytes& take)
{
  const bool isZlib = this->Storage.Compressor == "vtkZLibDataCompressor";
  Inflater inflater;
  for (std::size_t b = 0; b < this->Sizes.size(); ++b)
  {
    const std::int64_t size = b + 1 < this->Sizes.size() ? this->Size : this->Last;
    const bool isIntact = isZlib ? Inflate(inflater, this->Stored, this->Sizes[b], size, take)
                                 : this->UnpackWhole(this->Sizes[b], size, take);
    if (!isIntact)
    {
      throw InputError("has damaged compressed values in block " + std::to_string(b + 1) + " of " +
        std::to_string(this->Sizes.size()) + ", which begins at byte " +
        std::to_string(static_cast<std::int64_t>(b) * this->Size) + " of the values.");
    }
  }
}

/// Unpacks a block by another compressor.
bool PackedBlocks::UnpackWhole(std::int64_t packed, std::int64_t size, const TakeBytes& take)
{
  if (!this->Storage.Unpack)
  {
    return this->Stored.Skip(packed);
  }
  std::vector<unsigned char> from(static_cast<std::size_t>(packed)),
    to(static_cast<std::size_t>(size));
  if (this->Stored.Read(from.data(), from.size()) < from.size())
  {
    RejectLength();
  }
  if (!this->Storage.Unpack(this->Storage.Compressor, from, to))
  {
    return false;
  }
  take(to.data(), to.size());
  return true;
}

} // namespace vfm
