#include "ReadLabelNames.h"

#include "AtlasXml.h"
#include "Ranks/WorkTogether.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace vfm
{

LabelNames ReadLabelNames(const std::string& path)
{
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    throw InputError("Cannot read the names of labels from " + path + ": " +
      (errno ? std::strerror(errno) : "the file is empty") + ".");
  }
  const bool isXml = stream.peek() == '<';
  LabelTable table(path, isXml ? "element " : "line ");
  if (isXml)
  {
    ReadAtlasXml({ std::istreambuf_iterator<char>(stream), {} }, table);
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
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0 && !path.empty())
      {
        names = ReadLabelNames(path);
      }
    });
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
    int label = 0;
    for (std::string name; stream >> label && std::getline(stream, name);)
    {
      united.emplace(label, name.substr(1));
    }
  }
  return united;
}

} // namespace vfm
