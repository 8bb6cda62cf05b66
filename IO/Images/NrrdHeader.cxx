#include "Images/NrrdHeader.h"

#include "Images/ImagePlace.h"
#include "OpenFile.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace vfm
{
namespace
{

constexpr std::size_t LongestLine = 100000;

/// VTK's reader does not end where the last line of the header has no end, be it for a zero in it.
void CheckLine(const std::string& line, bool hasEnd)
{
  const bool isText = std::none_of(line.begin(), line.end(),
    [](unsigned char c) { return (c < ' ' && c != '\t' && c != '\r') || c == 127; });
  if (!hasEnd || line.size() > LongestLine || !isText)
  {
    throw InputError("its header is no text that ends with an empty line or the end of a line.");
  }
}

/// The fields of the header by their names.
std::map<std::string, std::string> ReadFields(const std::string& path, Index& length)
{
  std::ifstream stream = OpenFile(path);
  std::string line;
  std::getline(stream, line);
  if (line.compare(0, 4, "NRRD") != 0)
  {
    throw InputError("it is no NRRD file.");
  }
  CheckLine(line, !stream.eof());
  std::map<std::string, std::string> fields;
  bool hasEnd = false;
  while (!hasEnd && std::getline(stream, line))
  {
    CheckLine(line, !stream.eof());
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    hasEnd = line.empty();
    const std::size_t colon = line.find(": ");
    if (!hasEnd && line[0] != '#' && colon != std::string::npos)
    {
      fields[line.substr(0, colon)] = line.substr(colon + 2);
    }
  }
  length = stream ? static_cast<Index>(stream.tellg()) : 0;
  return fields;
}

/// As many numbers as the text begins with; signs, commas and brackets between them do not count.
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

/// n numbers, or an error.
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
      (n == 1 ? " number is" : " numbers are") + " wanted.");
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

} // namespace

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  NrrdHeader header;
  const std::map<std::string, std::string> fields = ReadFields(path, header.Length);
  const double dimension = ParseField(fields, "dimension", 1)[0];
  if (dimension != 3.0)
  {
    throw InputError("its image has " + std::to_string(static_cast<int>(dimension)) +
      " dimensions; wanted are three, with one value a point.");
  }
  const std::vector<double> sizes = ParseField(fields, "sizes", 3);
  for (std::size_t a = 0; a < 3; ++a)
  {
    header.Size[a] = ToSize(sizes[a]);
  }
  ReadSteps(fields, header);
  const auto encoding = fields.find("encoding");
  const std::string coded = encoding == fields.end() ? "" : encoding->second;
  header.IsRaw = coded == "raw";
  if (!header.IsRaw && coded != "gzip" && coded != "gz")
  {
    throw InputError("its encoding is '" + coded.substr(0, 80) + "'; read are raw and gzip.");
  }
  for (const char* name : { "data file", "datafile" })
  {
    header.Values = fields.count(name) > 0 ? fields.at(name) : header.Values;
  }
  return header;
}

} // namespace vfm
