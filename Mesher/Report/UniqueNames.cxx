#include "Report/UniqueNames.h"

#include <cstdint>

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

/// Characters of the bytes 0x80 to 0x9f in Windows-1252; 0: none.
constexpr std::uint16_t Windows1252[32] = { 0x20ac, 0, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020,
  0x2021, 0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0, 0x017d, 0, 0, 0x2018, 0x2019, 0x201c, 0x201d,
  0x2022, 0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0, 0x017e, 0x0178 };
constexpr unsigned Ascii = 0x80, AfterWindows = 0xa0; // first characters beyond

/// Appends a character below 0x10000.
void AppendCharacter(std::string& text, unsigned character)
{
  constexpr unsigned bitsPerByte = 6, mask = 0x3f, ofTwo = 0x800;
  if (character < Ascii)
  {
    text += static_cast<char>(character);
    return;
  }
  if (character < ofTwo)
  {
    text += static_cast<char>(0xc0 | character >> bitsPerByte);
  }
  else
  {
    text += static_cast<char>(0xe0 | character >> 2 * bitsPerByte);
    text += static_cast<char>(0x80 | (character >> bitsPerByte & mask));
  }
  text += static_cast<char>(0x80 | (character & mask));
}

/// Returns the number of bytes of the character at the start of a text; 0 if it is not valid.
std::size_t LengthOfCharacter(std::string_view text)
{
  const auto byte = [&text](std::size_t at)
  { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u; };
  const unsigned first = byte(0);
  if (first < Ascii)
  {
    return 1;
  }
  const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2
    : first >= 0xe0 && first < 0xf0                        ? 3
    : first >= 0xf0 && first < 0xf5                        ? 4
                                                           : 0;
  // Longer forms than necessary, surrogates, and numbers above 0x10ffff are not valid.
  const unsigned least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
  const unsigned most = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
  bool isValid = length > 0 && byte(1) >= least && byte(1) <= most;
  for (std::size_t at = 2; at < length; ++at)
  {
    isValid = isValid && (byte(at) & 0xc0) == 0x80;
  }
  return isValid ? length : 0;
}

} // namespace

bool IsUtf8(std::string_view text)
{
  while (!text.empty())
  {
    const std::size_t length = LengthOfCharacter(text);
    if (length == 0)
    {
      return false;
    }
    text.remove_prefix(length);
  }
  return true;
}

std::string ToUtf8(const std::string& text)
{
  if (IsUtf8(text))
  {
    return text;
  }
  std::string converted;
  for (char c : text)
  {
    const unsigned byte = static_cast<unsigned char>(c);
    const unsigned character =
      byte >= Ascii && byte < AfterWindows ? Windows1252[byte - Ascii] : byte;
    if (byte >= Ascii && character == 0)
    {
      converted += UnknownCharacter;
      continue;
    }
    AppendCharacter(converted, character);
  }
  return converted;
}

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
