#include "ReadLabelNames.h"

#include "AtlasXml.h"
#include "InputTrust.h"
#include "OpenFile.h"
#include "Ranks/WorkTogether.h"

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

} // namespace

LabelNames ReadLabelNames(const std::string& path)
{
  std::ifstream stream = OpenTable(path);
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
