#include "VtkFiles/LegacyStream.h"

#include "Base/ParseText.h"
#include "OpenFile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <map>
#include <optional>

namespace vfm
{
namespace
{

constexpr int LongestWord = 1024;
constexpr std::size_t LongestLine = 1 << 20;

/// Returns the bytes of a binary value, 0 for bits; nothing for unknown types.
std::optional<int> FindWidth(const std::string& type)
{
  static const std::map<std::string, int> widths{ { "bit", 0 }, { "char", 1 }, { "signed_char", 1 },
    { "unsigned_char", 1 }, { "short", 2 }, { "unsigned_short", 2 }, { "int", 4 },
    { "unsigned_int", 4 }, { "vtkidtype", 4 }, { "long", 8 }, { "unsigned_long", 8 },
    { "vtktypeint64", 8 }, { "vtktypeuint64", 8 }, { "float", 4 }, { "double", 8 } };
  const auto found = widths.find(type);
  return found == widths.end() ? std::nullopt : std::optional<int>(found->second);
}

} // namespace

void RejectLegacyFile(const std::string& problem)
{
  throw InputError("the file is truncated or damaged: " + problem + ".");
}

std::string QuoteWord(std::string word)
{
  word = word.substr(0, 40);
  std::replace_if(
    word.begin(), word.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return "'" + word + "'";
}

LegacyStream::LegacyStream(const std::string& path) :
  Stream(OpenFile(path)), Size(GetFileLength(path))
{
}

std::string LegacyStream::Line()
{
  std::string line;
  for (int c = 0; (c = this->Stream.get()) != std::ifstream::traits_type::eof() && c != '\n';)
  {
    line += static_cast<char>(c);
    if (line.size() > LongestLine)
    {
      RejectLegacyFile("one of its lines is too long");
    }
  }
  return line;
}

std::string LegacyStream::Word()
{
  std::string word;
  this->Stream >> std::setw(LongestWord) >> word;
  return word;
}

std::string LegacyStream::Keyword()
{
  std::string word = this->Word();
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

std::int64_t LegacyStream::Int(std::int64_t least, std::int64_t most, const std::string& what)
{
  const std::string word = this->Word();
  std::int64_t number = 0;
  const char* end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, number);
  if (parsed.ec != std::errc() || parsed.ptr != end || number < least || number > most)
  {
    RejectLegacyFile("its " + what + " is " + QuoteWord(word));
  }
  return number;
}

void LegacyStream::SkipBytes(std::int64_t count, const std::string& name)
{
  this->Line(); // the end of the line with the type
  const std::int64_t place = this->Stream.tellg();
  if (!this->Stream || count > this->Size - place)
  {
    RejectLegacyFile(
      "its " + name + " needs " + std::to_string(count) + " bytes, but the file ends");
  }
  this->Stream.seekg(count, std::ios::cur);
}

/// Skips texts. A binary text has its length in front, in 1, 2, 4 or 8 bytes.
void LegacyStream::SkipStrings(std::int64_t count, const std::string& name)
{
  this->Line();
  for (std::int64_t s = 0; s < count; ++s)
  {
    if (!this->IsBinary)
    {
      this->Line();
    }
    else
    {
      const int first = this->Stream.get();
      std::int64_t length = first & 63;
      for (int more = (1 << (3 - ((first >> 6) & 3))) - 1; more > 0; --more)
      {
        length = length << 8 | (this->Stream.get() & 255);
      }
      const std::int64_t place = this->Stream.tellg();
      if (!this->Stream || length > this->Size - place)
      {
        RejectLegacyFile("its " + name + " holds a text that does not end");
      }
      this->Stream.seekg(length, std::ios::cur);
    }
    if (!this->Stream)
    {
      RejectLegacyFile("its " + name + " ends after " + std::to_string(s) + " values");
    }
  }
}

void LegacyStream::SkipValues(const std::string& type, std::int64_t count, const std::string& name)
{
  if (count > MostLegacyValues)
  {
    RejectLegacyFile("its " + name + " has too many values");
  }
  if (type == "string" || type == "utf8_string")
  {
    this->SkipStrings(count, name);
    return;
  }
  const auto width = FindWidth(type);
  if (!width)
  {
    RejectLegacyFile("its " + name + " has the unknown type " + QuoteWord(type));
  }
  if (this->IsBinary)
  {
    this->SkipBytes(*width == 0 ? (count + 7) / 8 : count * *width, name);
    return;
  }
  for (std::int64_t v = 0; v < count; ++v)
  {
    const std::string word = this->Word();
    char* end = nullptr;
    std::strtod(word.c_str(), &end);
    if (word.empty() || end != word.c_str() + word.size())
    {
      RejectLegacyFile("its " + name + " holds " + std::to_string(v) + " of " +
        std::to_string(count) + " numbers, then " + QuoteWord(word));
    }
  }
}

void LegacyStream::ReadInts(
  std::int64_t count, const std::string& name, const std::function<void(std::int64_t)>& visit)
{
  if (!this->IsBinary)
  {
    for (std::int64_t v = 0; v < count; ++v)
    {
      visit(this->Int(
        std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max(), name));
    }
    return;
  }
  const std::int64_t begin = this->Stream.tellg();
  this->SkipBytes(4 * count, name);
  const std::int64_t end = this->Stream.tellg();
  this->Stream.seekg(begin);
  this->Line();
  std::array<char, 4> bytes{};
  for (std::int64_t v = 0; v < count && this->Stream.read(bytes.data(), 4); ++v)
  {
    std::uint32_t bits = 0;
    for (char byte : bytes)
    {
      bits = bits << 8 | static_cast<unsigned char>(byte);
    }
    visit(static_cast<std::int32_t>(bits));
  }
  this->Stream.seekg(end);
}

void LegacyStream::SkipDescription()
{
  this->Line();
  while (!TrimText(this->Line()).empty())
  {
  }
}

void LegacyStream::SkipMetadata()
{
  const auto place = this->Stream.tellg();
  if (this->Keyword() == "metadata")
  {
    this->SkipDescription();
    return;
  }
  this->Stream.clear();
  this->Stream.seekg(place);
}

} // namespace vfm
