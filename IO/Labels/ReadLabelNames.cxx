#include "ReadLabelNames.h"

#include "AtlasXml.h"
#include "Ranks/WorkTogether.h"
#include "Summary/UniqueNames.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace vfm
{

namespace
{

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
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    throw InputError("Cannot read the names of labels from " + path + ": " +
      (errno ? std::strerror(errno) : "the file is empty") + ".");
  }
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
  std::string note;
  Bytes text;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0 && !path.empty())
      {
        for (const auto& entry : ReadLabelNames(path, &note))
        {
          const std::string line = std::to_string(entry.first) + " " + entry.second + "\n";
          text.insert(text.end(), line.begin(), line.end());
        }
      }
    });
  const Bytes first = ranks.Gather(text)[0];
  const Bytes noted = ranks.Gather(Bytes(note.begin(), note.end()))[0];
  if (!noted.empty())
  {
    warn(std::string(noted.begin(), noted.end()));
  }
  std::istringstream stream(std::string(first.begin(), first.end()));
  int label = 0;
  for (std::string name; stream >> label && std::getline(stream, name);)
  {
    names[label] = name.substr(1);
  }
  return names;
}

} // namespace vfm
