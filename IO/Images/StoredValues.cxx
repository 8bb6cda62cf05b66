#include "Images/StoredValues.h"

#include "Images/ImagePlace.h"
#include "NamedFile.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <zlib.h>

namespace vfm
{
namespace
{

/// Data of a file behind a given byte, read in ascending order of positions.
class ByteStream
{
public:
  ByteStream(const std::string& path, Index begin, bool isCompressed) :
    Stream(OpenFile(path)), IsCompressed(isCompressed)
  {
    this->Stream.seekg(begin);
    constexpr int either = 32 + MAX_WBITS; // zlib or gzip
    if (isCompressed && inflateInit2(&this->Packed, either) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~ByteStream()
  {
    if (this->IsCompressed)
    {
      inflateEnd(&this->Packed);
    }
  }
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// Reads `count` bytes.
  /// @param position  place in the uncompressed data; not before the end of the last read
  void Read(Index position, char* to, Index count)
  {
    if (!this->IsCompressed)
    {
      this->Stream.seekg(position - this->Position, std::ios::cur);
      this->Position = position;
    }
    std::vector<char> skipped(position > this->Position ? BufferSize : 0);
    while (this->Position < position)
    {
      this->Inflate(skipped.data(), std::min<Index>(BufferSize, position - this->Position));
    }
    if (this->IsCompressed)
    {
      this->Inflate(to, count);
    }
    else if (!this->Stream.read(to, count))
    {
      throw InputError("its values are truncated.");
    }
    this->Position = position + count;
  }

private:
  static constexpr Index BufferSize = 1 << 16;

  void Inflate(char* to, Index count)
  {
    constexpr Index most = 1 << 30; // fits an unsigned of zlib
    for (Index done = 0; done < count;)
    {
      const Index part = std::min(count - done, most);
      this->InflatePart(to + done, static_cast<unsigned>(part));
      done += part;
    }
    this->Position += count;
  }
  void InflatePart(char* to, unsigned count)
  {
    this->Packed.next_out = reinterpret_cast<unsigned char*>(to);
    this->Packed.avail_out = count;
    while (this->Packed.avail_out > 0)
    {
      if (this->Packed.avail_in == 0)
      {
        this->Stream.read(this->Buffer.data(), BufferSize);
        this->Packed.next_in = reinterpret_cast<unsigned char*>(this->Buffer.data());
        this->Packed.avail_in = static_cast<unsigned>(this->Stream.gcount());
      }
      const bool isAtEnd = this->Packed.avail_in == 0;
      const int state = inflate(&this->Packed, Z_NO_FLUSH);
      if (state == Z_STREAM_END) // another stream may follow, as written by bgzip and pigz
      {
        inflateReset(&this->Packed);
      }
      else if (isAtEnd || state != Z_OK)
      {
        throw InputError(
          isAtEnd ? "its compressed values are truncated." : "its compressed values are damaged.");
      }
    }
  }

  std::ifstream Stream;
  bool IsCompressed;
  Index Position = 0; // place in the uncompressed data
  z_stream Packed{};
  std::vector<char> Buffer = std::vector<char>(BufferSize);
};

/// Returns the beginning of messages about a file.
std::string NameFile(const StoredValues& stored, const std::string& file)
{
  return stored.AreDetached ? "its data file " + file + ": " : "";
}

} // namespace

std::vector<std::string> ListNumberedFiles(
  const std::string& pattern, Index first, Index last, Index step, Index most)
{
  const std::size_t percent = pattern.find('%');
  const std::size_t end =
    percent == std::string::npos ? percent : pattern.find_first_not_of("0123456789", percent + 1);
  const bool isNumber = end != std::string::npos && pattern[end] == 'd' && end < percent + 5 &&
    pattern.find('%', end) == std::string::npos;
  constexpr Index largest = std::numeric_limits<int>::max();
  const bool areInt = std::max({ std::abs(first), std::abs(last), std::abs(step) }) <= largest;
  const bool reachesLast = step > 0 ? last >= first : step < 0 && last <= first;
  const Index count = areInt && reachesLast ? (last - first) / step + 1 : 0;
  if (!isNumber || count < 1 || count > most)
  {
    throw InputError(
      "its pattern of files '" + pattern.substr(0, 80) + "' does not name a file for each slice.");
  }
  std::vector<std::string> files;
  for (Index i = 0; i < count; ++i)
  {
    char number[1024];
    std::snprintf(number, sizeof(number), pattern.substr(percent, end + 1 - percent).c_str(),
      static_cast<int>(first + i * step));
    files.push_back(pattern.substr(0, percent) + number + pattern.substr(end + 1));
  }
  return files;
}

void CheckFiles(const StoredValues& stored, const Index3& size)
{
  const Index files = static_cast<Index>(stored.Files.size());
  if (files == 0 || size[2] % files != 0)
  {
    throw InputError("it has " + std::to_string(size[2]) + " slices in " + std::to_string(files) +
      " files; each file must hold the same number of slices.");
  }
  const Index skip = stored.AreCompressed ? 0 : stored.Skip;
  for (const std::string& file : stored.Files)
  {
    PrefixErrors(NameFile(stored, file),
      [&]
      {
        OpenFile(file);
        CheckLength(
          file, stored.Begin + skip, stored.CountBytes(size) / files, stored.AreCompressed);
      });
  }
}

void SetFiles(const std::string& header, Index length, const std::vector<std::string>& names,
  StoredValues& stored)
{
  stored.AreDetached = !names.empty();
  for (const std::string& name : names)
  {
    stored.Files.push_back(FindNamedFile(header, name));
  }
  if (names.empty())
  {
    if (length == 0)
    {
      throw InputError("its header names no data file and does not end, so it has no values.");
    }
    stored.Files = { header };
    stored.Begin = length;
  }
}

void PlaceAtEnd(const Index3& size, StoredValues& stored)
{
  if (stored.Files.size() != 1 || stored.AreCompressed)
  {
    throw InputError("values at the end of a file (skip -1) require one file without compression.");
  }
  PrefixErrors(NameFile(stored, stored.Files[0]),
    [&]
    {
      CheckLength(stored.Files[0], stored.Begin, stored.CountBytes(size), false);
      stored.Begin = GetFileLength(stored.Files[0]) - stored.CountBytes(size);
    });
}

TypedValues ReadStored(const StoredValues& stored, const Index3& size, const IndexBox& box)
{
  TypedValues values = MakeValues("", stored.Type, box.NumberOfCells());
  const Index width = WidthOfType(stored.Type), row = box.Size(0) * width;
  const Index slices = size[2] / static_cast<Index>(stored.Files.size());
  std::unique_ptr<ByteStream> stream;
  Index open = -1; // index of the open file
  char* to = values.Bytes.data();
  ForRows(box,
    [&](Index j, Index k)
    {
      const std::string& file = stored.Files[k / slices];
      PrefixErrors(NameFile(stored, file),
        [&]
        {
          if (k / slices != open)
          {
            open = k / slices;
            stream = std::make_unique<ByteStream>(file, stored.Begin, stored.AreCompressed);
          }
          const Index first = ((k % slices) * size[1] + j) * size[0] + box.Lower[0];
          stream->Read(stored.Skip + first * width, to, row);
        });
      to += row;
    });
  VisitType(stored.Type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      Value* first = reinterpret_cast<Value*>(values.Bytes.data());
      for (Index i = 0; stored.AreSwapped && i < box.NumberOfCells(); ++i)
      {
        first[i] = SwapBytes(first[i]);
      }
    });
  return values;
}

} // namespace vfm
