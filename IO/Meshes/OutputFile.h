/**
 * OutputFile: a large file, written fast, and whole or not at all.
 */
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace vfm
{

/// Makes a folder unless it is there. Throws InputError with the path and the reason.
void MakeFolder(const std::string& path);

/// Removes a file in the destructor unless Keep was called. It never removes a device.
class UnfinishedFile
{
public:
  explicit UnfinishedFile(std::string path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  void Keep() { this->IsKept = true; }

private:
  std::string Path;
  bool IsKept = false;
};

/// The functions throw InputError, with the reason but without the path, when the file cannot be written. The destructor removes a
/// file that was not closed.
class OutputFile
{
public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Add(std::string_view text);
  void Add(std::int64_t number);
  void Close();

private:
  void Flush();

  std::string Path, Buffer;
  std::FILE* File;
};

} // namespace vfm
