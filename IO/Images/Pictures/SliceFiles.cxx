#include "Images/Pictures/SliceFiles.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <filesystem>
#include <glob.h>
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

} // namespace

const std::vector<std::string>& GetSliceSuffixes()
{
  static const std::vector<std::string> suffixes{ ".tif", ".tiff", ".png" };
  return suffixes;
}

bool AreSlices(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    const std::vector<std::string> paths = ListFolder(path);
    return std::any_of(paths.begin(), paths.end(), IsSlice);
  }
  return !fs::exists(path, error) && HasSuffix(path, GetSliceSuffixes()) &&
    MakePattern(path).find_first_of("*?[") != std::string::npos;
}

std::vector<std::string> ListSlices(const std::string& path)
{
  std::error_code error;
  const bool isFolder = fs::is_directory(path, error);
  std::vector<std::string> paths = isFolder ? ListFolder(path) : ListMatches(path);
  paths.erase(std::remove_if(
                paths.begin(), paths.end(), [](const std::string& one) { return !IsSlice(one); }),
    paths.end());
  if (paths.empty())
  {
    throw InputError(std::string(isFolder ? "the folder contains" : "the pattern matches") +
      " no file of a slice (" + JoinTexts(GetSliceSuffixes()) + ").");
  }
  SortNaturally(paths);
  return paths;
}

void SortNaturally(std::vector<std::string>& paths)
{
  std::sort(paths.begin(), paths.end(), IsBefore);
}

} // namespace vfm
