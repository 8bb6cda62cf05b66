#include "Surfaces/FileBytes.h"

#include "OpenFile.h"

#ifdef VFM_HAS_ZLIB
#include <algorithm>
#include <zlib.h>
#endif

namespace vfm
{
namespace
{

constexpr std::size_t LargestRatio = 1100; // of zlib's packed bytes; 1032 at most
constexpr int GzipBits = 31;

#ifdef VFM_HAS_ZLIB
/// Stream of zlib that frees itself.
struct InflateStream : z_stream
{
  explicit InflateStream(int windowBits) : z_stream{}
  {
    if (inflateInit2(this, windowBits) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~InflateStream() { inflateEnd(this); }
  InflateStream(const InflateStream&) = delete;
  InflateStream& operator=(const InflateStream&) = delete;
};

std::string InflateByZlib(std::string_view packed, int windowBits, std::size_t most)
{
  constexpr std::size_t part = 1 << 20;
  InflateStream stream(windowBits);
  std::string bytes;
  std::size_t taken = 0, size = 0;
  while (true)
  {
    if (stream.avail_in == 0)
    {
      const std::size_t next = std::min(packed.size() - taken, part);
      // zlib does not write to its input
      stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(packed.data() + taken));
      stream.avail_in = static_cast<unsigned int>(next);
      taken += next;
    }
    bytes.resize(std::max(bytes.size(), size + part));
    stream.next_out = reinterpret_cast<unsigned char*>(bytes.data() + size);
    stream.avail_out = static_cast<unsigned int>(bytes.size() - size);
    const bool isAtEnd = stream.avail_in == 0;
    const int state = inflate(&stream, Z_NO_FLUSH);
    size = bytes.size() - stream.avail_out;
    if (size > most)
    {
      throw InputError("its compressed data are larger than announced.");
    }
    const bool isLast = stream.avail_in == 0 && taken == packed.size();
    if (state == Z_STREAM_END && (isLast || windowBits != GzipBits))
    {
      bytes.resize(size);
      return bytes;
    }
    if (state == Z_STREAM_END) // another member may follow, as written by bgzip and pigz
    {
      inflateReset(&stream);
    }
    else if (isAtEnd || state != Z_OK)
    {
      throw InputError(
        isAtEnd ? "its compressed data are truncated." : "its compressed data are damaged.");
    }
  }
}
#endif

} // namespace

std::string InflateAll(std::string_view packed, int windowBits, const SurfaceTools& tools)
{
  const std::size_t most = packed.size() * LargestRatio + LargestRatio;
  if (tools.Inflate)
  {
    return tools.Inflate(packed, windowBits, most);
  }
#ifdef VFM_HAS_ZLIB
  return InflateByZlib(packed, windowBits, most);
#else
  throw InputError("it is compressed, and this build has no zlib. Unpack it first.");
#endif
}

std::string ReadFileBytes(const std::string& path, const SurfaceTools& tools)
{
  std::ifstream stream = OpenFile(path);
  std::string bytes(static_cast<std::size_t>(GetFileLength(path)), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes.substr(0, 2) == "\x1f\x8b" ? InflateAll(bytes, GzipBits, tools) : bytes;
}

} // namespace vfm
