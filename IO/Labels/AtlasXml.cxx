#include "AtlasXml.h"

#ifdef VFM_HAS_EXPAT
#include "XmlParser.h"

#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

struct AtlasLabel
{
  std::string Index, Name;
};

/// State of the parser.
struct Atlas
{
  std::vector<std::string> Path; ///< names of the open elements, outermost first
  std::string Type;
  bool HasData = false;
  std::vector<AtlasLabel> Labels;
};

/// Tests whether the innermost open element is named `place`, or anything if that is empty, inside
/// an element named `parent` of the root.
bool IsIn(const Atlas& atlas, const char* place, const char* parent)
{
  const std::size_t depth = atlas.Path.size();
  return depth == 3 && atlas.Path[1] == parent && (!*place || atlas.Path[2] == place);
}

void Start(void* user, const XML_Char* name, const XML_Char** attributes)
{
  Atlas& atlas = *static_cast<Atlas*>(user);
  atlas.Path.push_back(name);
  atlas.HasData = atlas.HasData || (atlas.Path.size() == 2 && atlas.Path[1] == "data");
  if (!IsIn(atlas, "", "data"))
  {
    return;
  }
  atlas.Labels.emplace_back();
  for (; *attributes; attributes += 2)
  {
    if (std::string("index") == attributes[0])
    {
      atlas.Labels.back().Index = attributes[1];
    }
  }
}

void End(void* user, const XML_Char*)
{
  static_cast<Atlas*>(user)->Path.pop_back();
}

void AddText(void* user, const XML_Char* text, int length)
{
  Atlas& atlas = *static_cast<Atlas*>(user);
  if (IsIn(atlas, "type", "header"))
  {
    atlas.Type.append(text, length);
  }
  else if (IsIn(atlas, "", "data"))
  {
    atlas.Labels.back().Name.append(text, length);
  }
}

/// Returns the words of a text, which may have several lines, separated by one space.
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

} // namespace

void ReadAtlasXml(const std::string& text, LabelTable& table)
{
  Atlas atlas;
  const XmlParser parser = MakeXmlParser(&atlas, Start, End);
  XML_SetCharacterDataHandler(parser.get(), AddText);
  const bool isXml = XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), 1);
  if (!isXml || atlas.Type.empty() || !atlas.HasData)
  {
    const std::string problem = isXml ? "" : XML_ErrorString(XML_GetErrorCode(parser.get()));
    table.Reject(0,
      "it is not the XML file of an atlas (header with a type, data)" +
        (isXml ? "."
               : "; line " + std::to_string(PlaceOf(parser.get()).Line) + ": " + problem + "."));
  }
  const bool isOfProbabilities = JoinWords(atlas.Type) == "Probabilistic";
  for (std::size_t i = 0; i < atlas.Labels.size(); ++i)
  {
    const int place = static_cast<int>(i) + 1;
    const std::optional<int> label = LabelTable::ParseLabel(atlas.Labels[i].Index);
    const std::string name = JoinWords(atlas.Labels[i].Name);
    if (!label || *label == std::numeric_limits<int>::max() || name.empty())
    {
      table.Reject(place, "it has no index or no name.");
    }
    table.AddElement(place, *label + (isOfProbabilities ? 1 : 0), name);
  }
}

} // namespace vfm

#else

void vfm::ReadAtlasXml(const std::string&, LabelTable& table)
{
  table.Reject(0, "this build cannot read XML, because it was made without expat.");
}

#endif
