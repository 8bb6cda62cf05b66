/**
 * OpenFile: opens a regular file for reading, and returns its length.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Errors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

namespace vfm
{

/// Checks that a path is a regular file, because devices and pipes may block or have no end.
/// @throws InputError  if it is not a regular file; the message does not contain the path
inline void CheckRegularFile(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw InputError((error ? error.message() : std::string(std::strerror(ENOENT))) + ".");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw InputError(std::filesystem::is_directory(status)
        ? "Is a directory; it is not a regular file."
        : "it is not a regular file (but a device, pipe or socket). Save its contents in a file.");
  }
}

/// Opens a regular file for reading, in binary mode. Numbers in it have a decimal point, whatever
/// the locale of the host program.
/// @throws InputError  if it cannot be read, is empty or is not a regular file; the message holds
///   the reason, not the path
inline std::ifstream OpenFile(const std::string& path)
{
  CheckRegularFile(path);
  errno = 0;
  std::ifstream stream;
  stream.imbue(std::locale::classic());
  stream.open(path, std::ios::binary);
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    throw InputError((errno ? std::strerror(errno) : std::string("the file is empty")) + ".");
  }
  return stream;
}

/// Returns the length of a regular file, bytes.
/// @throws InputError  same conditions as CheckRegularFile
inline Index GetFileLength(const std::string& path)
{
  CheckRegularFile(path);
  std::error_code error;
  const std::uintmax_t length = std::filesystem::file_size(path, error);
  if (error)
  {
    throw InputError(error.message() + ".");
  }
  return static_cast<Index>(length);
}

} // namespace vfm
