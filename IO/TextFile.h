/**
 * TextFile: a large text file, written fast and whole or not at all.
 */
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace vfm
{

/// Adding and Close throw InputError, which tells why, when the file cannot be written. A file that was not closed is removed.
class TextFile
{
public:
  /// Throws InputError when the file cannot be made.
  explicit TextFile(const std::string& path);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  void Add(std::string_view text);
  void Add(std::int64_t number);
  void Close();

private:
  void Flush();

  std::string Path, Buffer;
  std::FILE* File;
};

} // namespace vfm
