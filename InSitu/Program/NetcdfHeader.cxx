#include "NetcdfHeader.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <vector>

namespace vfm
{
namespace
{

constexpr std::int64_t Unknown = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t Streamed = 0xffffffff; // records that were not counted
constexpr std::int64_t LargestCount = std::int64_t(1) << 50;
constexpr int Sizes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 }; // in bytes, of types 1..11
constexpr int ListOfDimensions = 10, ListOfVariables = 11, ListOfAttributes = 12;

/// Reads a header number by number; all are big-endian.
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
      this->SkipText();
      this->Dimensions.push_back(this->ReadCount());
    }
    this->SkipAttributes();
    std::int64_t size = 0, recordSize = 0, recordsEnd = 0, lastSize = 0;
    int recordVariables = 0;
    for (std::int64_t left = this->ReadList(ListOfVariables); left > 0 && this->Stream; --left)
    {
      const Variable variable = this->ReadVariable();
      const std::int64_t end = variable.Begin + variable.Size;
      if (variable.IsRecord)
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
      const std::int64_t step = recordVariables == 1 ? lastSize : recordSize; // one is not padded
      size = std::max(size, recordsEnd + (records - 1) * step);
    }
    return { this->Stream ? size : Unknown, records };
  }

private:
  struct Variable
  {
    std::int64_t Begin, Size; // in bytes, of a record where it IsRecord
    bool IsRecord;
  };

  static std::int64_t Padded(std::int64_t size) { return (size + 3) / 4 * 4; }

  /// A header that is not good counts as one that is cut off.
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
  /// The length of the list that follows, which may be missing.
  std::int64_t ReadList(int kind)
  {
    const std::int64_t tag = this->ReadNumber(4), count = this->ReadCount();
    this->Check(tag == kind || (tag == 0 && count == 0));
    return count;
  }
  void Skip(std::int64_t size) { this->Stream.seekg(Padded(size), std::ios::cur); }
  void SkipText() { this->Skip(this->ReadCount()); }
  int ReadTypeSize()
  {
    const std::int64_t type = this->ReadNumber(4);
    this->Check(type >= 1 && type <= 11);
    return this->Stream ? Sizes[type] : 0;
  }
  void SkipAttributes()
  {
    for (std::int64_t left = this->ReadList(ListOfAttributes); left > 0 && this->Stream; --left)
    {
      this->SkipText();
      const int size = this->ReadTypeSize();
      this->Skip(this->ReadCount() * size);
    }
  }
  Variable ReadVariable()
  {
    this->SkipText();
    Variable variable{ 0, 1, false };
    for (std::int64_t left = this->ReadCount(); left > 0 && this->Stream; --left)
    {
      const std::int64_t dimension = this->ReadCount();
      const bool isKnown = dimension < static_cast<std::int64_t>(this->Dimensions.size());
      const std::int64_t length = isKnown ? this->Dimensions[dimension] : 0;
      variable.IsRecord = variable.IsRecord || length == 0; // the unlimited one
      this->Check(length == 0 || variable.Size <= LargestCount / length);
      variable.Size *= this->Stream && length > 0 ? length : 1;
    }
    this->SkipAttributes();
    variable.Size *= this->ReadTypeSize();
    this->ReadCount(); // the size, which is cut where it needs more bits
    variable.Begin = this->ReadNumber(this->Version == 1 ? 4 : 8);
    return variable;
  }

  std::ifstream Stream;
  int Version = 0;
  std::vector<std::int64_t> Dimensions; // 0: that of the records
};

} // namespace

std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path)
{
  HeaderReader reader(path);
  return reader.IsClassic() ? std::optional<NetcdfHeader>(reader.Read()) : std::nullopt;
}

} // namespace vfm
