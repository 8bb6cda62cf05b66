#include "Blocks/ExodusCase.h"

#include "FileSuffix.h"
#include "Input/ArrayInfo.h"
#include "OpenFile.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace vfm
{
namespace
{

/// Parts of a name FILE.N.RANK.
struct DecomposedName
{
  std::string Base; // FILE
  int Count;        // N
  std::string CountText;
  std::size_t RankDigits; // number of digits of RANK, which may have leading zeros
};

/// Splits the name of a part of a decomposed file; returns nothing for other names.
std::optional<DecomposedName> ParseDecomposedName(const std::string& path)
{
  static const std::regex pattern("(.+)\\.([0-9]{1,6})\\.([0-9]{1,6})");
  std::smatch match;
  if (!std::regex_match(path, match, pattern))
  {
    return std::nullopt;
  }
  const int count = std::stoi(match[2]), rank = std::stoi(match[3]);
  if (rank >= count)
  {
    return std::nullopt;
  }
  return DecomposedName{ match[1], count, match[2], match[3].str().size() };
}

/// Returns all files of an input.
std::vector<std::string> FindFiles(const std::string& path)
{
  const auto name = ParseDecomposedName(path);
  if (!name)
  {
    return { path };
  }
  std::vector<std::string> files;
  for (int f = 0; f < name->Count; ++f)
  {
    const std::string rank = std::to_string(f);
    const std::size_t zeros = name->RankDigits - std::min(name->RankDigits, rank.size());
    files.push_back(name->Base + "." + name->CountText + "." + std::string(zeros, '0') + rank);
  }
  return files;
}

/// Returns the files of this rank; consecutive ranks get consecutive files.
std::vector<std::string> DistributeFiles(const std::vector<std::string>& paths, const Ranks& ranks)
{
  const auto begin = [&](int rank)
  { return paths.begin() + (paths.size() * rank + ranks.Count() - 1) / ranks.Count(); };
  return { begin(ranks.Rank()), begin(ranks.Rank() + 1) };
}

/// Calls a step of reading a file. Messages name the file if it is not the input itself.
template <class Step>
void NameFile(const std::string& input, const std::string& file, Step step)
{
  PrefixErrors(file == input ? "" : file + ": ", step);
}

/// Reads the structure of a file.
/// @param count  number of files of the input
ExodusContents ReadContents(const std::string& input, const std::string& file, std::size_t count)
{
  const std::string role = count > 1 ? " (one of " + std::to_string(count) + " files)" : "";
  PrefixErrors(file == input ? "" : file + role + ": ", [&] { OpenFile(file); });
  ExodusContents contents;
  NameFile(input, file, [&] { contents = ReadExodusContents(file); });
  return contents;
}

} // namespace

std::vector<std::string> GetExodusSuffixes()
{
  return { ".e", ".ex2", ".exo", ".exii", ".g" };
}

bool IsExodusFile(const std::string& path)
{
  std::error_code error; // a path without access is not a folder
  return (ParseDecomposedName(path) || HasSuffix(path, GetExodusSuffixes())) &&
    !std::filesystem::is_directory(path, error);
}

ExodusCase::ExodusCase(const std::string& path, Ranks& ranks) : Path(path)
{
  const std::vector<std::string> all = FindFiles(path);
  this->Files = DistributeFiles(all, ranks);
  const ExodusContents first = ReadContents(path, all[0], all.size());
  this->StepTimes = first.Times;
  std::vector<ArrayInfo> variables;
  for (const std::string& file : this->Files)
  {
    const ExodusContents contents = file == all[0] ? first : ReadContents(path, file, all.size());
    if (contents.Times.size() != this->StepTimes.size())
    {
      throw InputError((file == path ? "" : file + ": ") + "it holds " +
        std::to_string(contents.Times.size()) + " times, but " + all[0] + " holds " +
        std::to_string(this->StepTimes.size()) + ".");
    }
    for (const std::string& name : contents.Names)
    {
      AddArray(variables, { name });
    }
  }
  for (const ArrayInfo& variable : UnionOfArrays(variables, ranks))
  {
    this->ArrayNames.push_back(variable.Name);
  }
  std::sort(this->ArrayNames.begin(), this->ArrayNames.end());
}

bool ExodusCase::Has(const std::string& name) const
{
  return name == BlockIds || this->BlockFile::Has(name);
}

std::vector<ElementBlock> ExodusCase::ReadElements(
  std::size_t step, const std::vector<std::string>& names) const
{
  std::vector<ElementBlock> elements;
  for (const std::string& file : this->Files)
  {
    NameFile(this->Path, file,
      [&]
      {
        const bool hasTimes = !this->StepTimes.empty();
        for (ElementBlock& block :
          ReadElementBlocks(file, hasTimes ? std::optional<Index>(step) : std::nullopt, names))
        {
          elements.push_back(std::move(block));
        }
      });
  }
  return elements;
}

std::vector<InputBlock> ExodusCase::Read(
  std::size_t step, const std::vector<std::string>& names, Ranks& ranks) const
{
  return FindBlocks(this->ReadElements(step, names), ranks);
}

std::vector<InputBlock> FindBlocks(const std::vector<ElementBlock>& elements, Ranks& ranks)
{
  std::vector<InputBlock> blocks;
  WorkTogether(ranks,
    [&]
    {
      for (std::size_t e = 0; e < elements.size(); ++e)
      {
        const int number = static_cast<int>(e);
        const std::string name = NameBlock(number, ranks.Rank(), ranks.Count() == 1);
        for (InputBlock& block : FindBoxes(elements[e], number, name))
        {
          blocks.push_back(std::move(block));
        }
      }
    });
  if (!ranks.Any(!blocks.empty()))
  {
    throw InputError("The input has no cells. Volume fractions on a 3D grid of cells are needed.");
  }
  return blocks;
}

} // namespace vfm
