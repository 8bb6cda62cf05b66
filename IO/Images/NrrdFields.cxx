#include "Images/NrrdFields.h"

#include "Base/ParseText.h"
#include "OpenFile.h"
#include "ReadLine.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr Index LongestHeader = 1 << 26; // bytes

/// Rejects a line of a truncated header or of another format.
void CheckLine(const std::string& line, bool hasEnd)
{
  const bool isText = std::none_of(line.begin(), line.end(),
    [](unsigned char c) { return (c < ' ' && c != '\t' && c != '\r') || c == 127; });
  if (!hasEnd || !isText)
  {
    throw InputError(
      "its header is not a text that ends with an empty line or with the end of a line.");
  }
}

/// Adds a line 'field: value' or 'key:=value'.
void AddLine(const std::string& line, NrrdFields& fields)
{
  const std::size_t colon = line.find(':');
  const char next = colon + 1 < line.size() ? line[colon + 1] : '\0';
  if (colon == std::string::npos || (next != ' ' && next != '='))
  {
    throw InputError("its header has the line '" + line.substr(0, 80) +
      "', which is neither 'field: value' nor 'key:=value'.");
  }
  std::string name = line.substr(0, colon);
  const std::string value = TrimText(line.substr(colon + 2));
  const std::pair<const char*, const char*> others[] = { { "datafile", "data file" },
    { "lineskip", "line skip" }, { "byteskip", "byte skip" } };
  for (const auto& [other, usual] : others)
  {
    name = name == other ? usual : name;
  }
  auto& to = next == '=' ? fields.Pairs : fields.Fields;
  if (!to.emplace(name, value).second)
  {
    throw InputError("its header has the line '" + name.substr(0, 80) + "' twice.");
  }
}

void CheckMagic(std::istream& stream)
{
  char magic[4] = {};
  stream.read(magic, sizeof(magic));
  if (std::string(magic, sizeof(magic)) != "NRRD")
  {
    throw InputError("it is not an NRRD file.");
  }
}

} // namespace

NrrdFields ReadNrrdFields(const std::string& path)
{
  std::ifstream stream = OpenFile(path);
  CheckMagic(stream);
  NrrdFields fields;
  std::string line;
  Index length = 0;
  bool isFirst = true, isList = false;
  for (; ReadLine(stream, line) && length < LongestHeader; isFirst = false)
  {
    CheckLine(line, !stream.eof());
    length += static_cast<Index>(line.size()) + 1;
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.empty() && !isFirst)
    {
      fields.Length = static_cast<Index>(stream.tellg());
      return fields;
    }
    if (isList)
    {
      fields.List.push_back(line);
    }
    else if (!isFirst && line[0] != '#')
    {
      AddLine(line, fields);
      const std::string file = fields.Find("data file", "");
      isList = file == "LIST" || file.compare(0, 5, "LIST ") == 0;
    }
  }
  if (length >= LongestHeader)
  {
    throw InputError("its header has more than " + std::to_string(LongestHeader) + " bytes.");
  }
  return fields;
}

} // namespace vfm
