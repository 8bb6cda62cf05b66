/**
 * SurfaceTools: functions of zlib for readers of surfaces, because not every build has the library.
 */
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace vfm
{

/// Unpacks bytes.
/// @param windowBits  format as in inflateInit2 of zlib: -15 raw, 15 zlib, 31 gzip (all members)
/// @param most  largest number of bytes of the result
/// @throws InputError  if the bytes are damaged or truncated, or if the result is larger
using InflateBytes =
  std::function<std::string(std::string_view packed, int windowBits, std::size_t most)>;

/// Functions of libraries. Empty ones are those of the build.
struct SurfaceTools
{
  InflateBytes Inflate;
};

} // namespace vfm
