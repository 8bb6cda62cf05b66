#include "GridFiles/LegacyStream.h"

#include "Base/ParseText.h"
#include "OpenFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iomanip>
#include <map>
#include <optional>

namespace vfm
{
namespace
{

constexpr int LongestWord = 1024;
constexpr std::size_t LongestLine = 1 << 20;

std::optional<VtkType> FindType(const std::string& name)
{
  static const VtkType byte{ VtkType::Unsigned, 1 }, letter{ VtkType::Signed, 1 },
    small{ VtkType::Signed, 2 }, integer{ VtkType::Signed, 4 }, large{ VtkType::Signed, 8 };
  static const std::map<std::string, VtkType> types{ { "bit", { VtkType::Bit, 1 } },
    { "char", letter }, { "signed_char", letter }, { "unsigned_char", byte }, { "short", small },
    { "unsigned_short", { VtkType::Unsigned, 2 } }, { "int", integer },
    { "unsigned_int", { VtkType::Unsigned, 4 } }, { "vtkidtype", integer }, { "long", large },
    { "unsigned_long", { VtkType::Unsigned, 8 } }, { "long_long", large },
    { "vtktypeint64", large }, { "unsigned_long_long", { VtkType::Unsigned, 8 } },
    { "vtktypeuint64", { VtkType::Unsigned, 8 } }, { "float", { VtkType::Real, 4, true } },
    { "double", { VtkType::Real, 8, true } } };
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional<VtkType>(found->second);
}

} // namespace

void RejectLegacyFile(const std::string& problem)
{
  throw InputError("the file is truncated or damaged: " + problem + ".");
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
  return ToLower(this->Word());
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

void LegacyStream::Numbers(const std::string& what)
{
  const VtkType type{ VtkType::Real, 8, true };
  for (int a = 0; a < 3; ++a)
  {
    const std::string word = this->Word();
    if (!ParseVtkNumber(word, type))
    {
      RejectLegacyFile("its " + what + " is " + QuoteWord(word) + ", three numbers are required");
    }
  }
}

void LegacyStream::ReadBytes(
  const VtkType& type, std::int64_t count, const std::string& name, const VisitVtkValue& visit)
{
  this->Line(); // the end of the line with the type
  const std::int64_t place = this->Stream.tellg();
  const std::int64_t bytes = type.Kind == VtkType::Bit ? (count + 7) / 8 : count * type.Bytes;
  if (!this->Stream || bytes > this->Size - place)
  {
    RejectLegacyFile(
      "its " + name + " needs " + std::to_string(bytes) + " bytes, but the file ends");
  }
  std::array<char, 8> value{};
  for (std::int64_t v = 0; visit && v < count && this->Stream.read(value.data(), type.Bytes); ++v)
  {
    visit(DecodeVtkNumber(reinterpret_cast<unsigned char*>(value.data()), type, true));
  }
  this->Stream.seekg(place + bytes);
}

void LegacyStream::ReadWords(
  const VtkType& type, std::int64_t count, const std::string& name, const VisitVtkValue& visit)
{
  for (std::int64_t v = 0; v < count; ++v)
  {
    const std::string word = this->Word();
    if (word.empty())
    {
      RejectLegacyFile("its " + name + " holds " + std::to_string(v) + " of " +
        std::to_string(count) + " values, then the file ends");
    }
    const auto value = ParseVtkNumber(word, type);
    if (!value)
    {
      PrefixErrors("the file is truncated or damaged: its " + name + " ",
        [&] { RejectVtkNumber(v + 1, word, type); });
    }
    if (visit)
    {
      visit(*value);
    }
  }
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

void LegacyStream::ReadValues(
  const std::string& type, std::int64_t count, const std::string& name, const VisitVtkValue& visit)
{
  this->Last = name;
  if (count > MostLegacyValues)
  {
    RejectLegacyFile("its " + name + " has too many values");
  }
  if (type == "string" || type == "utf8_string")
  {
    this->SkipStrings(count, name);
    return;
  }
  const auto found = FindType(type);
  if (!found)
  {
    RejectLegacyFile("its " + name + " has the unknown type " + QuoteWord(type));
  }
  this->IsBinary ? this->ReadBytes(*found, count, name, visit)
                 : this->ReadWords(*found, count, name, visit);
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
