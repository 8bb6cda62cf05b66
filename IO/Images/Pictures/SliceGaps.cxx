#include "Images/Pictures/SliceGaps.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace vfm
{
namespace
{

constexpr std::size_t MostDigits = 18; // of a number of type long

/// Parts of the name of a file: its texts, and the numbers between them.
struct NameParts
{
  std::string File, Texts; ///< Texts: with a sign in the place of each number
  std::vector<long> Numbers;
};

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

NameParts SplitName(const std::string& path)
{
  NameParts parts;
  const std::string name = parts.File = std::filesystem::path(path).filename().string();
  for (std::size_t at = 0; at < name.size();)
  {
    const std::size_t end = std::find_if_not(name.begin() + at, name.end(), IsDigit) - name.begin();
    if (end > at && end - at <= MostDigits)
    {
      parts.Numbers.push_back(std::strtol(name.substr(at, end - at).c_str(), nullptr, 10));
      parts.Texts += '\n';
    }
    else
    {
      parts.Texts += name.substr(at, std::max<std::size_t>(end - at, 1));
    }
    at = std::max(end, at + 1);
  }
  return parts;
}

/// Two neighbours whose names differ in a number.
struct Neighbours
{
  std::size_t First; ///< number of the first file
  std::size_t Place; ///< of the first number that differs
  long Step;         ///< difference of the numbers
};

std::vector<Neighbours> ListNeighbours(const std::vector<NameParts>& names)
{
  std::vector<Neighbours> list;
  for (std::size_t i = 1; i < names.size(); ++i)
  {
    const std::vector<long>&one = names[i - 1].Numbers, &other = names[i].Numbers;
    const auto differ = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
    if (names[i - 1].Texts == names[i].Texts && differ.first != one.end())
    {
      list.push_back({ i - 1, static_cast<std::size_t>(differ.first - one.begin()),
        *differ.second - *differ.first });
    }
  }
  return list;
}

} // namespace

std::string WarnOfGaps(const std::vector<std::string>& files)
{
  std::vector<NameParts> names;
  std::transform(files.begin(), files.end(), std::back_inserter(names), SplitName);
  const std::vector<Neighbours> list = ListNeighbours(names);
  std::map<std::size_t, long> usual;
  for (const Neighbours& two : list)
  {
    const long step = usual.emplace(two.Place, two.Step).first->second;
    usual[two.Place] = std::min(step, two.Step);
  }
  const Neighbours* first = nullptr;
  long missing = 0;
  for (const Neighbours& two : list)
  {
    const long step = usual[two.Place];
    if (two.Step > step)
    {
      first = first ? first : &two;
      missing += std::max((two.Step - 1) / step, 1L);
    }
  }
  if (!first)
  {
    return "";
  }
  return "slices may be missing: numbers without a file: " + std::to_string(missing) +
    ", the first between " + names[first->First].File + " and " + names[first->First + 1].File +
    ". The volume has no gaps: the slices on both sides become neighbours.";
}

} // namespace vfm
