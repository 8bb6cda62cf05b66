#include "Meshes/Files/OutputSet.h"

#include "Meshes/Files/OutputLock.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace vfm
{
namespace
{

using FileStatus = struct stat;
/// A complete file of a rank.
struct WholeFile
{
  int Rank;
  bool IsLast;
  std::string Host, Begun, Final;
};

[[noreturn]] void ThrowProblem(const std::string& path)
{
  throw InputError(path + ": " + std::strerror(errno) + ".");
}

Bytes Pack(const std::vector<WholeFile>& files)
{
  std::string text;
  for (const WholeFile& file : files)
  {
    const std::string rank = std::to_string(file.Rank), isLast = file.IsLast ? "1" : "0";
    for (const std::string& part : { rank, isLast, file.Host, file.Begun, file.Final })
    {
      text.append(part).append(1, '\0');
    }
  }
  return Bytes(text.begin(), text.end());
}

void Unpack(const Bytes& bytes, std::vector<WholeFile>& files)
{
  std::istringstream stream(std::string(bytes.begin(), bytes.end()));
  for (std::string rank, isLast; std::getline(stream, rank, '\0');)
  {
    WholeFile& file = files.emplace_back();
    file.Rank = std::stoi(rank);
    for (std::string* part : { &isLast, &file.Host, &file.Begun, &file.Final })
    {
      std::getline(stream, *part, '\0');
    }
  }
}

/// Renames the files of other ranks to names that these ranks do not remove. `files` then contains
/// the new names.
/// @param claims  guards of the new names
/// @return files that this rank does not see, which are taken out of `files`
std::vector<WholeFile> ClaimFiles(
  std::vector<WholeFile>& files, int rank, std::list<UnfinishedPath>& claims)
{
  std::vector<WholeFile> seen, unseen;
  for (WholeFile& file : files)
  {
    if (file.Rank != rank)
    {
      const std::string claim = file.Begun.substr(0, file.Begun.rfind('.')) + "-whole.part";
      if (std::rename(file.Begun.c_str(), claim.c_str()) != 0)
      {
        if (errno != ENOENT || file.Host == NameOfHost())
        {
          ThrowProblem(file.Begun + " of rank " + std::to_string(file.Rank));
        }
        unseen.push_back(std::move(file));
        continue;
      }
      claims.emplace_back(claim, UnfinishedPath::Kind::File);
      file.Begun = claim;
    }
    seen.push_back(std::move(file));
  }
  files = std::move(seen);
  return unseen;
}

/// Replaces the files of the names, and returns the files that this rank does not see.
std::vector<WholeFile> ReplaceFiles(std::vector<WholeFile> files, int rank)
{
  const auto last = std::stable_partition(
    files.begin(), files.end(), [](const WholeFile& file) { return !file.IsLast; });
  std::optional<OutputLock> lock;
  if (files.size() > 1)
  {
    lock.emplace(last == files.end() ? files.front().Final : last->Final);
  }
  const auto held = HoldUnfinishedPaths();
  std::list<UnfinishedPath> claims;
  std::vector<WholeFile> unseen = ClaimFiles(files, rank, claims);
  for (const WholeFile& file : files)
  {
    if (std::rename(file.Begun.c_str(), file.Final.c_str()) != 0)
    {
      ThrowProblem(file.Final);
    }
  }
  for (UnfinishedPath& claim : claims)
  {
    claim.Keep();
  }
  return unseen;
}

} // namespace

void OutputSet::MakeFolder(const std::string& path)
{
  const auto held = HoldUnfinishedPaths();
  constexpr mode_t mode = 0777;
  if (mkdir(path.c_str(), mode) == 0)
  {
    this->Folders.emplace_front(path, UnfinishedPath::Kind::Folder);
    return;
  }
  FileStatus found{};
  if (errno == EEXIST && stat(path.c_str(), &found) == 0)
  {
    errno = S_ISDIR(found.st_mode) ? 0 : ENOTDIR;
  }
  if (errno != 0)
  {
    ThrowProblem(path);
  }
}

std::string OutputSet::Create(const std::string& path, Naming naming)
{
  OutputPlace place = CreateOutput(path, naming);
  if (!place.Begun && !place.Unnamed)
  {
    return path;
  }
  place.IsLast = path == this->Last;
  const OutputPlace& added = this->Files.emplace_back(std::move(place));
  return added.Begun ? added.Begun->Path() : added.Unnamed->Path();
}

void OutputSet::Rename()
{
  Ranks alone;
  this->Rename(alone);
}

void OutputSet::Rename(Ranks& ranks)
{
  const int rank = ranks.Rank();
  std::vector<WholeFile> files;
  for (OutputPlace& place : this->Files)
  {
    if (place.Unnamed)
    {
      place.Name();
    }
    files.push_back({ rank, place.IsLast, NameOfHost(), place.Begun->Path(), place.Final });
  }
  const std::vector<Bytes> ofAll = ranks.Gather(Pack(files));
  WorkTogether(ranks,
    [&]
    {
      files.clear();
      if (rank == 0)
      {
        for (const Bytes& ofRank : ofAll)
        {
          Unpack(ofRank, files);
        }
        files = ReplaceFiles(std::move(files), rank);
      }
      const Bytes unseen = ranks.Gather(Pack(files))[0];
      files.clear();
      Unpack(unseen, files);
      files.erase(std::remove_if(files.begin(), files.end(),
                    [rank](const WholeFile& file) { return file.Rank != rank; }),
        files.end());
      ReplaceFiles(std::move(files), rank);
    });
  for (OutputPlace& place : this->Files)
  {
    place.Begun->Keep();
  }
  for (UnfinishedPath& folder : this->Folders)
  {
    folder.Keep();
  }
}

void SyncFile(const std::string& path)
{
  const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
  const bool isStored = file >= 0 && (fsync(file) == 0 || errno == EINVAL); // EINVAL: no disk
  const int problem = errno;
  if (file >= 0)
  {
    close(file);
  }
  if (!isStored)
  {
    throw InputError(std::strerror(problem) + std::string("."));
  }
}

} // namespace vfm
