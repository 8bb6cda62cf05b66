/**
 * FoamFolder: writes the files of one mesh of OpenFOAM, and those of a case without a mesh.
 */
#pragma once

#include "Meshes/Files/OutputFile.h"
#include "Meshes/OpenFoam/FoamAddressing.h"

#include <list>
#include <string>

namespace vfm
{

/// Files and folders that are removed in the destructor, unless Keep was called.
class UnfinishedFolders
{
public:
  UnfinishedFolders() = default;
  ~UnfinishedFolders();
  UnfinishedFolders(const UnfinishedFolders&) = delete;
  UnfinishedFolders& operator=(const UnfinishedFolders&) = delete;

  /// Makes a folder, such as "case/constant", unless it exists.
  void Make(const std::string& path);
  /// Adds a file of its own.
  void Add(const std::string& file) { this->Files.emplace_back(file); }
  void Keep();

private:
  std::list<std::string> Folders; ///< made here, the last one first
  std::list<UnfinishedFile> Files;
};

/// Writes constant/polyMesh in a folder.
/// @param addressing  null: no addressing
void WritePolyMesh(const FoamMesh& foam, const FoamAddressing* addressing,
  const std::string& folder, bool isBinary, UnfinishedFolders& files);

/// Writes the dictionaries in the folder system that do not exist, and the empty file of the path.
/// @param ranks  number of meshes of the case
void WriteCaseFiles(
  const std::string& folder, const std::string& path, int ranks, UnfinishedFolders& files);

} // namespace vfm
