#include "Images/XmlElements.h"

#include "XmlParser.h"

#include <limits>

namespace vfm
{
namespace
{

/// State of the parser.
struct Document
{
  std::vector<XmlElement> Elements;
  std::vector<std::size_t> Open; ///< indices of the open elements, outermost first
};

void Start(void* user, const XML_Char* name, const XML_Char** attributes)
{
  Document& document = *static_cast<Document*>(user);
  const std::string whole = name;
  XmlElement element;
  element.Name = whole.substr(whole.find(':') + 1); // npos + 1 is 0
  for (; *attributes; attributes += 2)
  {
    element.Attributes[attributes[0]] = attributes[1];
  }
  document.Open.push_back(document.Elements.size());
  document.Elements.push_back(std::move(element));
}

void End(void* user, const XML_Char*)
{
  static_cast<Document*>(user)->Open.pop_back();
}

void AddText(void* user, const XML_Char* text, int length)
{
  Document& document = *static_cast<Document*>(user);
  document.Elements[document.Open.back()].Text.append(text, length);
}

} // namespace

std::optional<std::vector<XmlElement>> ListElements(const std::string& text)
{
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    return std::nullopt;
  }
  Document document;
  const XmlParser parser = MakeXmlParser(&document, Start, End);
  XML_SetCharacterDataHandler(parser.get(), AddText);
  if (!XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), 1))
  {
    return std::nullopt;
  }
  return std::move(document.Elements);
}

} // namespace vfm
