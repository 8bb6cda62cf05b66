#include "Summary/AtlasXml.h"

#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

struct XmlElement
{
  std::string Attributes, Content;
};

/// Removes all from the first text to the next of the second, both included.
void Remove(const std::string& first, const std::string& last, std::string& text)
{
  for (std::size_t begin; (begin = text.find(first)) != std::string::npos;)
  {
    const std::size_t end = text.find(last, begin);
    text.erase(begin, end == std::string::npos ? end : end + last.size() - begin);
  }
}

/// Takes the next element off the text: the first of that name, any if it is empty. Elements do not nest in others of their name.
std::optional<XmlElement> TakeElement(const std::string& name, std::string& text)
{
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at)
  {
    const std::size_t endOfName = text.find_first_of(" \t\r\n/>", at + 1);
    const std::size_t endOfTag = text.find('>', at);
    if (endOfTag == std::string::npos)
    {
      break;
    }
    const std::string found = text.substr(at + 1, endOfName - at - 1);
    if (found.empty() || (!name.empty() && found != name))
    {
      continue;
    }
    XmlElement element{ text.substr(endOfName, endOfTag - endOfName), "" };
    std::size_t end = endOfTag + 1;
    if (text[endOfTag - 1] != '/')
    {
      const std::string close = "</" + found + ">";
      const std::size_t closed = text.find(close, end);
      if (closed == std::string::npos)
      {
        break;
      }
      element.Content = text.substr(end, closed - end);
      end = closed + close.size();
    }
    text.erase(0, end);
    return element;
  }
  return std::nullopt;
}

std::string FindAttribute(const XmlElement& element, const std::string& name)
{
  std::size_t at = element.Attributes.find(" " + name + "=");
  at = at == std::string::npos ? at : at + name.size() + 2;
  if (at == std::string::npos || at >= element.Attributes.size())
  {
    return "";
  }
  const std::size_t end = element.Attributes.find(element.Attributes[at], at + 1);
  return element.Attributes.substr(at + 1, end - at - 1);
}

/// The words, which may fill several lines, with a blank between; characters that have names in XML as they are.
std::string PlainText(const std::string& content)
{
  std::istringstream words(content);
  std::string plain;
  for (std::string word; words >> word;)
  {
    plain += (plain.empty() ? "" : " ") + word;
  }
  const std::pair<const char*, const char*> names[] = { { "&lt;", "<" }, { "&gt;", ">" },
    { "&quot;", "\"" }, { "&apos;", "'" }, { "&amp;", "&" } };
  for (const auto& [name, character] : names)
  {
    for (std::size_t at = 0; (at = plain.find(name, at)) != std::string::npos; ++at)
    {
      plain.replace(at, std::char_traits<char>::length(name), character);
    }
  }
  return plain;
}

std::string FromLatin1(const std::string& text)
{
  std::string converted;
  for (const unsigned char c : text)
  {
    if (c < 0x80)
    {
      converted += static_cast<char>(c);
      continue;
    }
    converted += static_cast<char>(0xc0 | c >> 6);
    converted += static_cast<char>(0x80 | (c & 0x3f));
  }
  return converted;
}

} // namespace

void ReadAtlasXml(std::string text, LabelTable& table)
{
  const bool isLatin1 = text.substr(0, text.find("?>")).find("ISO-8859-1") != std::string::npos;
  text = isLatin1 ? FromLatin1(text) : text;
  Remove("<!--", "-->", text);
  Remove("<?", "?>", text);
  std::optional<XmlElement> header = TakeElement("header", text);
  const auto type = header ? TakeElement("type", header->Content) : std::nullopt;
  std::optional<XmlElement> data = TakeElement("data", text);
  if (!type || !data)
  {
    table.Refuse(0, "it is no XML file of an atlas (header with a type, data).");
  }
  const bool isOfProbabilities = PlainText(type->Content) == "Probabilistic";
  int place = 1;
  for (; const auto element = TakeElement("", data->Content); ++place)
  {
    const std::optional<int> label = LabelTable::ParseLabel(FindAttribute(*element, "index"));
    const std::string name = PlainText(element->Content);
    if (!label || *label == std::numeric_limits<int>::max() || name.empty())
    {
      table.Refuse(place, "it has no index or no name.");
    }
    table.AddElement(place, *label + (isOfProbabilities ? 1 : 0), name);
  }
  if (data->Content.find('<') != std::string::npos)
  {
    table.Refuse(place, "it has no end.");
  }
}

} // namespace vfm
