#include "ReadLabelNames.h"

#include "AtlasXml.h"
#include "InputTrust.h"
#include "OpenFile.h"
#include "Ranks/WorkTogether.h"
#include "Report/UniqueNames.h"

#include <fstream>
#include <iterator>
#include <sstream>

namespace vfm
{
namespace
{

constexpr Index LongestTable = 1 << 24; // bytes

std::ifstream OpenTable(const std::string& path)
{
  std::ifstream stream;
  PrefixErrors("Cannot read the names of labels from " + path + ": ",
    [&]
    {
      stream = OpenFile(path);
      const Index length = GetFileLength(path);
      if (length > LongestTable && !InputTrust::IsGiven())
      {
        throw InputError("it has " + std::to_string(length) + " bytes; tables of up to " +
          std::to_string(LongestTable) + " bytes are read. " + InputTrust::Advice);
      }
    });
  return stream;
}

/// Skips the mark at the start of a text in UTF-8.
/// @throws InputError  if the text begins with the mark of UTF-16
void SkipMark(std::istream& stream, const std::string& path)
{
  constexpr std::size_t length = 3;
  char start[length] = {};
  stream.read(start, length);
  const std::string_view mark(start, static_cast<std::size_t>(stream.gcount()));
  if (mark.substr(0, 2) == "\xff\xfe" || mark.substr(0, 2) == "\xfe\xff")
  {
    throw InputError(
      "Cannot read the names of labels from " + path + ": it is UTF-16. Save it as UTF-8.");
  }
  if (mark != "\xef\xbb\xbf")
  {
    stream.clear();
    stream.seekg(0);
  }
}

/// Returns the text of an XML file that does not declare its encoding, in UTF-8.
std::string ReadXml(std::istream& stream)
{
  const std::string text{ std::istreambuf_iterator<char>(stream), {} };
  return text.substr(0, text.find('>')).find("encoding") == std::string::npos ? ToUtf8(text) : text;
}

} // namespace

LabelNames ReadLabelNames(const std::string& path, std::string* note)
{
  std::ifstream stream = OpenTable(path);
  SkipMark(stream, path);
  const bool isXml = stream.peek() == '<';
  LabelTable table(path, isXml ? "element " : "line ");
  if (isXml)
  {
    ReadAtlasXml(ReadXml(stream), table);
  }
  else
  {
    table.ReadText(stream);
  }
  if (note)
  {
    *note = table.Note();
  }
  return table.MakeNames();
}

LabelNames ShareLabelNames(
  const std::string& path, Ranks& ranks, const std::function<void(const std::string&)>& warn)
{
  LabelNames names;
  Bytes note;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0 && !path.empty())
      {
        std::string text;
        names = ReadLabelNames(path, &text);
        note.assign(text.begin(), text.end());
      }
    });
  const Bytes noted = ranks.Gather(note)[0];
  if (!noted.empty())
  {
    warn(std::string(noted.begin(), noted.end()));
  }
  return UniteLabelNames(names, ranks);
}

LabelNames UniteLabelNames(const LabelNames& names, Ranks& ranks)
{
  Bytes text;
  for (const auto& entry : names)
  {
    const std::string line = std::to_string(entry.first) + " " + entry.second + "\n";
    text.insert(text.end(), line.begin(), line.end());
  }
  LabelNames united;
  for (const Bytes& ofRank : ranks.Gather(text))
  {
    std::istringstream stream(std::string(ofRank.begin(), ofRank.end()));
    std::string label, name;
    while (std::getline(stream, label, ' ') && std::getline(stream, name))
    {
      united.emplace(std::stoi(label), name);
    }
  }
  return united;
}

} // namespace vfm
