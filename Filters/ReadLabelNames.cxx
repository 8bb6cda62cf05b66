#include "ReadLabelNames.h"

#include "Base/WorkTogether.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

namespace vfm
{
namespace
{

constexpr const char* Blanks = " \t\r\n\v\f";

std::string Trim(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

/// The words of a text, which may fill several lines, with a blank between.
std::string JoinWords(const std::string& text)
{
  std::istringstream words(text);
  std::string joined;
  for (std::string word; words >> word;)
  {
    joined += (joined.empty() ? "" : " ") + word;
  }
  return joined;
}

/// A whole number that fills the text.
std::optional<int> ParseLabel(const std::string& text)
{
  const bool isNumber =
    !text.empty() && text.size() <= 10 && text.find_first_not_of("0123456789") == std::string::npos;
  const long long number = isNumber ? std::stoll(text) : -1;
  return number >= 0 && number <= std::numeric_limits<int>::max()
    ? std::make_optional(static_cast<int>(number))
    : std::nullopt;
}

bool IsNumber(const std::string& text)
{
  return !text.empty() && text.find_first_not_of("+-.0123456789eE") == std::string::npos &&
    text.find_first_of("0123456789") != std::string::npos;
}

/// Whether a line that begins with this word names columns.
bool IsTitle(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto words = { "id", "index", "label", "number", "value" };
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// A line of the table, or an element.
struct Row
{
  int Place = 0; ///< in the file, from 1
  int Label = 0;
  std::string Name;
  std::string Word;        ///< of what is one word and numbers; else empty
  std::size_t Numbers = 0; ///< that follow the word
};

class Table
{
public:
  explicit Table(const std::string& path) : Path(path) {}

  void ReadText(std::istream& stream);
  void ReadXml();
  void Add(Row row) { this->Rows.push_back(std::move(row)); }
  LabelNames MakeNames();

private:
  std::string NameRow(int number) const { return this->Unit + std::to_string(number); }
  [[noreturn]] void Refuse(int number, const std::string& problem) const;
  void ReadLine(const std::string& line, int number);
  bool HasColumnsOfNumbers() const;

  std::string Path, Unit = "line ";
  std::vector<Row> Rows;
};

/// number: of a row; 0: the whole table.
void Table::Refuse(int number, const std::string& problem) const
{
  throw InputError("Cannot read the names of labels from " + this->Path +
    (number > 0 ? ", " + this->NameRow(number) : "") + ": " + problem);
}

/// The name in what follows the label; end: what parts it from what follows.
std::string FindName(const std::string& rest, char end)
{
  const std::size_t quote = rest.find('"'), last = rest.rfind('"');
  if (quote != last)
  {
    return Trim(rest.substr(quote + 1, last - quote - 1));
  }
  return Trim(rest.substr(0, rest.find(end)));
}

void Table::ReadLine(const std::string& line, int number)
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
    this->Refuse(number,
      "it begins with '" + first.substr(0, 40) + "', which is no label: a whole number from 0 to " +
        std::to_string(std::numeric_limits<int>::max()) + ".");
  }
  Row row;
  row.Place = number;
  row.Label = *label;
  const std::size_t next = line.find_first_not_of(" \t", end);
  const bool isParted = next != std::string::npos && (line[next] == ',' || line[next] == ';');
  const std::string rest =
    next == std::string::npos ? "" : Trim(line.substr(next + (isParted ? 1 : 0)));
  row.Name = FindName(rest, isParted ? line[next] : '\t');
  if (row.Name.empty())
  {
    this->Refuse(number, "label " + first + " has no name.");
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
  this->Add(row);
}

void Table::ReadText(std::istream& stream)
{
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    line = Trim(line);
    if (!line.empty() && line[0] != '#')
    {
      this->ReadLine(line, number);
    }
  }
}

/// Whether all names are of one word, followed by as many numbers.
bool Table::HasColumnsOfNumbers() const
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

LabelNames Table::MakeNames()
{
  if (this->Rows.empty())
  {
    this->Refuse(0, "it holds none.");
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
      this->Refuse(row.Place,
        "label " + std::to_string(row.Label) + " is in " + this->NameRow(label.first->second) +
          " too.");
    }
    const auto name = named.emplace(row.Name, &row);
    if (!name.second)
    {
      const Row& other = *name.first->second;
      this->Refuse(row.Place,
        "the name '" + row.Name + "' is that of label " + std::to_string(other.Label) + " in " +
          this->NameRow(other.Place) + " too.");
    }
    names[row.Label] = row.Name;
  }
  return names;
}

/// An atlas of FSL: the index is an attribute of a label's element, the name its text.
void Table::ReadXml()
{
  this->Unit = "element ";
  vtkNew<vtkXMLDataParser> parser;
  vtkNew<vtkCallbackCommand> quiet; // what is wrong is told below
  parser->AddObserver(vtkCommand::ErrorEvent, quiet);
  parser->SetFileName(this->Path.c_str());
  vtkXMLDataElement* root = parser->Parse() ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement* header = root ? root->FindNestedElementWithName("header") : nullptr;
  vtkXMLDataElement* type = header ? header->FindNestedElementWithName("type") : nullptr;
  vtkXMLDataElement* data = root ? root->FindNestedElementWithName("data") : nullptr;
  if (!type || !data || !type->GetCharacterData())
  {
    this->Refuse(0, "it is no XML file of an atlas (header with a type, data).");
  }
  const bool isOfProbabilities = Trim(type->GetCharacterData()) == "Probabilistic";
  for (int i = 0; i < data->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = data->GetNestedElement(i);
    const char *index = element->GetAttribute("index"), *name = element->GetCharacterData();
    const std::optional<int> label = ParseLabel(index ? index : "");
    if (!label || *label == std::numeric_limits<int>::max() || !name || Trim(name).empty())
    {
      this->Refuse(i + 1, "it has no index or no name.");
    }
    Row row;
    row.Place = i + 1;
    row.Label = *label + (isOfProbabilities ? 1 : 0);
    row.Name = JoinWords(name);
    this->Add(row);
  }
}

} // namespace

LabelNames ReadLabelNames(const std::string& path)
{
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    throw InputError("Cannot read the names of labels from " + path + ": " +
      (errno ? std::strerror(errno) : "the file is empty") + ".");
  }
  Table table(path);
  if (stream.peek() == '<')
  {
    table.ReadXml();
  }
  else
  {
    table.ReadText(stream);
  }
  return table.MakeNames();
}

LabelNames ShareLabelNames(const std::string& path, Ranks& ranks)
{
  LabelNames names;
  Bytes text;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0 && !path.empty())
      {
        for (const auto& entry : ReadLabelNames(path))
        {
          const std::string line = std::to_string(entry.first) + " " + entry.second + "\n";
          text.insert(text.end(), line.begin(), line.end());
        }
      }
    });
  const Bytes first = ranks.Gather(text)[0];
  std::istringstream stream(std::string(first.begin(), first.end()));
  int label = 0;
  for (std::string name; stream >> label && std::getline(stream, name);)
  {
    names[label] = name.substr(1);
  }
  return names;
}

} // namespace vfm
