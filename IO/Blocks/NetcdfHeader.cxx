#include "Blocks/NetcdfHeader.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace vfm
{
namespace
{

constexpr Index Unknown = std::numeric_limits<Index>::max();
constexpr Index Streamed = 0xffffffff; // code of an unknown number of records; CDF-5: -1
constexpr Index LargestCount = Index(1) << 50;
constexpr Index LongestName = 1024;
constexpr Index LargestPlace = Index(1) << 61; // the sum of three is an int64
constexpr const char* ElementType = "elem_type";
constexpr int ListOfDimensions = 10, ListOfVariables = 11, ListOfAttributes = 12;

/// Reads a header number by number; all numbers are big endian.
class HeaderReader
{
public:
  explicit HeaderReader(const std::string& path) : Stream(path, std::ios::binary)
  {
    char magic[4] = {};
    this->Stream.read(magic, 4);
    if (std::string(magic, 3) == "CDF" && (magic[3] == 1 || magic[3] == 2 || magic[3] == 5))
    {
      this->Version = magic[3];
    }
  }
  bool IsClassic() const { return this->Version > 0; }

  NetcdfHeader Read()
  {
    const Index records = this->ReadRecords();
    for (Index left = this->ReadList(ListOfDimensions); left > 0 && this->Stream; --left)
    {
      const std::string name = this->ReadName();
      this->Dimensions.push_back({ name, this->ReadCount() });
    }
    this->ReadAttributes();
    NetcdfHeader header{ 0, records, 0, this->Dimensions, {} };
    for (Index left = this->ReadList(ListOfVariables); left > 0 && this->Stream; --left)
    {
      header.Variables.push_back(this->ReadVariable());
    }
    this->FindSize(header);
    return header;
  }

private:
  static Index Padded(Index size) { return (size + 3) / 4 * 4; }

  /// Finds the distance of records and the minimum length of the file; Unknown if the header is
  /// invalid.
  void FindSize(NetcdfHeader& header)
  {
    Index size = 0, recordsEnd = 0, lastSize = 0;
    int recordVariables = 0;
    for (const StoredVariable& variable : header.Variables)
    {
      const Index bytes = variable.Count * WidthOf(variable.Type), end = variable.Begin + bytes;
      if (variable.HasRecords)
      {
        lastSize = bytes;
        header.RecordSize = std::min(header.RecordSize + Padded(bytes), LargestPlace);
        recordsEnd = std::max(recordsEnd, end);
        ++recordVariables;
      }
      else
      {
        size = std::max(size, end);
      }
    }
    // Records of a single variable are not padded.
    header.RecordSize = recordVariables == 1 ? lastSize : header.RecordSize;
    if (header.Records > 0 && recordVariables > 0)
    {
      const Index step = header.RecordSize;
      this->Check(step == 0 || header.Records - 1 <= LargestPlace / step);
      size = this->Stream ? std::max(size, recordsEnd + (header.Records - 1) * step) : Unknown;
    }
    header.Size = this->Stream ? size : Unknown;
  }

  /// Treats an invalid header like a truncated one.
  void Check(bool isGood)
  {
    if (!isGood)
    {
      this->Stream.setstate(std::ios::failbit);
    }
  }
  Index ReadNumber(int bytes)
  {
    std::uint64_t number = 0;
    for (int b = 0; b < bytes; ++b)
    {
      number = number << 8 | static_cast<unsigned char>(this->Stream.get());
    }
    return static_cast<Index>(number);
  }
  /// Reads a number that must lie in a range; returns 0 if it does not.
  Index ReadIn(int bytes, Index most)
  {
    const Index number = this->ReadNumber(bytes);
    this->Check(number >= 0 && number <= most);
    return this->Stream ? number : 0;
  }
  Index ReadCount() { return this->ReadIn(this->Version == 5 ? 8 : 4, LargestCount); }
  /// Reads the number of records; 0 if the file does not contain it.
  Index ReadRecords()
  {
    const Index records = this->ReadNumber(this->Version == 5 ? 8 : 4);
    const bool isStreamed = records == (this->Version == 5 ? -1 : Streamed);
    this->Check(isStreamed || (records >= 0 && records <= LargestCount));
    return this->Stream && !isStreamed ? records : 0;
  }
  /// Reads the length of the list that follows; 0 if the list is missing.
  Index ReadList(int kind)
  {
    const Index tag = this->ReadNumber(4), count = this->ReadCount();
    this->Check(tag == kind || (tag == 0 && count == 0));
    return this->Stream ? count : 0;
  }
  void Skip(Index size) { this->Stream.seekg(size, std::ios::cur); }
  std::string ReadName()
  {
    const Index length = this->ReadIn(this->Version == 5 ? 8 : 4, LongestName);
    std::string name(length, '\0');
    this->Stream.read(&name[0], length);
    this->Skip(Padded(length) - length);
    return name;
  }
  /// Reads a type code; returns None if it is invalid.
  NetcdfType ReadType()
  {
    const auto type = static_cast<NetcdfType>(this->ReadIn(4, 11));
    this->Check(type != NetcdfType::None);
    return type;
  }
  /// Reads a list of attributes and returns the text of elem_type, or an empty text.
  std::string ReadAttributes()
  {
    std::string found;
    for (Index left = this->ReadList(ListOfAttributes); left > 0 && this->Stream; --left)
    {
      const std::string name = this->ReadName();
      const NetcdfType type = this->ReadType();
      const Index size = this->ReadCount() * WidthOf(type);
      const bool isWanted = name == ElementType && type == NetcdfType::Char && size <= LongestName;
      std::string text(isWanted && this->Stream ? size : 0, '\0');
      this->Stream.read(text.data(), static_cast<std::streamsize>(text.size()));
      this->Skip(Padded(size) - static_cast<Index>(text.size()));
      found = isWanted ? text.c_str() : found;
    }
    return found;
  }
  /// Reads the number of a dimension and returns this dimension.
  NetcdfHeader::Dimension ReadDimension()
  {
    const auto number = static_cast<std::size_t>(this->ReadCount());
    this->Check(number < this->Dimensions.size());
    return this->Stream ? this->Dimensions[number] : NetcdfHeader::Dimension{ "", 1 };
  }
  StoredVariable ReadVariable()
  {
    StoredVariable variable;
    variable.Name = this->ReadName();
    const Index rank = this->ReadCount();
    for (Index d = 0; d < rank && this->Stream; ++d)
    {
      const Index length = this->ReadDimension().Length;
      const bool isOfRecords = length == 0; // the unlimited dimension, only the first one
      this->Check(isOfRecords ? d == 0 : variable.Count <= LargestCount / length);
      variable.HasRecords = variable.HasRecords || isOfRecords;
      if (this->Stream && !isOfRecords)
      {
        variable.Shape.push_back(length);
        variable.Count *= length;
      }
    }
    variable.ElemType = this->ReadAttributes();
    variable.Type = this->ReadType();
    this->ReadCount(); // the size is not used, because it is wrong if it needs more bits
    variable.Begin = this->ReadIn(this->Version == 1 ? 4 : 8, LargestPlace);
    return variable;
  }

  std::ifstream Stream;
  int Version = 0;
  std::vector<NetcdfHeader::Dimension> Dimensions;
};

} // namespace

Index WidthOf(NetcdfType type)
{
  constexpr int widths[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
  return widths[static_cast<int>(type)];
}

std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path)
{
  HeaderReader reader(path);
  return reader.IsClassic() ? std::optional<NetcdfHeader>(reader.Read()) : std::nullopt;
}

} // namespace vfm
