#include "Images/NrrdHeader.h"

#include "Images/ImagePlace.h"
#include "Images/StoredValues.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace vfm
{
namespace
{

constexpr std::size_t LongestLine = 100000;
constexpr double LargestSkip = 1e15;

/// Rejects a line of a truncated header or of another format.
void CheckLine(const std::string& line, bool hasEnd)
{
  const bool isText = std::none_of(line.begin(), line.end(),
    [](unsigned char c) { return (c < ' ' && c != '\t' && c != '\r') || c == 127; });
  if (!hasEnd || line.size() > LongestLine || !isText)
  {
    throw InputError(
      "its header is not a text that ends with an empty line or with the end of a line.");
  }
}

/// Reads the fields of the header, by name.
/// @param[out] length  length of the header, bytes
std::map<std::string, std::string> ReadFields(const std::string& path, Index& length)
{
  std::ifstream stream = OpenFile(path);
  std::string line;
  std::getline(stream, line);
  if (line.compare(0, 4, "NRRD") != 0)
  {
    throw InputError("it is not an NRRD file.");
  }
  CheckLine(line, !stream.eof());
  std::map<std::string, std::string> fields;
  bool hasEnd = false, isList = false;
  std::string& list = fields["LIST"]; // names of files, one per line
  while (!hasEnd && std::getline(stream, line))
  {
    CheckLine(line, !stream.eof());
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    hasEnd = line.empty();
    const std::size_t colon = line.find(": ");
    if (!hasEnd && isList)
    {
      list += line + "\n";
    }
    else if (!hasEnd && line[0] != '#' && colon != std::string::npos)
    {
      fields[line.substr(0, colon)] = line.substr(colon + 2);
      isList = line.compare(0, 4, "data") == 0 && line.compare(colon, 6, ": LIST") == 0;
    }
  }
  length = stream ? static_cast<Index>(stream.tellg()) : 0;
  return fields;
}

/// Returns all numbers at the beginning of a text; brackets and commas between them are ignored.
std::vector<double> ParseNumbers(std::string text)
{
  for (char& c : text)
  {
    c = c == '(' || c == ')' || c == ',' ? ' ' : c;
  }
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number; stream >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

/// Returns the n numbers of a field.
/// @throws InputError  if the field is missing or does not have n numbers
std::vector<double> ParseField(
  const std::map<std::string, std::string>& fields, const std::string& name, std::size_t n)
{
  const auto found = fields.find(name);
  const std::vector<double> numbers =
    found == fields.end() ? std::vector<double>() : ParseNumbers(found->second);
  if (numbers.size() != n)
  {
    throw InputError("its header says '" + name + ": " +
      (found == fields.end() ? "" : found->second.substr(0, 80)) + "', where " + std::to_string(n) +
      (n == 1 ? " number is" : " numbers are") + " required.");
  }
  return numbers;
}

void ReadSteps(const std::map<std::string, std::string>& fields, NrrdHeader& header)
{
  if (fields.count("space directions") > 0)
  {
    const std::vector<double> all = ParseField(fields, "space directions", 9);
    for (std::size_t i = 0; i < 9; ++i)
    {
      header.Steps[i / 3][i % 3] = all[i];
    }
  }
  else if (fields.count("spacings") > 0)
  {
    const std::vector<double> all = ParseField(fields, "spacings", 3);
    for (std::size_t a = 0; a < 3; ++a)
    {
      header.Steps[a][a] = all[a];
    }
  }
  if (fields.count("space origin") > 0)
  {
    const std::vector<double> origin = ParseField(fields, "space origin", 3);
    std::copy_n(origin.begin(), 3, header.Origin.begin());
  }
}

std::string FindField(const std::map<std::string, std::string>& fields, const std::string& name,
  const std::string& without)
{
  const auto found = fields.find(name);
  std::string text = found == fields.end() ? without : found->second;
  text.erase(text.find_last_not_of(" \t") + 1);
  return text;
}

int FindType(const std::string& name)
{
  static const std::map<std::string, int> types{ { "signed char", ValueType::SignedChar },
    { "int8", ValueType::SignedChar }, { "int8_t", ValueType::SignedChar },
    { "uchar", ValueType::UnsignedChar }, { "unsigned char", ValueType::UnsignedChar },
    { "uint8", ValueType::UnsignedChar }, { "uint8_t", ValueType::UnsignedChar },
    { "short", ValueType::Short }, { "short int", ValueType::Short },
    { "signed short", ValueType::Short }, { "signed short int", ValueType::Short },
    { "int16", ValueType::Short }, { "int16_t", ValueType::Short },
    { "ushort", ValueType::UnsignedShort }, { "unsigned short", ValueType::UnsignedShort },
    { "unsigned short int", ValueType::UnsignedShort }, { "uint16", ValueType::UnsignedShort },
    { "uint16_t", ValueType::UnsignedShort }, { "int", ValueType::Int },
    { "signed int", ValueType::Int }, { "int32", ValueType::Int }, { "int32_t", ValueType::Int },
    { "uint", ValueType::UnsignedInt }, { "unsigned int", ValueType::UnsignedInt },
    { "uint32", ValueType::UnsignedInt }, { "uint32_t", ValueType::UnsignedInt },
    { "longlong", ValueType::LongLong }, { "long long", ValueType::LongLong },
    { "long long int", ValueType::LongLong }, { "signed long long", ValueType::LongLong },
    { "signed long long int", ValueType::LongLong }, { "int64", ValueType::LongLong },
    { "int64_t", ValueType::LongLong }, { "ulonglong", ValueType::UnsignedLongLong },
    { "unsigned long long", ValueType::UnsignedLongLong },
    { "unsigned long long int", ValueType::UnsignedLongLong },
    { "uint64", ValueType::UnsignedLongLong }, { "uint64_t", ValueType::UnsignedLongLong },
    { "float", ValueType::Float }, { "double", ValueType::Double } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    throw InputError("its values are of type '" + name.substr(0, 80) +
      "'. Supported types: integers of 1 to 8 bytes, floating point of 4 or 8 bytes.");
  }
  return found->second;
}

/// Returns whether a byte order, "little" or "big", differs from that of this machine.
bool IsSwapped(const std::string& order)
{
  if (order != "little" && order != "big")
  {
    throw InputError("its endian is '" + order.substr(0, 80) + "'; it must be little or big.");
  }
  return (order == "little") != IsLittleEndian();
}

/// Returns the number of bytes of the data before the first value.
Index FindSkip(const std::map<std::string, std::string>& fields)
{
  if (FindField(fields, "line skip", "0") != "0")
  {
    throw InputError("its header has a line skip, which is not supported.");
  }
  const bool hasSkip = fields.count("byte skip") > 0;
  const double skip = hasSkip ? ParseField(fields, "byte skip", 1)[0] : 0.0;
  if (!(skip >= 0.0 && skip < LargestSkip))
  {
    throw InputError("its byte skip is not a number of bytes from 0.");
  }
  return static_cast<Index>(skip);
}

/// Returns the files with the values: a list, a pattern with first, last and step, or one file.
std::vector<std::string> FindFiles(const std::map<std::string, std::string>& fields, Index most)
{
  const std::string name = FindField(fields, "data file", FindField(fields, "datafile", ""));
  std::vector<std::string> files;
  std::istringstream list(fields.at("LIST")), words(name);
  for (std::string line; std::getline(list, line);)
  {
    files.push_back(line);
  }
  std::string pattern;
  double first = 0.0, last = 0.0, step = 0.0;
  if (files.empty() && words >> pattern >> first >> last >> step)
  {
    return ListNumberedFiles(pattern, first, last, step, most);
  }
  return files.empty() && !name.empty() ? std::vector<std::string>{ name } : files;
}

} // namespace

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  NrrdHeader header;
  const std::map<std::string, std::string> fields = ReadFields(path, header.Length);
  const double dimension = ParseField(fields, "dimension", 1)[0];
  if (dimension != 3.0)
  {
    throw InputError("its image has " + std::to_string(static_cast<int>(dimension)) +
      " dimensions; three are required, with one value per point.");
  }
  const std::vector<double> sizes = ParseField(fields, "sizes", 3);
  for (std::size_t a = 0; a < 3; ++a)
  {
    header.Size[a] = ToSize(sizes[a]);
  }
  ReadSteps(fields, header);
  const std::string coded = FindField(fields, "encoding", "");
  header.IsRaw = coded == "raw";
  if (!header.IsRaw && coded != "gzip" && coded != "gz")
  {
    throw InputError(
      "its encoding is '" + coded.substr(0, 80) + "'. Supported encodings: raw and gzip.");
  }
  header.Type = FindType(FindField(fields, "type", ""));
  header.IsSwapped = WidthOfType(header.Type) > 1 && IsSwapped(FindField(fields, "endian", ""));
  header.Skip = FindSkip(fields);
  header.Files = FindFiles(fields, header.Size[2]);
  return header;
}

} // namespace vfm
