#include "Images/Pictures/SliceFiles.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <filesystem>
#include <glob.h>
#include <iterator>
#include <map>
#include <regex>

namespace vfm
{
namespace
{

namespace fs = std::filesystem;

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Compares the digits at the begin of two texts by value, and removes them.
/// @return below 0, 0 or above 0
int CompareNumbers(const char*& one, const char*& other)
{
  const auto length = [](const char*& text)
  {
    while (*text == '0')
    {
      ++text;
    }
    std::size_t count = 0;
    while (IsDigit(text[count]))
    {
      ++count;
    }
    return count;
  };
  const std::size_t a = length(one), b = length(other);
  const int order = a != b ? (a < b ? -1 : 1) : std::string(one, a).compare(std::string(other, b));
  one += a;
  other += b;
  return order;
}

bool IsBefore(const std::string& path, const std::string& otherPath)
{
  const char *one = path.c_str(), *other = otherPath.c_str();
  while (*one && *other)
  {
    if (IsDigit(*one) && IsDigit(*other))
    {
      const int order = CompareNumbers(one, other);
      if (order != 0)
      {
        return order < 0;
      }
    }
    else if (*one != *other)
    {
      return static_cast<unsigned char>(*one) < static_cast<unsigned char>(*other);
    }
    else
    {
      ++one;
      ++other;
    }
  }
  return *one || *other ? !*one : path < otherPath;
}

bool IsSlice(const fs::path& path)
{
  const std::string name = path.filename().string();
  return name.compare(0, 1, ".") != 0 && HasSuffix(name, GetSliceSuffixes());
}

/// Returns a pattern of glob; a format of a number, such as %04d, becomes a digit and anything.
std::string MakePattern(const std::string& path)
{
  return std::regex_replace(path, std::regex("%[0-9]{0,3}d"), "[0-9]*");
}

std::vector<std::string> ListMatches(const std::string& path)
{
  std::vector<std::string> paths;
  glob_t found{};
  if (glob(MakePattern(path).c_str(), GLOB_NOSORT, nullptr, &found) == 0)
  {
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  return paths;
}

std::vector<std::string> ListFolder(const std::string& path)
{
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end;
       entry.increment(error))
  {
    paths.push_back(entry->path().string());
  }
  return paths;
}

std::string SuffixOf(const std::string& path)
{
  const std::string suffix = ToLower(fs::path(path).extension().string());
  return suffix == ".tiff" ? ".tif" : suffix;
}

/// Returns the suffixes of visible files with their numbers: ".dcm" 12.
std::map<std::string, int> CountSuffixes(const std::vector<std::string>& paths)
{
  std::map<std::string, int> counts;
  std::error_code error;
  for (const std::string& path : paths)
  {
    const bool isVisible = fs::path(path).filename().string().compare(0, 1, ".") != 0;
    counts[SuffixOf(path)] += isVisible && fs::is_regular_file(path, error);
  }
  return counts;
}

/// Returns what a user can do with files that are no slices, or "".
std::string Advise(const std::map<std::string, int>& counts)
{
  const auto has = [&counts](const char* suffix)
  { return counts.count(suffix) > 0 && counts.at(suffix) > 0; };
  const bool arePictures = has(".jpg") || has(".jpeg") || has(".bmp") || has(".gif");
  return has(".dcm") || has(".ima")
    ? " Convert DICOM files to one .nii or .nrrd, for instance by 3D Slicer or dcm2niix."
    : arePictures ? " Save pictures as .png or .tif, from the original images, because .jpg "
                    "changes values."
                  : "";
}

[[noreturn]] void RejectFiles(bool isFolder, const std::vector<std::string>& paths)
{
  const std::map<std::string, int> counts = CountSuffixes(paths);
  std::vector<std::string> found;
  for (const auto& [suffix, count] : counts)
  {
    if (count > 0)
    {
      found.push_back(std::to_string(count) + " " + (suffix.empty() ? "without suffix" : suffix));
    }
  }
  throw InputError(std::string(isFolder ? "the folder contains" : "the pattern matches") +
    " no file of a slice (" + JoinTexts(GetSliceSuffixes()) + ")" +
    (isFolder ? " and is no plotfile of AMReX, which has a file Header" : "") +
    ". Its files: " + (found.empty() ? "none" : JoinTexts(found)) + "." + Advise(counts));
}

/// Rejects files of several formats.
void CheckOneFormat(const std::string& path, bool isFolder, const std::vector<std::string>& files)
{
  const std::map<std::string, int> counts = CountSuffixes(files);
  if (counts.size() < 2)
  {
    return;
  }
  std::vector<std::string> found;
  for (const auto& one : counts)
  {
    found.push_back(one.first);
  }
  const std::string example =
    (isFolder ? fs::path(path) : fs::path(path).parent_path()) / ("*" + found.back());
  throw InputError("its slices have several formats, " + JoinTexts(found) +
    ". Select one format by a pattern in quotes, such as \"" + example + "\".");
}

} // namespace

const std::vector<std::string>& GetSliceSuffixes()
{
  static const std::vector<std::string> suffixes{ ".tif", ".tiff", ".png" };
  return suffixes;
}

bool IsPattern(const std::string& path)
{
  std::error_code error;
  return !fs::exists(path, error) && MakePattern(path).find_first_of("*?[") != std::string::npos;
}

bool AreSlices(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    const std::vector<std::string> paths = ListFolder(path);
    return std::any_of(paths.begin(), paths.end(), IsSlice);
  }
  if (!IsPattern(path) || HasSuffix(path, GetSliceSuffixes()))
  {
    return IsPattern(path);
  }
  const std::vector<std::string> matches = ListMatches(path);
  return std::any_of(matches.begin(), matches.end(), IsSlice);
}

std::vector<std::string> ListSlices(const std::string& path)
{
  std::error_code error;
  const bool isFolder = fs::is_directory(path, error);
  const std::vector<std::string> all = isFolder ? ListFolder(path) : ListMatches(path);
  std::vector<std::string> paths;
  std::copy_if(all.begin(), all.end(), std::back_inserter(paths), IsSlice);
  if (paths.empty())
  {
    RejectFiles(isFolder, all);
  }
  CheckOneFormat(path, isFolder, paths);
  SortNaturally(paths);
  return paths;
}

void SortNaturally(std::vector<std::string>& paths)
{
  std::sort(paths.begin(), paths.end(), IsBefore);
}

} // namespace vfm
