#include "Blocks/SpyPlotStream.h"

#include "OpenFile.h"

#include <algorithm>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace vfm
{
namespace
{

constexpr int Width = 4;     // bytes per value
constexpr int Singles = 128; // from this code on, different values follow

/// Returns a value stored with its most significant byte first.
float ToFloat(const unsigned char* bytes)
{
  const std::uint32_t bits =
    std::uint32_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

} // namespace

SpyPlotStream::SpyPlotStream(const std::string& path) : Path(path)
{
  PrefixErrors(path + " cannot be read: ",
    [&]
    {
      this->Size = GetFileLength(path);
      errno = 0;
      this->Stream.open(path, std::ios::binary);
      if (!this->Stream)
      {
        throw InputError(std::string(std::strerror(errno)) + ".");
      }
    });
}

void SpyPlotStream::Fail(const std::string& problem) const
{
  throw InputError(this->Path + " is truncated or damaged in " + this->Place + " near byte " +
    std::to_string(this->Position) + ": " + problem + ".");
}

void SpyPlotStream::Reserve(std::int64_t count) const
{
  if (count < 0 || count > this->Size - this->Position)
  {
    this->Fail(
      std::to_string(count) + " bytes should follow, the file has " + std::to_string(this->Size));
  }
}

std::vector<unsigned char> SpyPlotStream::Bytes(std::int64_t count)
{
  this->Reserve(count);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(count));
  if (!this->Stream.read(reinterpret_cast<char*>(bytes.data()), count))
  {
    this->Fail("it cannot be read");
  }
  this->Position += count;
  return bytes;
}

void SpyPlotStream::Seek(std::int64_t position)
{
  this->Position = position;
  this->Reserve(0);
  this->Stream.seekg(position);
}

void SpyPlotStream::Skip(std::int64_t count)
{
  this->Reserve(count);
  this->Position += count;
  this->Stream.ignore(count); // keeps the buffer of the stream, which seeking discards
}

std::uint64_t SpyPlotStream::Number(int size)
{
  std::uint64_t value = 0;
  this->Reserve(size);
  for (int i = 0; i < size; ++i)
  {
    value = value << 8 | (this->Stream.get() & 0xff);
  }
  this->Position += size;
  return value;
}

double SpyPlotStream::Double()
{
  const std::uint64_t bits = this->Number(8);
  double value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::int64_t SpyPlotStream::Offset()
{
  const double value = this->Double();
  if (!(value >= 0.0 && value <= static_cast<double>(this->Size)))
  {
    std::ostringstream text;
    text << "it points to byte " << std::setprecision(15) << value << " of " << this->Size;
    this->Fail(text.str());
  }
  return static_cast<std::int64_t>(value);
}

std::string SpyPlotStream::Text(int size)
{
  const std::vector<unsigned char> bytes = this->Bytes(size);
  return std::string(bytes.begin(), std::find(bytes.begin(), bytes.end(), 0));
}

std::vector<float> SpyPlotStream::Values(std::int64_t count)
{
  return this->Decode(this->Bytes(this->Int()), 0, count);
}

std::vector<float> SpyPlotStream::Nodes(std::int64_t count)
{
  const std::vector<unsigned char> code = this->Bytes(this->Int());
  std::vector<float> nodes = this->Decode(code, 2 * Width, count); // fails on a shorter code
  const float step = ToFloat(&code[Width]);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    nodes[i] += static_cast<float>(i) * step;
  }
  return nodes;
}

std::vector<float> SpyPlotStream::Decode(
  const std::vector<unsigned char>& code, std::size_t first, std::int64_t count) const
{
  std::int64_t found = 0;
  std::size_t end = first;
  while (found < count && end < code.size())
  {
    const int run = code[end];
    found += run < Singles ? run : run - Singles;
    end += 1 + Width * (run < Singles ? 1 : run - Singles);
  }
  if (found != count || end > code.size())
  {
    this->Fail("a chunk of " + std::to_string(code.size()) + " bytes does not hold " +
      std::to_string(count) + " values");
  }
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(count));
  for (std::size_t next = first; next < end;)
  {
    const int run = code[next++];
    const int singles = run < Singles ? 1 : run - Singles;
    for (int i = 0; i < singles; ++i, next += Width)
    {
      values.insert(values.end(), run < Singles ? run : 1, ToFloat(&code[next]));
    }
  }
  return values;
}

} // namespace vfm
