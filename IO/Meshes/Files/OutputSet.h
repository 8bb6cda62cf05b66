/**
 * OutputSet: files that are written beside their names, and replace files of their names together.
 */
#pragma once

#include "Meshes/Files/OutputPlace.h"
#include "Meshes/Files/UnfinishedPath.h"
#include "Ranks/Ranks.h"

#include <list>
#include <string>
#include <vector>

namespace vfm
{

/// Set of files, on one rank or several. Until Rename, the earlier files of their names are
/// unchanged. The destructor removes what was not renamed, and the folders that were made for it.
/// @throws InputError  (each function) if a file cannot be written; contains the reason
class OutputSet
{
public:
  /// @param last  path of the file that is renamed last, such as a list of the others
  explicit OutputSet(std::string last) : Last(std::move(last)) {}

  /// Creates a folder unless it exists. If the set has other folders, it is inside of them.
  void MakeFolder(const std::string& path);
  /// Creates the file that will replace a file.
  /// @return path of the empty file to be written; devices and pipes: the path itself
  std::string Create(const std::string& path, Naming naming = Naming::Late);

  /// Replaces the files of the names.
  /// @pre All files are complete, and are stored by SyncFile or OutputFile.
  void Rename();
  /// Replaces the files of all ranks. Rank 0 does it, so that there is no rank that has replaced
  /// its files when another one is ended by a signal. Only files that rank 0 does not see, on disks
  /// of other hosts, are replaced by their own ranks afterwards. Of two programs that replace files
  /// of the same names, the second one waits.
  /// @pre Collective
  void Rename(Ranks& ranks);

private:
  std::string Last;
  std::list<UnfinishedPath> Folders; ///< inner folders first, the order of removal
  std::vector<OutputPlace> Files;
};

/// Returns when the content of a closed file is on the disk.
/// @throws InputError  if it cannot be stored, for instance because the disk is full
void SyncFile(const std::string& path);

} // namespace vfm
