/**
 * OutputPlace: the place in which a file is written: beside its name, or in place for devices.
 */
#pragma once

#include "Meshes/Files/UnfinishedPath.h"
#include "Meshes/Files/UnnamedFile.h"

#include <memory>
#include <string>

namespace vfm
{

/// When a file that is written gets its name beside the one that it replaces.
enum class Naming
{
  Late,  ///< when it is whole, if the file system has files without names: a killed process leaves
         ///< none
  AtOnce ///< for libraries such as HDF5, which resolve links in paths
};

/// A file that is written, and the path that it replaces. Without both files, Final is a device, a
/// pipe or an open file (/dev/stdout), which is written in place.
struct OutputPlace
{
  std::string Final; ///< absolute path of the file that is replaced, without symbolic links
  std::unique_ptr<UnnamedFile> Unnamed;  ///< file to be written and named, where there are such
  std::unique_ptr<UnfinishedPath> Begun; ///< file beside Final, to be written and renamed
  bool IsLast = false; ///< whether the file is renamed after all others of its set

  /// Gives an unnamed file its name beside Final.
  /// @throws InputError  if that fails; contains the reason
  void Name();
};

/// Returns the absolute path of the file that an output replaces: that at the end of symbolic
/// links.
std::string FindFinalPath(const std::string& path);

/// Returns whether an output is written in place: a device, a pipe, or an open file of the process.
bool IsWrittenInPlace(const std::string& path);

/// Creates the empty file of a place. A name beside Final is .NAME.HOST-PROCESS-NUMBER.part, so no
/// other process writes to it. The file has the owner and the permissions of the file that it
/// replaces.
/// @param path  a symbolic link stays, and its target is replaced
/// @throws InputError  if no file can be created, or if the existing file is a folder or must not
///   be written; contains the reason
OutputPlace CreateOutput(const std::string& path, Naming naming);

/// Returns the name of this host.
std::string NameOfHost();

} // namespace vfm
