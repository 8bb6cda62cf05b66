#include "Base/ParseText.h"
#include "Images/HeaderNumbers.h"
#include "Images/ImageFile.h"
#include "Images/ReadNumbers.h"
#include "Images/StoredValues.h"
#include "OpenFile.h"
#include "ReadLine.h"
#include "SwapBytes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace vfm
{
namespace
{

constexpr int MostLines = 10000; // lines of a header

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
  /// Returns the switch of the first field that exists, or false if none exists.
  bool IsTrue(std::initializer_list<const char*> names) const
  {
    const std::string value = this->Find(names, "False");
    const char first = value.empty() ? ' ' : value[0];
    if (std::string("TtFf01").find(first) == std::string::npos)
    {
      throw InputError(std::string("its header says '") + *names.begin() + " = " +
        value.substr(0, 80) + "', where True or False is required.");
    }
    return first == 'T' || first == 't' || first == '1';
  }
  /// Returns `count` numbers of the first field that exists, or `without` for each if none exists.
  std::vector<double> Numbers(
    std::initializer_list<const char*> names, std::size_t count, double without) const
  {
    const std::string text = this->Find(names, "");
    return text.empty() ? std::vector<double>(count, without)
                        : ParseReals(*names.begin(), text, count);
  }
  std::vector<Index> Integers(const char* name, std::size_t count, Index without) const
  {
    const std::string text = this->Find({ name }, "");
    return text.empty() ? std::vector<Index>(count, without) : ParseIntegers(name, text, count);
  }
};

MetaHeader ReadHeader(std::ifstream& stream)
{
  MetaHeader header;
  std::string line;
  for (int lines = 0; lines < MostLines && ReadLine(stream, line); ++lines)
  {
    const std::size_t equals = line.find('=');
    const bool isText = std::none_of(line.begin(), line.end(),
      [](unsigned char c) { return std::iscntrl(c) != 0 && c != '\t' && c != '\r'; });
    if (equals == std::string::npos || !isText)
    {
      break;
    }
    const std::string name = TrimText(line.substr(0, equals));
    header.Fields[name] = TrimText(line.substr(equals + 1));
    if (name == "ElementDataFile")
    {
      header.Length = stream.eof() ? 0 : static_cast<Index>(stream.tellg());
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
  const Index dimensions = header.Integers("NDims", 1, 0)[0];
  if (dimensions < 1 || dimensions > 3)
  {
    throw InputError("its image has " + header.Find({ "NDims" }, "no").substr(0, 20) +
      " dimensions; three are required.");
  }
  const std::size_t n = static_cast<std::size_t>(dimensions);
  const std::vector<Index> sizes = header.Integers("DimSize", n, 0);
  const std::vector<double> spacing = header.Numbers({ "ElementSpacing", "ElementSize" }, n, 1.0),
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
    place.Size[a] = sizes[a];
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
  const std::vector<std::string> words = SplitWords(name);
  if (name == "LOCAL" || name == "Local" || name == "local")
  {
    return {};
  }
  if (name.empty())
  {
    throw InputError("its ElementDataFile is empty.");
  }
  if (words[0] == "LIST")
  {
    if (words.size() > 1 && name != "LIST 2" && name != "LIST 2D")
    {
      throw InputError("its ElementDataFile is '" + name.substr(0, 80) +
        "'. Supported lists: LIST, with one file per slice.");
    }
    std::vector<std::string> files;
    for (std::string line; static_cast<Index>(files.size()) < slices && ReadLine(stream, line);)
    {
      files.push_back(TrimText(line));
    }
    return files;
  }
  const bool isPattern = words.size() > 2 && words[0].find('%') != std::string::npos;
  if (!isPattern)
  {
    return { name };
  }
  const std::string numbers = name.substr(name.find(words[0]) + words[0].size());
  std::vector<Index> range =
    ParseIntegers("ElementDataFile = " + words[0], numbers, words.size() - 1);
  range.resize(std::max<std::size_t>(range.size(), 3), 1);
  return ListNumberedFiles(words[0], range[0], range[1], range[2], slices);
}

/// Sets the place of the values according to HeaderSize, which counts from the begin of the file,
/// as in MetaIO. -1: the values are at the end of the file.
void SkipHeader(const MetaHeader& header, const Index3& size, StoredValues& stored)
{
  const Index skip = header.Integers("HeaderSize", 1, 0)[0];
  if (skip < -1 || (skip > 0 && skip < stored.Begin))
  {
    throw InputError("its HeaderSize is " + std::to_string(skip) +
      "; it must be -1, or the number of bytes before the values" +
      (skip < 0 ? "." : ", but the header has " + std::to_string(stored.Begin) + " bytes."));
  }
  if (skip == -1)
  {
    PlaceAtEnd(size, stored);
  }
  stored.Begin = std::max(stored.Begin, skip);
}

/// Checks the files of the values.
void CheckValues(const StoredValues& stored, const Index3& size, bool isBinary)
{
  if (isBinary)
  {
    CheckFiles(stored, size);
    return;
  }
  if (stored.Files.size() != 1 || stored.AreCompressed)
  {
    throw InputError("values in text form require one file without compression.");
  }
  // Each value takes a digit and a space, except the last, which needs no space.
  CheckLength(stored.Files[0], stored.Begin, 2 * CountCells(size) - 1, false);
}

} // namespace

ImageFile OpenMetaImage(const std::string& path, const ImageRequest&)
{
  std::ifstream stream = OpenFile(path);
  const MetaHeader header = ReadHeader(stream);
  ImageFile image;
  image.Place = FindPlace(header);
  const Index3 size = image.Place.Size;
  const std::string kind = header.Find({ "ObjectType" }, "Image");
  if (kind != "Image")
  {
    throw InputError("its ObjectType is '" + kind.substr(0, 80) + "'; Image is required.");
  }
  const Index values = header.Integers("ElementNumberOfChannels", 1, 1)[0];
  if (values != 1)
  {
    throw InputError("it has " + std::to_string(values) +
      " values per point (a vector or a colour); one is required, a label or a volume fraction.");
  }
  StoredValues stored;
  stored.Type = FindType(header.Find({ "ElementType" }, ""));
  stored.AreCompressed = header.IsTrue({ "CompressedData" });
  stored.AreSwapped = WidthOfType(stored.Type) > 1 &&
    header.IsTrue({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" }) == IsLittleEndian();
  SetFiles(path, header.Length, FindFiles(header, stream, size[2]), stored);
  const bool isBinary = header.IsTrue({ "BinaryData" });
  SkipHeader(header, size, stored);
  CheckValues(stored, size, isBinary);
  image.ReadsParts = isBinary && !stored.AreCompressed;
  image.Read = [stored, size, isBinary](const IndexBox& box)
  {
    return isBinary ? ReadStored(stored, size, box)
                    : ReadNumbers(stored, box.NumberOfCells()); // box of the whole image
  };
  return image;
}

} // namespace vfm
