#include "Ranks/PrintableText.h"

#include <cstdint>

namespace vfm
{
namespace
{

/// Character of a text in UTF-8; Length is 0 if the bytes are not UTF-8.
struct Character
{
  std::uint32_t Code = 0;
  std::size_t Length = 0;
};

Character DecodeCharacter(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80)
  {
    return { first, 1 };
  }
  const std::size_t length = first < 0xc2 ? 0
    : first < 0xe0                        ? 2
    : first < 0xf0                        ? 3
    : first < 0xf5                        ? 4
                                          : 0;
  if (length == 0 || at + length > text.size())
  {
    return {};
  }
  std::uint32_t code = first & (0xffU >> (length + 1));
  for (std::size_t i = at + 1; i < at + length; ++i)
  {
    if ((byte(i) & 0xc0) != 0x80)
    {
      return {};
    }
    code = code << 6 | (byte(i) & 0x3fU);
  }
  constexpr std::uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
  const bool isValid =
    code >= least[length] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
  return isValid ? Character{ code, length } : Character{};
}

bool IsPrintable(std::uint32_t code)
{
  const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool isDirection = code == 0x61c || code == 0x200e || code == 0x200f ||
    (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !isControl && !isDirection;
}

} // namespace

std::string MakePrintable(const std::string& text)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string printable;
  for (std::size_t at = 0; at < text.size();)
  {
    const Character character = DecodeCharacter(text, at);
    if (text[at] == '\n' || text[at] == '\r' || text[at] == '\t')
    {
      printable += ' ';
      ++at;
      continue;
    }
    if (character.Length > 0 && IsPrintable(character.Code))
    {
      printable += text.substr(at, character.Length);
      at += character.Length;
      continue;
    }
    const std::size_t end = at + (character.Length > 0 ? character.Length : 1);
    for (; at < end; ++at)
    {
      const auto byte = static_cast<unsigned char>(text[at]);
      printable += std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
    }
  }
  return printable;
}

} // namespace vfm
