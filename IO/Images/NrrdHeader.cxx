#include "Images/NrrdHeader.h"

#include "Images/HeaderNumbers.h"
#include "Images/StoredValues.h"
#include "SwapBytes.h"

#include <algorithm>
#include <map>
#include <optional>

namespace vfm
{
namespace
{

/// Returns the position of the axis of layers among four axes; nothing if there is none.
std::optional<std::size_t> FindLayers(const NrrdFields& fields)
{
  const std::vector<std::string> kinds = SplitWords(fields.Find("kinds", ""));
  for (const std::size_t axis : { 0, 3 })
  {
    if (kinds.size() == 4 && (kinds[axis] == "list" || kinds[axis] == "time"))
    {
      return axis;
    }
  }
  return std::nullopt;
}

/// Returns the field of a value per axis, without the axis of layers and without signs between
/// numbers.
std::string DropLayers(
  const NrrdFields& fields, const std::string& name, std::optional<std::size_t> layers)
{
  std::string text = fields.Find(name, "");
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::vector<std::string> words = SplitWords(text);
  const std::size_t each = name == "space directions" ? 3 : 1;
  if (layers && words.size() == 3 * each + 1)
  {
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(*layers * each));
  }
  std::string kept;
  for (const std::string& word : words)
  {
    kept += (kept.empty() ? "" : " ") + word;
  }
  return kept;
}

void ReadSteps(const NrrdFields& fields, std::optional<std::size_t> layers, NrrdHeader& header)
{
  if (fields.Has("space directions"))
  {
    const std::string name = "space directions";
    const std::vector<double> all = ParseReals(name, DropLayers(fields, name, layers), 9);
    for (std::size_t i = 0; i < 9; ++i)
    {
      header.Steps[i / 3][i % 3] = all[i];
    }
  }
  else if (fields.Has("spacings"))
  {
    const std::vector<double> all =
      ParseReals("spacings", DropLayers(fields, "spacings", layers), 3);
    for (std::size_t a = 0; a < 3; ++a)
    {
      header.Steps[a][a] = all[a];
    }
  }
  if (fields.Has("space origin"))
  {
    const std::string name = "space origin";
    const std::vector<double> origin = ParseReals(name, DropLayers(fields, name, {}), 3);
    std::copy_n(origin.begin(), 3, header.Origin.begin());
  }
}

int FindType(const std::string& name)
{
  static const std::map<std::string, int> types{ { "signed char", ValueType::SignedChar },
    { "int8", ValueType::SignedChar }, { "int8_t", ValueType::SignedChar },
    { "uchar", ValueType::UnsignedChar }, { "unsigned char", ValueType::UnsignedChar },
    { "uint8", ValueType::UnsignedChar }, { "uint8_t", ValueType::UnsignedChar },
    { "short", ValueType::Short }, { "short int", ValueType::Short },
    { "signed short", ValueType::Short }, { "signed short int", ValueType::Short },
    { "int16", ValueType::Short }, { "int16_t", ValueType::Short },
    { "ushort", ValueType::UnsignedShort }, { "unsigned short", ValueType::UnsignedShort },
    { "unsigned short int", ValueType::UnsignedShort }, { "uint16", ValueType::UnsignedShort },
    { "uint16_t", ValueType::UnsignedShort }, { "int", ValueType::Int },
    { "signed int", ValueType::Int }, { "int32", ValueType::Int }, { "int32_t", ValueType::Int },
    { "uint", ValueType::UnsignedInt }, { "unsigned int", ValueType::UnsignedInt },
    { "uint32", ValueType::UnsignedInt }, { "uint32_t", ValueType::UnsignedInt },
    { "longlong", ValueType::LongLong }, { "long long", ValueType::LongLong },
    { "long long int", ValueType::LongLong }, { "signed long long", ValueType::LongLong },
    { "signed long long int", ValueType::LongLong }, { "int64", ValueType::LongLong },
    { "int64_t", ValueType::LongLong }, { "ulonglong", ValueType::UnsignedLongLong },
    { "unsigned long long", ValueType::UnsignedLongLong },
    { "unsigned long long int", ValueType::UnsignedLongLong },
    { "uint64", ValueType::UnsignedLongLong }, { "uint64_t", ValueType::UnsignedLongLong },
    { "float", ValueType::Float }, { "double", ValueType::Double } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    throw InputError("its values are of type '" + name.substr(0, 80) +
      "'. Supported types: integers of 1 to 8 bytes, floating point of 4 or 8 bytes.");
  }
  return found->second;
}

/// Returns whether a byte order, "little" or "big", differs from that of this machine.
bool IsSwapped(const std::string& order)
{
  if (order != "little" && order != "big")
  {
    throw InputError("its endian is '" + order.substr(0, 80) + "'; it must be little or big.");
  }
  return (order == "little") != IsLittleEndian();
}

/// Returns the number of bytes of the data before the first value; -1: the values are at the end.
Index FindSkip(const NrrdFields& fields, bool isRaw)
{
  if (ParseIntegers("line skip", fields.Find("line skip", "0"), 1)[0] != 0)
  {
    throw InputError("its header has a line skip, which is not supported.");
  }
  const Index skip = ParseIntegers("byte skip", fields.Find("byte skip", "0"), 1)[0];
  if (skip < (isRaw ? -1 : 0))
  {
    throw InputError("its byte skip is " + std::to_string(skip) +
      "; it must be a number of bytes from 0, or -1 for raw values at the end of the file.");
  }
  return skip;
}

/// Returns the files with the values: a list, a pattern with first, last and step, or one file.
/// @param most  largest number of files
/// @param dimension  number of dimensions of the values in each of several files
std::vector<std::string> FindFiles(const NrrdFields& fields, Index most, Index dimension)
{
  const std::string name = fields.Find("data file", "");
  const std::vector<std::string> words = SplitWords(name);
  const bool isList = !words.empty() && words[0] == "LIST";
  const bool isPattern = words.size() >= 4 && words[0].find('%') != std::string::npos;
  const std::size_t usual = isList ? 1 : isPattern ? 4 : words.size();
  if (words.size() > usual && (words.size() > usual + 1 || ParseInteger(words[usual]) != dimension))
  {
    throw InputError("its header says 'data file: " + name.substr(0, 80) + "', where files of " +
      std::to_string(dimension) + " dimensions are supported.");
  }
  if (isList)
  {
    if (fields.List.empty())
    {
      throw InputError("its list of data files is empty.");
    }
    return fields.List;
  }
  if (isPattern)
  {
    const std::vector<Index> range =
      ParseIntegers("data file", words[1] + " " + words[2] + " " + words[3], 3);
    return ListNumberedFiles(words[0], range[0], range[1], range[2], most);
  }
  return name.empty() ? std::vector<std::string>() : std::vector<std::string>{ name };
}

/// Reads the number of values along each axis.
/// @return position of the axis of layers, if any
std::optional<std::size_t> ReadSizes(const NrrdFields& fields, NrrdHeader& header)
{
  const Index dimension = ParseIntegers("dimension", fields.Find("dimension", ""), 1)[0];
  const std::optional<std::size_t> layers =
    dimension == 4 ? FindLayers(fields) : std::optional<std::size_t>();
  if (dimension != 3 && !layers)
  {
    throw InputError("its image has " + std::to_string(dimension) +
      " dimensions; three are required, with one value per point.");
  }
  std::vector<Index> sizes = ParseIntegers("sizes", fields.Find("sizes", ""), layers ? 4 : 3);
  if (layers)
  {
    header.Layers = sizes[*layers];
    header.HasLayersFirst = *layers == 0;
    sizes.erase(sizes.begin() + static_cast<std::ptrdiff_t>(*layers));
    constexpr Index most = 10000;
    if (header.Layers < 1 || header.Layers > most)
    {
      throw InputError("it has " + std::to_string(header.Layers) + " layers; 1 to " +
        std::to_string(most) + " are supported.");
    }
  }
  std::copy_n(sizes.begin(), 3, header.Size.begin());
  return layers;
}

} // namespace

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  NrrdHeader header;
  header.Fields = ReadNrrdFields(path);
  const NrrdFields& fields = header.Fields;
  const std::optional<std::size_t> layers = ReadSizes(fields, header);
  ReadSteps(fields, layers, header);
  const std::string coded = fields.Find("encoding", "");
  header.IsRaw = coded == "raw";
  if (!header.IsRaw && coded != "gzip" && coded != "gz")
  {
    throw InputError(
      "its encoding is '" + coded.substr(0, 80) + "'. Supported encodings: raw and gzip.");
  }
  header.Type = FindType(fields.Find("type", ""));
  header.IsSwapped = WidthOfType(header.Type) > 1 && IsSwapped(fields.Find("endian", ""));
  header.Skip = FindSkip(fields, header.IsRaw);
  header.Files = FindFiles(fields, header.StoredSize()[2], layers ? 3 : 2);
  return header;
}

} // namespace vfm
