#include "Summary/UniqueNames.h"

#include "Summary/Utf8.h"

namespace vfm
{
namespace
{

/// Returns whether a byte of UTF-8 continues a character.
bool IsContinuation(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

std::string CutText(const std::string& text, std::size_t length)
{
  if (text.size() <= length)
  {
    return text;
  }
  while (length > 0 && IsContinuation(text[length]))
  {
    --length;
  }
  return text.substr(0, length);
}

} // namespace

std::string PrintableName(const std::string& name)
{
  std::string printable = ToUtf8(name);
  for (char& c : printable)
  {
    const bool isControl = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    c = isControl ? '_' : c;
  }
  return printable;
}

std::string PlainName(const std::string& name)
{
  std::string plain = PrintableName(name);
  for (char& c : plain)
  {
    c = c == '"' || c == '\\' ? '_' : c;
  }
  return plain;
}

std::string UniqueNames::Add(const std::string& name)
{
  std::string unique = CutText(name, this->Longest);
  for (int count = 2; !this->Used.insert(unique).second; ++count)
  {
    const std::string end = "_" + std::to_string(count);
    unique = CutText(name, this->Longest - end.size()) + end;
  }
  return unique;
}

} // namespace vfm
