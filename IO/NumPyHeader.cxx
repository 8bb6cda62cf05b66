#include "NumPyHeader.h"

#include "Base/Runtime.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>

namespace vfm
{
namespace
{

constexpr char Magic[] = "\x93NUMPY";
constexpr std::size_t MagicSize = 6, LongestHeader = 1 << 20;

[[noreturn]] void RejectHeader(const std::string& text)
{
  throw InputError("its NumPy header has no " + text + ".");
}

/// Returns the text after a key of the header, which is a Python dictionary of constants.
std::string FindValue(const std::string& header, const std::string& key)
{
  std::size_t place = std::min(header.find("'" + key + "'"), header.find("\"" + key + "\""));
  place = place == std::string::npos ? place : header.find(':', place);
  place = place == std::string::npos ? place : header.find_first_not_of(" ", place + 1);
  if (place == std::string::npos)
  {
    RejectHeader("'" + key + "'");
  }
  return header.substr(place);
}

/// Returns the quoted text at the beginning; empty for a list of fields.
std::string ParseType(const std::string& value)
{
  const std::size_t end = value.find(value[0], 1);
  const bool isQuoted = (value[0] == '\'' || value[0] == '"') && end != std::string::npos;
  return isQuoted ? value.substr(1, end - 1) : "";
}

bool ParseOrder(const std::string& value)
{
  const std::string word = value.substr(0, value.find_first_of(" ,}"));
  if (word != "True" && word != "False")
  {
    RejectHeader("'fortran_order' of True or False");
  }
  return word == "True";
}

std::vector<Index> ParseShape(const std::string& value)
{
  std::vector<Index> shape;
  const std::size_t end = value.find(')');
  if (value[0] != '(' || end == std::string::npos)
  {
    RejectHeader("shape");
  }
  for (const char *next = value.data() + 1, *last = value.data() + end; next < last;)
  {
    if (*next == ' ' || *next == ',' || *next == 'L') // L: Python 2
    {
      ++next;
      continue;
    }
    Index size = 0;
    const auto [stop, error] = std::from_chars(next, last, size);
    if (error != std::errc() || size < 0)
    {
      RejectHeader("shape of integers");
    }
    shape.push_back(size);
    next = stop;
  }
  return shape;
}

void SetType(const std::string& type, NumPyHeader& header)
{
  header.Type = type;
  const std::size_t kind = type.find_first_not_of("<>|=");
  if (kind == std::string::npos)
  {
    return; // Kind stays 0
  }
  header.Kind = type[kind];
  const char *begin = type.data() + kind + 1, *end = type.data() + type.size();
  const auto [stop, error] = std::from_chars(begin, end, header.Size);
  if (kind > 1 ||
    (begin < end && header.Kind != 'M' && header.Kind != 'm' &&
      (error != std::errc() || stop != end)))
  {
    header.Kind = 0;
  }
  header.SwapBytes = type[0] == (IsLittleEndian() ? '>' : '<');
}

/// Reads the length of the header's text, little endian.
std::size_t ReadLength(std::istream& stream, int bytes)
{
  std::size_t length = 0;
  for (int i = 0; i < bytes; ++i)
  {
    length |= static_cast<std::size_t>(static_cast<unsigned char>(stream.get())) << 8 * i;
  }
  return length;
}

} // namespace

NumPyHeader ReadNumPyHeader(const std::string& path)
{
  std::ifstream stream = OpenFile(path);
  char start[MagicSize + 2] = {};
  stream.read(start, sizeof(start));
  if (!stream || std::memcmp(start, Magic, MagicSize) != 0)
  {
    throw InputError("it is not a NumPy file: it does not begin with \\x93NUMPY and a version.");
  }
  const int version = static_cast<unsigned char>(start[MagicSize]);
  if (version < 1 || version > 3)
  {
    throw InputError("it is a NumPy file of version " + std::to_string(version) +
      "; versions 1 to 3 are supported.");
  }
  const std::size_t length = ReadLength(stream, version == 1 ? 2 : 4);
  std::string text(stream && length <= LongestHeader ? length : 0, ' ');
  stream.read(&text[0], static_cast<std::streamsize>(text.size()));
  if (!stream || text.empty())
  {
    throw InputError("its NumPy header is truncated.");
  }
  NumPyHeader header;
  header.Offset = stream.tellg();
  SetType(ParseType(FindValue(text, "descr")), header);
  header.Fortran = ParseOrder(FindValue(text, "fortran_order"));
  header.Shape = ParseShape(FindValue(text, "shape"));
  return header;
}

} // namespace vfm
