#include "Images/ImageFile.h"
#include "Images/StoredValues.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace vfm
{
namespace
{

constexpr std::size_t LongestLine = 100000;

/// Fields of the header and its length.
struct MetaHeader
{
  std::map<std::string, std::string> Fields;
  Index Length = 0; ///< bytes up to the end of the line ElementDataFile

  /// Returns the value of the first field that exists, or `without` if there is none.
  std::string Find(std::initializer_list<const char*> names, const std::string& without) const
  {
    for (const char* name : names)
    {
      const auto found = this->Fields.find(name);
      if (found != this->Fields.end())
      {
        return found->second;
      }
    }
    return without;
  }
  bool IsTrue(std::initializer_list<const char*> names) const
  {
    const std::string value = this->Find(names, "False");
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }
  /// Returns `count` numbers of the first field that exists, or `without` for each if none exists.
  std::vector<double> Numbers(
    std::initializer_list<const char*> names, std::size_t count, double without) const
  {
    const std::string text = this->Find(names, "");
    std::istringstream stream(text);
    std::vector<double> numbers(count, without);
    for (std::size_t i = 0; i < count && !text.empty(); ++i)
    {
      if (!(stream >> numbers[i]))
      {
        throw InputError(std::string("its header says '") + *names.begin() + " = " +
          text.substr(0, 80) + "', where " + std::to_string(count) + " numbers are required.");
      }
    }
    return numbers;
  }
};

std::string Trim(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos
    ? ""
    : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

MetaHeader ReadHeader(std::ifstream& stream)
{
  MetaHeader header;
  std::string line;
  while (std::getline(stream, line) && line.size() < LongestLine)
  {
    const std::size_t equals = line.find('=');
    const bool isText = std::none_of(line.begin(), line.end(),
      [](unsigned char c) { return std::iscntrl(c) != 0 && c != '\t' && c != '\r'; });
    if (equals == std::string::npos || !isText)
    {
      break;
    }
    const std::string name = Trim(line.substr(0, equals));
    header.Fields[name] = Trim(line.substr(equals + 1));
    if (name == "ElementDataFile")
    {
      header.Length = stream ? static_cast<Index>(stream.tellg()) : 0;
      return header;
    }
  }
  throw InputError(
    "it is not a MetaImage file: its header is not a list of NAME = VALUE that ends with "
    "ElementDataFile.");
}

int FindType(const std::string& name)
{
  static const std::map<std::string, int> types{ { "MET_CHAR", ValueType::SignedChar },
    { "MET_UCHAR", ValueType::UnsignedChar }, { "MET_SHORT", ValueType::Short },
    { "MET_USHORT", ValueType::UnsignedShort }, { "MET_INT", ValueType::Int },
    { "MET_UINT", ValueType::UnsignedInt }, { "MET_LONG", ValueType::Int },
    { "MET_ULONG", ValueType::UnsignedInt }, { "MET_LONG_LONG", ValueType::LongLong },
    { "MET_ULONG_LONG", ValueType::UnsignedLongLong }, { "MET_FLOAT", ValueType::Float },
    { "MET_DOUBLE", ValueType::Double } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    throw InputError("its values are of type '" + name.substr(0, 80) +
      "'. Supported types: MET_CHAR to MET_ULONG_LONG, MET_FLOAT and MET_DOUBLE.");
  }
  return found->second;
}

ImagePlace FindPlace(const MetaHeader& header)
{
  const double dimensions = header.Numbers({ "NDims" }, 1, 0.0)[0];
  if (!(dimensions >= 1.0 && dimensions <= 3.0))
  {
    throw InputError("its image has " + header.Find({ "NDims" }, "no").substr(0, 20) +
      " dimensions; three are required.");
  }
  const std::size_t n = static_cast<std::size_t>(dimensions);
  const std::vector<double> sizes = header.Numbers({ "DimSize" }, n, 0.0),
                            spacing = header.Numbers({ "ElementSpacing", "ElementSize" }, n, 1.0),
                            origin = header.Numbers({ "Offset", "Position", "Origin" }, n, 0.0);
  const bool isTurned = !header.Find({ "TransformMatrix", "Rotation", "Orientation" }, "").empty();
  const std::vector<double> matrix =
    header.Numbers({ "TransformMatrix", "Rotation", "Orientation" }, n * n, 0.0);
  ImagePlace place;
  place.Size = { { 1, 1, 1 } };
  std::array<Vector3, 3> steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
  for (std::size_t a = 0; a < n; ++a)
  {
    place.Size[a] = ToSize(sizes[a]);
    place.Origin[a] = origin[a];
    for (std::size_t c = 0; c < n; ++c)
    {
      steps[a][c] = (isTurned ? matrix[a * n + c] : steps[a][c]) * std::abs(spacing[a]);
    }
    place.Spacing[a] = std::abs(spacing[a]);
  }
  CheckPlace(place);
  if (!AreAtRightAngles(steps))
  {
    throw InputError("its TransformMatrix is not a rotation: the axes are not at right angles.");
  }
  SetSteps(steps, place);
  return place;
}

/// Returns the files with the values, relative to the folder of the header. They are one file, a
/// list after the header with one file per slice, or a pattern with first, last and step. The
/// result is empty if the values follow the header.
std::vector<std::string> FindFiles(const MetaHeader& header, std::istream& stream, Index slices)
{
  const std::string name = header.Find({ "ElementDataFile" }, "");
  std::istringstream words(name);
  std::string pattern;
  double first = 0.0, last = 0.0, step = 1.0;
  std::vector<std::string> files;
  if (name == "LOCAL" || name == "Local" || name == "local")
  {
    return files;
  }
  if (name.compare(0, 4, "LIST") == 0)
  {
    for (std::string line; static_cast<Index>(files.size()) < slices && std::getline(stream, line);)
    {
      files.push_back(Trim(line));
    }
    return files;
  }
  if (name.find('%') != std::string::npos && words >> pattern >> first >> last)
  {
    words >> step;
    return ListNumberedFiles(pattern, first, last, step, slices);
  }
  return { name };
}

/// Reads values that are stored as text.
TypedValues ReadText(const StoredValues& stored, Index count)
{
  TypedValues values = MakeValues("", stored.Type, count);
  std::ifstream stream = OpenFile(stored.Files[0]);
  stream.seekg(stored.Begin);
  VisitType(stored.Type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      for (Index i = 0; i < count; ++i)
      {
        double number = 0.0;
        if (!(stream >> number))
        {
          throw InputError("its values are truncated, or not numbers.");
        }
        reinterpret_cast<Value*>(values.Bytes.data())[i] = static_cast<Value>(number);
      }
    });
  return values;
}

} // namespace

ImageFile OpenMetaImage(const std::string& path, const ImageRequest&)
{
  std::ifstream stream = OpenFile(path);
  const MetaHeader header = ReadHeader(stream);
  ImageFile image;
  image.Place = FindPlace(header);
  const Index3 size = image.Place.Size;
  const double values = header.Numbers({ "ElementNumberOfChannels" }, 1, 1.0)[0];
  if (values != 1.0)
  {
    throw InputError("it has " + std::to_string(static_cast<int>(values)) +
      " values per point (a vector or a colour); one is required, a label or a volume fraction.");
  }
  StoredValues stored;
  stored.Type = FindType(header.Find({ "ElementType" }, ""));
  stored.AreCompressed = header.IsTrue({ "CompressedData" });
  stored.AreSwapped = WidthOfType(stored.Type) > 1 &&
    header.IsTrue({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" }) == IsLittleEndian();
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& file : FindFiles(header, stream, size[2]))
  {
    stored.Files.push_back((folder / file).string());
  }
  if (stored.Files.empty())
  {
    stored.Files = { path };
    stored.Begin = header.Length;
  }
  const double skip = header.Numbers({ "HeaderSize" }, 1, 0.0)[0];
  const bool isBinary = header.IsTrue({ "BinaryData" });
  if (skip == -1.0 && stored.Files.size() == 1) // the values are at the end of the file
  {
    const double length = static_cast<double>(std::filesystem::file_size(stored.Files[0]));
    stored.Begin = ToSize(length - stored.CountBytes(size));
  }
  else
  {
    stored.Begin += ToSize(skip);
  }
  if (isBinary)
  {
    CheckFiles(stored, size);
  }
  else
  {
    CheckLength(stored.Files[0], static_cast<double>(stored.Begin),
      2.0 * stored.CountBytes(size) / double(WidthOfType(stored.Type)) - 1.0, false);
  }
  image.ReadsParts = isBinary && !stored.AreCompressed;
  image.Read = [stored, size, isBinary](const IndexBox& box)
  {
    return isBinary ? ReadStored(stored, size, box)
                    : ReadText(stored, box.NumberOfCells()); // box of the whole image
  };
  return image;
}

} // namespace vfm
