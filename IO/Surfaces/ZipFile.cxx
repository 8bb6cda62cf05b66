#include "Surfaces/ZipFile.h"

#include "Ranks/Errors.h"
#include "Surfaces/FileBytes.h"

#include <array>
#include <cstdint>

namespace vfm
{
namespace
{

constexpr std::size_t EndSize = 22, DirectorySize = 46, LocalSize = 30; // bytes of records
constexpr int RawBits = -15;
constexpr unsigned int Stored = 0, Deflated = 8;

[[noreturn]] void RejectZip(const std::string& problem)
{
  throw InputError("it is truncated or damaged: " + problem + ".");
}

template <class Value>
Value At(std::string_view bytes, std::size_t place)
{
  if (place > bytes.size() || bytes.size() - place < sizeof(Value))
  {
    RejectZip("its archive ends early");
  }
  return ReadBytesAs<Value>(bytes, place, false);
}

std::string_view Part(std::string_view bytes, std::size_t place, std::size_t size)
{
  if (place > bytes.size() || bytes.size() - place < size)
  {
    RejectZip("its archive ends early");
  }
  return bytes.substr(place, size);
}

/// Returns the checksum of the bytes as zip archives store it.
std::uint32_t FindChecksum(std::string_view bytes)
{
  static const std::array<std::uint32_t, 256> table = []
  {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t n = 0; n < 256; ++n)
    {
      made[n] = n;
      for (int bit = 0; bit < 8; ++bit)
      {
        made[n] = made[n] & 1 ? 0xedb88320u ^ made[n] >> 1 : made[n] >> 1;
      }
    }
    return made;
  }();
  std::uint32_t sum = 0xffffffffu;
  for (char c : bytes)
  {
    sum = table[(sum ^ static_cast<unsigned char>(c)) & 255] ^ sum >> 8;
  }
  return ~sum;
}

} // namespace

ZipFile::ZipFile(std::string_view bytes) : Bytes(bytes)
{
  const std::size_t end = bytes.rfind("PK\5\6");
  if (bytes.substr(0, 2) != "PK" || end == std::string_view::npos || bytes.size() - end < EndSize)
  {
    throw InputError("it is not a zip archive, or is truncated.");
  }
  const std::size_t count = At<std::uint16_t>(bytes, end + 10);
  std::size_t at = At<std::uint32_t>(bytes, end + 16);
  for (std::size_t e = 0; e < count; ++e)
  {
    if (At<std::uint32_t>(bytes, at) != 0x02014b50)
    {
      RejectZip("the list of the files of its archive is damaged");
    }
    const std::size_t name = At<std::uint16_t>(bytes, at + 28),
                      more = At<std::uint16_t>(bytes, at + 30),
                      comment = At<std::uint16_t>(bytes, at + 32);
    this->Entries[std::string(Part(bytes, at + DirectorySize, name))] = {
      At<std::uint16_t>(bytes, at + 10), At<std::uint16_t>(bytes, at + 8),
      At<std::uint32_t>(bytes, at + 16), At<std::uint32_t>(bytes, at + 20),
      At<std::uint32_t>(bytes, at + 24), At<std::uint32_t>(bytes, at + 42)
    };
    at += DirectorySize + name + more + comment;
  }
}

std::string ZipFile::FindEnding(const std::string& end) const
{
  for (const auto& [name, entry] : this->Entries)
  {
    if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
    {
      return name;
    }
  }
  return "";
}

std::string ZipFile::Read(const std::string& name, const SurfaceTools& tools) const
{
  const auto found = this->Entries.find(name);
  if (found == this->Entries.end())
  {
    RejectZip("its archive has no file " + name);
  }
  const Entry& entry = found->second;
  if ((entry.Flags & 1) != 0 || (entry.Method != Stored && entry.Method != Deflated))
  {
    throw InputError("the file " + name +
      " of its archive is encrypted, or compressed in another "
      "way than deflate.");
  }
  if (At<std::uint32_t>(this->Bytes, entry.Place) != 0x04034b50)
  {
    RejectZip("the file " + name + " of its archive has no begin");
  }
  const std::size_t begin = entry.Place + LocalSize +
    At<std::uint16_t>(this->Bytes, entry.Place + 26) +
    At<std::uint16_t>(this->Bytes, entry.Place + 28);
  const std::string_view packed = Part(this->Bytes, begin, entry.Packed);
  std::string bytes =
    entry.Method == Stored ? std::string(packed) : InflateAll(packed, RawBits, tools);
  if (bytes.size() != entry.Unpacked || FindChecksum(bytes) != entry.Checksum)
  {
    RejectZip("the file " + name + " of its archive does not have its checksum");
  }
  return bytes;
}

} // namespace vfm
