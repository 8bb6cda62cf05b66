/**
 * OutputFile: writes a large file through a buffer; a file that is not completed is removed.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace vfm
{

/// Buffered file, which replaces an earlier file of its name when it is complete. The destructor
/// removes what was written unless Close has returned.
/// @throws InputError  (each function) if the file cannot be written; the message holds the reason,
///   not the path
class OutputFile
{
public:
  /// Begins a file that Close renames.
  explicit OutputFile(const std::string& path);
  /// Begins a file of a set, which the set renames.
  OutputFile(const std::string& path, OutputSet& set);
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
  /// Adds bytes that Fill replaces; returns their place. Later bytes of a device or pipe stay in
  /// memory until then.
  /// @pre No other bytes wait for Fill.
  std::int64_t Reserve(std::size_t size);
  /// Replaces the reserved bytes.
  void Fill(std::int64_t place, std::string_view bytes);
  /// Returns when the content is on the disk.
  void Close();

private:
  void Open(const std::string& path);
  void Flush();

  std::unique_ptr<OutputSet> Own; ///< set of this file only; null if it belongs to another set
  std::string Buffer;
  int File = -1;
  bool IsSeekable = false;  ///< false: a device or pipe
  bool HasReserved = false; ///< whether bytes wait for Fill
  std::int64_t Written = 0; ///< bytes before those of Buffer
};

} // namespace vfm
