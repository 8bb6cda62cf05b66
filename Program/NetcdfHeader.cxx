#include "NetcdfHeader.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace vfm
{
namespace
{

constexpr std::int64_t Unknown = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t Streamed = 0xffffffff; // code of an unknown number of records; CDF-5: -1
constexpr std::int64_t LargestCount = std::int64_t(1) << 50;
constexpr std::int64_t LongestName = 1024;
constexpr std::int64_t LargestPlace = std::int64_t(1) << 61;    // the sum of three is an int64
constexpr int Sizes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 }; // bytes, by type code 1 to 11
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
    const std::int64_t records = this->ReadRecords();
    for (std::int64_t left = this->ReadList(ListOfDimensions); left > 0 && this->Stream; --left)
    {
      const std::string name = this->ReadName();
      this->Dimensions.push_back({ name, this->ReadCount() });
    }
    NetcdfHeader header{ Unknown, records, this->Dimensions, this->ReadAttributes(), {} };
    for (std::int64_t left = this->ReadList(ListOfVariables); left > 0 && this->Stream; --left)
    {
      header.Variables.push_back(this->ReadVariable());
    }
    header.Size = this->FindSize(header);
    return header;
  }

private:
  static std::int64_t Padded(std::int64_t size) { return (size + 3) / 4 * 4; }

  /// Returns the minimum length of the file; Unknown if the header is invalid.
  std::int64_t FindSize(const NetcdfHeader& header)
  {
    std::int64_t size = 0, recordSize = 0, recordsEnd = 0, lastSize = 0;
    int recordVariables = 0;
    for (const NetcdfHeader::Variable& variable : header.Variables)
    {
      const std::int64_t end = variable.Begin + variable.Size;
      if (variable.HasRecords)
      {
        lastSize = variable.Size;
        recordSize = std::min(recordSize + Padded(lastSize), LargestPlace);
        recordsEnd = std::max(recordsEnd, end);
        ++recordVariables;
      }
      else
      {
        size = std::max(size, end);
      }
    }
    if (header.Records > 0 && recordVariables > 0)
    {
      // Records of a single variable are not padded.
      const std::int64_t step = recordVariables == 1 ? lastSize : recordSize;
      this->Check(step == 0 || header.Records - 1 <= LargestPlace / step);
      size = this->Stream ? std::max(size, recordsEnd + (header.Records - 1) * step) : Unknown;
    }
    return this->Stream ? size : Unknown;
  }

  /// Treats an invalid header like a truncated one.
  void Check(bool isGood)
  {
    if (!isGood)
    {
      this->Stream.setstate(std::ios::failbit);
    }
  }
  std::int64_t ReadNumber(int bytes)
  {
    std::uint64_t number = 0;
    for (int b = 0; b < bytes; ++b)
    {
      number = number << 8 | static_cast<unsigned char>(this->Stream.get());
    }
    return static_cast<std::int64_t>(number);
  }
  /// Reads a number that must lie in a range; returns 0 if it does not.
  std::int64_t ReadIn(int bytes, std::int64_t most)
  {
    const std::int64_t number = this->ReadNumber(bytes);
    this->Check(number >= 0 && number <= most);
    return this->Stream ? number : 0;
  }
  std::int64_t ReadCount() { return this->ReadIn(this->Version == 5 ? 8 : 4, LargestCount); }
  /// Reads the number of records; 0 if the file does not contain it.
  std::int64_t ReadRecords()
  {
    const std::int64_t records = this->ReadNumber(this->Version == 5 ? 8 : 4);
    const bool isStreamed = records == (this->Version == 5 ? -1 : Streamed);
    this->Check(isStreamed || (records >= 0 && records <= LargestCount));
    return this->Stream && !isStreamed ? records : 0;
  }
  /// Reads the length of the list that follows; 0 if the list is missing.
  std::int64_t ReadList(int kind)
  {
    const std::int64_t tag = this->ReadNumber(4), count = this->ReadCount();
    this->Check(tag == kind || (tag == 0 && count == 0));
    return this->Stream ? count : 0;
  }
  void Skip(std::int64_t size) { this->Stream.seekg(size, std::ios::cur); }
  std::string ReadName()
  {
    const std::int64_t length = this->ReadIn(this->Version == 5 ? 8 : 4, LongestName);
    std::string name(length, '\0');
    this->Stream.read(&name[0], length);
    this->Skip(Padded(length) - length);
    return name;
  }
  /// Reads a type code; returns 0 if it is invalid.
  int ReadType()
  {
    const int type = static_cast<int>(this->ReadIn(4, 11));
    this->Check(type >= 1);
    return type;
  }
  std::vector<NetcdfHeader::Attribute> ReadAttributes()
  {
    std::vector<NetcdfHeader::Attribute> attributes;
    for (std::int64_t left = this->ReadList(ListOfAttributes); left > 0 && this->Stream; --left)
    {
      const std::string name = this->ReadName();
      attributes.push_back({ name, this->ReadType() });
      this->Skip(Padded(this->ReadCount() * Sizes[attributes.back().Type]));
    }
    return attributes;
  }
  /// Reads the number of a dimension and returns this dimension.
  NetcdfHeader::Dimension ReadDimension()
  {
    const auto number = static_cast<std::size_t>(this->ReadCount());
    this->Check(number < this->Dimensions.size());
    return this->Stream ? this->Dimensions[number] : NetcdfHeader::Dimension{ "", 1 };
  }
  NetcdfHeader::Variable ReadVariable()
  {
    NetcdfHeader::Variable variable{ this->ReadName(), 0, 0, 1, false };
    const std::int64_t rank = this->ReadCount();
    for (std::int64_t d = 0; d < rank && this->Stream; ++d)
    {
      const std::int64_t length = this->ReadDimension().Length;
      const bool isOfRecords = length == 0; // the unlimited dimension, only the first one
      this->Check(isOfRecords ? d == 0 : variable.Size <= LargestCount / length);
      variable.HasRecords = variable.HasRecords || isOfRecords;
      variable.Size *= this->Stream && !isOfRecords ? length : 1;
    }
    this->ReadAttributes();
    variable.Type = this->ReadType();
    variable.Size *= Sizes[variable.Type];
    this->ReadCount(); // the size is not used, because it is wrong if it needs more bits
    variable.Begin = this->ReadIn(this->Version == 1 ? 4 : 8, LargestPlace);
    return variable;
  }

  std::ifstream Stream;
  int Version = 0;
  std::vector<NetcdfHeader::Dimension> Dimensions;
};

} // namespace

std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path)
{
  HeaderReader reader(path);
  return reader.IsClassic() ? std::optional<NetcdfHeader>(reader.Read()) : std::nullopt;
}

std::vector<std::int32_t> ReadNetcdfInts(
  const std::string& path, const NetcdfHeader::Variable& variable)
{
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(variable.Begin);
  std::vector<std::int32_t> numbers(variable.Size / 4);
  for (std::int32_t& number : numbers)
  {
    std::uint32_t bits = 0;
    for (int b = 0; b < 4; ++b)
    {
      bits = bits << 8 | static_cast<unsigned char>(stream.get());
    }
    number = static_cast<std::int32_t>(bits);
  }
  return numbers;
}

} // namespace vfm
