#include "Images/StoredValues.h"

#include "Images/ImagePlace.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <cmath>
#include <cstdio>
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

} // namespace

std::vector<std::string> ListNumberedFiles(
  const std::string& pattern, double first, double last, double step, Index most)
{
  const std::size_t percent = pattern.find('%');
  const std::size_t end =
    percent == std::string::npos ? percent : pattern.find_first_not_of("0123456789", percent + 1);
  const bool isNumber = end != std::string::npos && pattern[end] == 'd' && end < percent + 5 &&
    pattern.find('%', end) == std::string::npos;
  const double count = std::floor((last - first) / step) + 1.0;
  if (!isNumber || !(count >= 1.0 && count <= static_cast<double>(most)))
  {
    throw InputError(
      "its pattern of files '" + pattern.substr(0, 80) + "' does not name a file for each slice.");
  }
  std::vector<std::string> files;
  for (int i = 0; i < static_cast<int>(count); ++i)
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
  for (const std::string& file : stored.Files)
  {
    OpenFile(file);
    CheckLength(file, static_cast<double>(stored.Begin + (stored.AreCompressed ? 0 : stored.Skip)),
      stored.CountBytes(size) / static_cast<double>(files), stored.AreCompressed);
  }
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
      if (k / slices != open)
      {
        open = k / slices;
        stream =
          std::make_unique<ByteStream>(stored.Files[open], stored.Begin, stored.AreCompressed);
      }
      const Index first = ((k % slices) * size[1] + j) * size[0] + box.Lower[0];
      stream->Read(stored.Skip + first * width, to, row);
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
