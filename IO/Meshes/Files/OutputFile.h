/**
 * OutputFile: writes a large file through a buffer; a file that is not completed is removed.
 */
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace vfm
{

/// Creates a folder unless it exists.
/// @throws InputError  if it cannot be created; contains the path and the reason
void MakeFolder(const std::string& path);

/// Guard that removes a file in its destructor, unless Keep was called. It never removes a device.
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

/// Buffered file. The destructor removes the file unless Close has returned.
/// @throws InputError  (each function) if the file cannot be written; the message holds the reason,
///   not the path
class OutputFile
{
public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Add(std::string_view text);
  void Add(std::int64_t number);
  /// Adds the shortest text that is read back as the same number.
  void AddReal(double number);
  /// Adds the bytes of a number in the order of this machine.
  template <class T>
  void AddBytes(T number)
  {
    this->Add(std::string_view(reinterpret_cast<const char*>(&number), sizeof(T)));
  }
  void Close();

private:
  void Flush();

  std::string Path, Buffer;
  std::FILE* File;
};

} // namespace vfm
