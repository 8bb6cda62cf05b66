#include "GridFiles/PackedBlocks.h"

#include "InputTrust.h"
#include "Ranks/Errors.h"

namespace vfm
{
namespace
{

constexpr std::int64_t MostBytes = std::int64_t(1) << 50; // in an array

[[noreturn]] void RejectLength()
{
  throw InputError("has fewer compressed bytes than its header says: the file ends.");
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
  std::vector<unsigned char> packed, unpacked;
  for (std::size_t b = 0; b < this->Sizes.size(); ++b)
  {
    const bool isLast = b + 1 == this->Sizes.size();
    packed.resize(static_cast<std::size_t>(this->Sizes[b]));
    unpacked.resize(static_cast<std::size_t>(isLast ? this->Last : this->Size));
    if (this->Stored.Read(packed.data(), packed.size()) < packed.size())
    {
      RejectLength();
    }
    if (!this->Storage.Unpack(this->Storage.Compressor, packed, unpacked))
    {
      throw InputError("has damaged compressed values in block " + std::to_string(b + 1) + " of " +
        std::to_string(this->Sizes.size()) + ", which begins at byte " +
        std::to_string(static_cast<std::int64_t>(b) * this->Size) + " of the values.");
    }
    take(unpacked.data(), unpacked.size());
  }
}

} // namespace vfm
