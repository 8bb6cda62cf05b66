#include "LabelTable.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"
#include "Report/UniqueNames.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

namespace vfm
{
namespace
{

bool IsNumber(const std::string& text)
{
  return !text.empty() && text.find_first_not_of("+-.0123456789eE") == std::string::npos &&
    text.find_first_of("0123456789") != std::string::npos;
}

/// Tests whether a line that begins with this word is a title of columns.
bool IsTitle(const std::string& word)
{
  const auto words = { "id", "index", "label", "number", "value" };
  return std::find(words.begin(), words.end(), ToLower(word)) != words.end();
}

/// Returns the name in the text after a label.
/// @param end  separator between the name and further columns
std::string FindName(const std::string& rest, char end)
{
  const std::size_t quote = rest.find('"'), last = rest.rfind('"');
  if (quote != last)
  {
    return TrimText(rest.substr(quote + 1, last - quote - 1));
  }
  return TrimText(rest.substr(0, rest.find(end)));
}

} // namespace

std::optional<int> LabelTable::ParseLabel(const std::string& text)
{
  const bool isNumber =
    !text.empty() && text.size() <= 10 && text.find_first_not_of("0123456789") == std::string::npos;
  const long long number = isNumber ? std::stoll(text) : -1;
  return number >= 0 && number <= std::numeric_limits<int>::max()
    ? std::make_optional(static_cast<int>(number))
    : std::nullopt;
}

void LabelTable::Reject(int place, const std::string& problem) const
{
  throw InputError("Cannot read the names of labels from " + this->Path +
    (place > 0 ? ", " + this->NamePlace(place) : "") + ": " + problem);
}

void LabelTable::AddElement(int place, int label, const std::string& name)
{
  this->Rows.push_back({ place, label, name, "", 0 });
}

void LabelTable::ReadLine(const std::string& line, int number)
{
  const std::size_t end = line.find_first_of(" \t,;");
  const std::string first = line.substr(0, end);
  const std::optional<int> label = ParseLabel(first);
  if (!label)
  {
    if (this->Rows.empty() && IsTitle(first))
    {
      return;
    }
    this->Reject(number,
      "it begins with '" + first.substr(0, 40) +
        "', which is not a label. Labels are integers from 0 to " +
        std::to_string(std::numeric_limits<int>::max()) + ".");
  }
  Row row;
  row.Place = number;
  row.Label = *label;
  const std::size_t next = line.find_first_not_of(" \t", end);
  const bool isParted = next != std::string::npos && (line[next] == ',' || line[next] == ';');
  const std::string rest =
    next == std::string::npos ? "" : TrimText(line.substr(next + (isParted ? 1 : 0)));
  row.Name = FindName(rest, isParted ? line[next] : '\t');
  if (row.Name.empty())
  {
    this->Reject(number, "label " + first + " has no name.");
  }
  std::istringstream words(rest);
  std::string word;
  words >> row.Word;
  while (words >> word)
  {
    ++row.Numbers;
    if (!IsNumber(word))
    {
      row.Word.clear();
    }
  }
  this->Rows.push_back(std::move(row));
}

/// Returns a line in UTF-8.
std::string LabelTable::ConvertLine(const std::string& line, int number)
{
  if (IsUtf8(line))
  {
    return line;
  }
  const std::string converted = ToUtf8(line);
  if (converted.find(UnknownCharacter) != std::string::npos)
  {
    this->Reject(number, "it is neither UTF-8 nor Windows-1252 (Latin-1). Save the file as UTF-8.");
  }
  if (this->TheNote.empty())
  {
    this->TheNote = "The names of labels in " + this->Path + " are not UTF-8 in " +
      this->NamePlace(number) + ". They are read as Windows-1252 (Latin-1): '" +
      TrimText(converted) + "'.";
  }
  return converted;
}

void LabelTable::ReadText(std::istream& stream)
{
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    line = TrimText(this->ConvertLine(line, number));
    if (!line.empty() && line[0] != '#')
    {
      this->ReadLine(line, number);
    }
  }
}

/// Returns whether every label is followed by one word and N numbers, where N is 1 and the words
/// differ, or N is 3 or 4.
bool LabelTable::HasColumnsOfNumbers() const
{
  std::set<std::string> words;
  for (const Row& row : this->Rows)
  {
    words.insert(row.Word);
    if (row.Word.empty() || row.Numbers != this->Rows[0].Numbers)
    {
      return false;
    }
  }
  const std::size_t numbers = this->Rows.empty() ? 0 : this->Rows[0].Numbers;
  return (numbers == 1 && words.size() == this->Rows.size()) || numbers == 3 || numbers == 4;
}

LabelNames LabelTable::MakeNames()
{
  if (this->Rows.empty())
  {
    this->Reject(0, "it contains no names of labels.");
  }
  const bool isWord = this->HasColumnsOfNumbers();
  std::map<int, int> places;
  std::map<std::string, const Row*> named;
  LabelNames names;
  for (Row& row : this->Rows)
  {
    row.Name = isWord ? row.Word : row.Name;
    const auto label = places.emplace(row.Label, row.Place);
    if (!label.second)
    {
      this->Reject(row.Place,
        "label " + std::to_string(row.Label) + " is also in " +
          this->NamePlace(label.first->second) + ".");
    }
    const auto name = named.emplace(row.Name, &row);
    if (!name.second)
    {
      const Row& other = *name.first->second;
      this->Reject(row.Place,
        "the name '" + row.Name + "' also belongs to label " + std::to_string(other.Label) +
          " in " + this->NamePlace(other.Place) + ".");
    }
    names[row.Label] = row.Name;
  }
  return names;
}

} // namespace vfm
