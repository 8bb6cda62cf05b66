#include "NetcdfHeader.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace vfm
{
namespace
{

constexpr std::int64_t Unknown = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t Streamed = 0xffffffff; // code of an unknown number of records
constexpr std::int64_t LargestCount = std::int64_t(1) << 50;
constexpr std::int64_t LongestName = 1024;
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
    const std::int64_t records = this->ReadCount();
    for (std::int64_t left = this->ReadList(ListOfDimensions); left > 0 && this->Stream; --left)
    {
      const std::string name = this->ReadName();
      this->Dimensions.push_back({ name, this->ReadCount() });
    }
    NetcdfHeader header{ Unknown, records, this->Dimensions, this->ReadAttributes(), {} };
    std::int64_t size = 0, recordSize = 0, recordsEnd = 0, lastSize = 0;
    int recordVariables = 0;
    for (std::int64_t left = this->ReadList(ListOfVariables); left > 0 && this->Stream; --left)
    {
      header.Variables.push_back(this->ReadVariable());
      const NetcdfHeader::Variable& variable = header.Variables.back();
      const std::int64_t end = variable.Begin + variable.Size;
      if (variable.HasRecords)
      {
        lastSize = variable.Size;
        recordSize += Padded(lastSize);
        recordsEnd = std::max(recordsEnd, end);
        ++recordVariables;
      }
      else
      {
        size = std::max(size, end);
      }
    }
    if (records > 0 && records != Streamed && recordVariables > 0)
    {
      // Records of a single variable are not padded.
      const std::int64_t step = recordVariables == 1 ? lastSize : recordSize;
      size = std::max(size, recordsEnd + (records - 1) * step);
    }
    header.Size = this->Stream ? size : Unknown;
    return header;
  }

private:
  static std::int64_t Padded(std::int64_t size) { return (size + 3) / 4 * 4; }

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
  std::int64_t ReadCount()
  {
    const std::int64_t count = this->ReadNumber(this->Version == 5 ? 8 : 4);
    this->Check(count >= 0 && count <= LargestCount);
    return count;
  }
  /// Reads the length of the list that follows; 0 if the list is missing.
  std::int64_t ReadList(int kind)
  {
    const std::int64_t tag = this->ReadNumber(4), count = this->ReadCount();
    this->Check(tag == kind || (tag == 0 && count == 0));
    return count;
  }
  void Skip(std::int64_t size) { this->Stream.seekg(size, std::ios::cur); }
  std::string ReadName()
  {
    const std::int64_t length = this->ReadCount();
    this->Check(length <= LongestName);
    std::string name(this->Stream ? length : 0, '\0');
    this->Stream.read(&name[0], length);
    this->Skip(Padded(length) - length);
    return name;
  }
  /// Reads a type code; returns 0 if it is invalid.
  int ReadType()
  {
    const std::int64_t type = this->ReadNumber(4);
    this->Check(type >= 1 && type <= 11);
    return this->Stream ? static_cast<int>(type) : 0;
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
  NetcdfHeader::Variable ReadVariable()
  {
    NetcdfHeader::Variable variable{ this->ReadName(), 0, 0, 1, false };
    for (std::int64_t left = this->ReadCount(); left > 0 && this->Stream; --left)
    {
      const std::int64_t dimension = this->ReadCount();
      const bool isKnown = dimension < static_cast<std::int64_t>(this->Dimensions.size());
      const std::int64_t length = isKnown ? this->Dimensions[dimension].Length : 0;
      variable.HasRecords = variable.HasRecords || length == 0; // 0: unlimited dimension
      this->Check(length == 0 || variable.Size <= LargestCount / length);
      variable.Size *= this->Stream && length > 0 ? length : 1;
    }
    this->ReadAttributes();
    variable.Type = this->ReadType();
    variable.Size *= Sizes[variable.Type];
    this->ReadCount(); // the size is not used, because it is wrong if it needs more bits
    variable.Begin = this->ReadNumber(this->Version == 1 ? 4 : 8);
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
