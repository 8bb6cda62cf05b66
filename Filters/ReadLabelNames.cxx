#include "ReadLabelNames.h"

#include "Input/LabelTable.h"
#include "Ranks/WorkTogether.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

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

/// An atlas of FSL: the index is an attribute of a label's element, the name its text.
void ReadXml(const std::string& path, LabelTable& table)
{
  vtkNew<vtkXMLDataParser> parser;
  vtkNew<vtkCallbackCommand> quiet; // what is wrong is told below
  parser->AddObserver(vtkCommand::ErrorEvent, quiet);
  parser->SetFileName(path.c_str());
  vtkXMLDataElement* root = parser->Parse() ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement* header = root ? root->FindNestedElementWithName("header") : nullptr;
  vtkXMLDataElement* type = header ? header->FindNestedElementWithName("type") : nullptr;
  vtkXMLDataElement* data = root ? root->FindNestedElementWithName("data") : nullptr;
  if (!type || !data || !type->GetCharacterData())
  {
    table.Refuse(0, "it is no XML file of an atlas (header with a type, data).");
  }
  const bool isOfProbabilities = JoinWords(type->GetCharacterData()) == "Probabilistic";
  for (int i = 0; i < data->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = data->GetNestedElement(i);
    const char *index = element->GetAttribute("index"), *text = element->GetCharacterData();
    const std::optional<int> label = LabelTable::ParseLabel(index ? index : "");
    const std::string name = JoinWords(text ? text : "");
    if (!label || *label == std::numeric_limits<int>::max() || name.empty())
    {
      table.Refuse(i + 1, "it has no index or no name.");
    }
    table.AddElement(i + 1, *label + (isOfProbabilities ? 1 : 0), name);
  }
}

} // namespace

LabelNames ReadLabelNames(const std::string& path)
{
  return ReadLabelTable(path, [&path](LabelTable& table) { ReadXml(path, table); });
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
