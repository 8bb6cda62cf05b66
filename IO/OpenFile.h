/**
 * OpenFile: opens a file for reading.
 */
#pragma once

#include "Base/Runtime.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

namespace vfm
{

/// Opens a file for reading, in binary mode.
/// @throws InputError  if it cannot be read or is empty; the message holds the reason, not the path
inline std::ifstream OpenFile(const std::string& path)
{
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream.peek() == std::ifstream::traits_type::eof()) // folders open, but cannot be read
  {
    throw InputError((errno ? std::strerror(errno) : std::string("the file is empty")) + ".");
  }
  return stream;
}

} // namespace vfm
