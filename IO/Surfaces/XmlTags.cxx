#include "Surfaces/XmlTags.h"

#include "Ranks/Errors.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace vfm
{
namespace
{

constexpr std::size_t Deepest = 64; // levels of elements
constexpr std::size_t MostAttributes = 256;

bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool IsOfName(char c)
{
  return !IsSpace(c) && c != '=' && c != '>' && c != '/' && c != '<' && c != '"' && c != '\'' &&
    c != '\0';
}

/// Appends a character in UTF-8.
void AddCharacter(unsigned int code, std::string& text)
{
  if (code < 0x80)
  {
    text += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  const unsigned int first[] = { 0, 0xc0, 0xe0, 0xf0 };
  text += static_cast<char>(first[more] | code >> (6 * more));
  for (int part = more - 1; part >= 0; --part)
  {
    text += static_cast<char>(0x80 | (code >> (6 * part) & 0x3f));
  }
}

/// Appends the character of a reference such as amp or #65. Returns whether it is one.
bool AddReference(std::string_view name, std::string& text)
{
  static const std::map<std::string_view, char> names{ { "amp", '&' }, { "lt", '<' }, { "gt", '>' },
    { "quot", '"' }, { "apos", '\'' } };
  const auto found = names.find(name);
  if (found != names.end())
  {
    text += found->second;
    return true;
  }
  const bool isHex = name.substr(0, 2) == "#x";
  const std::string_view digits = name.substr(std::min<std::size_t>(isHex ? 2 : 1, name.size()));
  unsigned int code = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, code, isHex ? 16 : 10);
  const bool isCharacter =
    name.substr(0, 1) == "#" && error == std::errc() && stop == end && code > 0 && code < 0x110000;
  if (isCharacter)
  {
    AddCharacter(code, text);
  }
  return isCharacter;
}

} // namespace

std::string ReplaceReferences(std::string_view text)
{
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    const std::size_t end = text[at] == '&' ? text.find(';', at) : std::string_view::npos;
    if (end != std::string_view::npos && AddReference(text.substr(at + 1, end - at - 1), plain))
    {
      at = end;
    }
    else
    {
      plain += text[at];
    }
  }
  return plain;
}

std::string_view XmlTag::Raw(std::string_view name) const
{
  for (const auto& [key, value] : this->Attributes)
  {
    if (key == name)
    {
      return value;
    }
  }
  return {};
}

std::string XmlTag::Get(std::string_view name) const
{
  return ReplaceReferences(this->Raw(name));
}

void XmlTags::Reject(const char* problem) const
{
  const auto end =
    this->Text.begin() + static_cast<std::ptrdiff_t>(std::min(this->Place, this->Text.size()));
  throw InputError("it is truncated or damaged: it is not XML in line " +
    std::to_string(1 + std::count(this->Text.begin(), end, '\n')) + " (" + problem + ").");
}

/// Goes behind a text. Returns whether it follows.
bool XmlTags::SkipTo(std::string_view end)
{
  const std::size_t found = this->Text.find(end, this->Place);
  this->Place = found == std::string_view::npos ? this->Text.size() : found + end.size();
  return found != std::string_view::npos;
}

void XmlTags::SkipSpaces()
{
  while (this->Place < this->Text.size() && IsSpace(this->Text[this->Place]))
  {
    ++this->Place;
  }
}

std::string_view XmlTags::Name()
{
  const std::size_t begin = this->Place;
  while (this->Place < this->Text.size() && IsOfName(this->Text[this->Place]))
  {
    ++this->Place;
  }
  if (this->Place == begin || this->Place == this->Text.size())
  {
    this->Reject("a name is missing");
  }
  return this->Text.substr(begin, this->Place - begin);
}

void XmlTags::Close(std::string_view name)
{
  if (this->Open.empty() || this->Open.back() != name)
  {
    this->Reject("an element ends that is not open");
  }
  this->Open.pop_back();
}

void XmlTags::ReadAttribute(XmlTag& tag)
{
  const std::string_view name = this->Name();
  this->SkipSpaces();
  if (this->Text.substr(this->Place, 1) != "=" || tag.Attributes.size() >= MostAttributes)
  {
    this->Reject("an attribute has no value");
  }
  ++this->Place;
  this->SkipSpaces();
  const std::string_view quote = this->Text.substr(this->Place, 1);
  const std::size_t begin = this->Place + 1;
  this->Place = begin;
  if ((quote != "\"" && quote != "'") || !this->SkipTo(quote))
  {
    this->Reject("a value has no quotes");
  }
  tag.Attributes.emplace_back(name, this->Text.substr(begin, this->Place - 1 - begin));
}

/// Reads a tag behind its '<'.
void XmlTags::ReadTag(XmlTag& tag)
{
  tag.Attributes.clear();
  tag.IsEnd = this->Text.substr(this->Place, 1) == "/";
  this->Place += tag.IsEnd;
  tag.Name = this->Name();
  for (this->SkipSpaces();
       IsOfName(this->Place < this->Text.size() ? this->Text[this->Place] : '>');
       this->SkipSpaces())
  {
    this->ReadAttribute(tag);
  }
  this->IsEmpty = !tag.IsEnd && this->Text.substr(this->Place, 1) == "/";
  this->Place += this->IsEmpty;
  if (this->Text.substr(this->Place, 1) != ">")
  {
    this->Reject("a tag does not end");
  }
  ++this->Place;
  if (tag.IsEnd)
  {
    this->Close(tag.Name);
    return;
  }
  this->Open.push_back(tag.Name);
  if (this->Open.size() > Deepest)
  {
    this->Reject("its elements are nested too deeply");
  }
}

bool XmlTags::Next(XmlTag& tag)
{
  if (this->IsEmpty) // the end of the same element
  {
    this->IsEmpty = false;
    tag.IsEnd = true;
    this->Close(tag.Name);
    return true;
  }
  while (this->SkipTo("<"))
  {
    const std::string_view rest = this->Text.substr(this->Place, 8);
    const char* end = rest.substr(0, 1) == "?" ? "?>"
      : rest.substr(0, 3) == "!--"             ? "-->"
      : rest.substr(0, 8) == "![CDATA["        ? "]]>"
                                               : "";
    if (*end != '\0')
    {
      if (!this->SkipTo(end))
      {
        this->Reject("a comment does not end");
      }
      continue;
    }
    if (rest.substr(0, 1) == "!")
    {
      this->Reject("it has a document type definition");
    }
    tag.Place = this->Place - 1;
    this->ReadTag(tag);
    return true;
  }
  if (!this->Open.empty())
  {
    this->Reject("an element does not end");
  }
  return false;
}

} // namespace vfm
