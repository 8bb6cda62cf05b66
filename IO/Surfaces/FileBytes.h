/**
 * FileBytes: the bytes of a whole file, unpacked if they are packed by gzip, and numbers in them.
 */
#pragma once

#include "Surfaces/SurfaceTools.h"
#include "SwapBytes.h"

#include <cstring>
#include <string>
#include <string_view>

namespace vfm
{

/// Reads a file, and unpacks it if it begins as gzip does.
/// @throws InputError  if it cannot be read or unpacked; the message does not contain the path
std::string ReadFileBytes(const std::string& path, const SurfaceTools& tools);

/// Unpacks bytes by the function of the tools, or of the build. The result may be as large as the
/// largest ratio of zlib allows.
/// @throws InputError  if they are damaged, or if neither has such a function
std::string InflateAll(std::string_view packed, int windowBits, const SurfaceTools& tools);

/// Returns a value at a place, which must be inside of the bytes.
template <class Value>
Value ReadBytesAs(std::string_view bytes, std::size_t place, bool isBigEndian)
{
  Value value;
  std::memcpy(&value, bytes.data() + place, sizeof(Value));
  return isBigEndian == IsLittleEndian() ? SwapBytes(value) : value;
}

} // namespace vfm
