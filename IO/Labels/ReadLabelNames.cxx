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
