/**
 * OutputPlace: the place in which a file is written: beside its name, or in place for devices.
 */
#pragma once

#include "Meshes/Files/UnfinishedPath.h"

#include <memory>
#include <string>

namespace vfm
{

/// Path of a file that is written, and the path that it replaces.
struct OutputPlace
{
  std::string Final; ///< absolute path of the file that is replaced, without symbolic links
  /// Empty file in the folder of Final, to be written and renamed. Null: Final is a device, a pipe
  /// or an open file (/dev/stdout), which is written in place.
  std::unique_ptr<UnfinishedPath> Begun;
  bool IsLast = false; ///< whether the file is renamed after all others of its set
};

/// Creates the empty file of a place. Its name is .NAME.HOST-PROCESS-NUMBER.part, so no other
/// process writes to it. It has the owner and the permissions of the file that it replaces.
/// @param path  a symbolic link stays, and its target is replaced
/// @throws InputError  if no file can be created, or if the existing file is a folder or must not
///   be written; contains the reason
OutputPlace CreateOutput(const std::string& path);

/// Returns the name of this host.
std::string NameOfHost();

} // namespace vfm
