#include "Summary/UniqueNames.h"

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

std::string PlainName(std::string name)
{
  for (char& c : name)
  {
    const bool isControl = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    c = isControl || c == '"' || c == '\\' ? '_' : c;
  }
  return name;
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
