/**
 * ZipFile: the files in a zip archive in memory.
 */
#pragma once

#include "Surfaces/SurfaceTools.h"

#include <map>

namespace vfm
{

/// Files of an archive by their names. The views are of the archive.
class ZipFile
{
public:
  /// Reads the list of the files.
  /// @throws InputError  if the bytes are not an archive, or it is truncated or damaged
  explicit ZipFile(std::string_view bytes);

  bool Has(const std::string& name) const { return this->Entries.count(name) > 0; }
  /// Returns the name of the first file that ends with a text; empty if there is none.
  std::string FindEnding(const std::string& end) const;
  /// Unpacks a file.
  /// @throws InputError  if it is missing, encrypted, damaged, or stored in an unknown way
  std::string Read(const std::string& name, const SurfaceTools& tools) const;

private:
  struct Entry
  {
    unsigned int Method = 0, Flags = 0, Checksum = 0;
    std::size_t Packed = 0, Unpacked = 0, Place = 0;
  };

  std::string_view Bytes;
  std::map<std::string, Entry> Entries;
};

} // namespace vfm
