#include "Blocks/NetcdfFile.h"

#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace vfm
{
namespace
{

constexpr const char* Damaged = "the file is truncated or damaged.";

/// Calls visit with a number of the C++ type of a type of numbers.
template <class Visit>
void VisitNumber(NetcdfType type, const Visit& visit)
{
  switch (type)
  {
    case NetcdfType::Byte:
      return visit(std::int8_t());
    case NetcdfType::Short:
      return visit(std::int16_t());
    case NetcdfType::Int:
      return visit(std::int32_t());
    case NetcdfType::Float:
      return visit(float());
    case NetcdfType::Double:
      return visit(double());
    case NetcdfType::UnsignedByte:
      return visit(std::uint8_t());
    case NetcdfType::UnsignedShort:
      return visit(std::uint16_t());
    case NetcdfType::UnsignedInt:
      return visit(std::uint32_t());
    case NetcdfType::Int64:
      return visit(std::int64_t());
    case NetcdfType::UnsignedInt64:
      return visit(std::uint64_t());
    default:
      throw InputError("the file is damaged: text stands in place of numbers.");
  }
}

/// File in a classic format. All numbers are big endian.
class ClassicFile : public NetcdfFile
{
public:
  ClassicFile(const std::string& path, NetcdfHeader header) :
    NetcdfFile(std::move(header)), Stream(OpenFile(path))
  {
  }

protected:
  void Read(const StoredVariable& variable, Index record, std::span<double> values) override
  {
    this->ReadNumbers(variable, record, values);
  }
  void Read(const StoredVariable& variable, Index record, std::span<Index> values) override
  {
    this->ReadNumbers(variable, record, values);
  }
  void Read(const StoredVariable& variable, Index record, std::span<char> text) override
  {
    this->Seek(variable, record);
    this->ReadBytes(text.data(), text.size());
  }

private:
  template <class To>
  void ReadNumbers(const StoredVariable& variable, Index record, std::span<To> values)
  {
    this->Seek(variable, record);
    VisitNumber(variable.Type, [&](auto number) { this->ReadStored<decltype(number)>(values); });
  }

  template <class Stored, class To>
  void ReadStored(std::span<To> values)
  {
    constexpr std::size_t most = 1 << 16; // values that are read at once
    std::vector<Stored> part(std::min(values.size(), most));
    while (!values.empty())
    {
      const std::size_t count = std::min(values.size(), most);
      this->ReadBytes(reinterpret_cast<char*>(part.data()), count * sizeof(Stored));
      std::transform(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count),
        values.begin(),
        [](Stored stored)
        { return static_cast<To>(IsLittleEndian() ? SwapBytes(stored) : stored); });
      values = values.subspan(count);
    }
  }

  void Seek(const StoredVariable& variable, Index record)
  {
    this->Stream.seekg(variable.Begin + record * this->Header().RecordSize);
  }
  void ReadBytes(char* bytes, std::size_t count)
  {
    if (!this->Stream.read(bytes, static_cast<std::streamsize>(count)))
    {
      throw InputError(Damaged);
    }
  }

  std::ifstream Stream;
};

} // namespace

NetcdfFile::NetcdfFile(NetcdfHeader header) : Head(std::move(header))
{
  for (const StoredVariable& variable : this->Head.Variables)
  {
    this->Numbers.emplace(variable.Name, this->Numbers.size());
  }
}

const StoredVariable* NetcdfFile::Find(const std::string& name) const
{
  const auto found = this->Numbers.find(name);
  return found == this->Numbers.end() ? nullptr : &this->Head.Variables[found->second];
}

void NetcdfFile::CheckRecord(const StoredVariable& variable, Index record) const
{
  if (variable.HasRecords && record >= this->Head.Records)
  {
    throw InputError("the file is damaged: '" + variable.Name + "' has no values.");
  }
}

std::vector<double> NetcdfFile::ReadReals(const StoredVariable& variable, Index record)
{
  this->CheckRecord(variable, record);
  std::vector<double> values(variable.Count);
  this->Read(variable, record, std::span(values));
  return values;
}

std::vector<Index> NetcdfFile::ReadIntegers(const StoredVariable& variable)
{
  if (variable.Type == NetcdfType::Float || variable.Type == NetcdfType::Double)
  {
    throw InputError(
      "the file is damaged: the numbers of '" + variable.Name + "' are not integers.");
  }
  this->CheckRecord(variable, 0);
  std::vector<Index> values(variable.Count);
  this->Read(variable, 0, std::span(values));
  return values;
}

std::string NetcdfFile::ReadText(const StoredVariable& variable)
{
  if (variable.Type != NetcdfType::Char)
  {
    throw InputError("the file is damaged: '" + variable.Name + "' is not a text.");
  }
  this->CheckRecord(variable, 0);
  std::string text(variable.Count, '\0');
  this->Read(variable, 0, std::span(text));
  return text;
}

std::unique_ptr<NetcdfFile> OpenNetcdf(const std::string& path)
{
  char magic[4] = {};
  OpenFile(path).read(magic, sizeof(magic));
  if (std::equal(magic, magic + sizeof(magic), "\x89HDF"))
  {
    return OpenNetcdf4(path);
  }
  auto header = ReadNetcdfHeader(path);
  if (!header)
  {
    throw InputError("it is not a netCDF file, or its beginning is damaged.");
  }
  if (GetFileLength(path) < header->Size)
  {
    throw InputError(Damaged);
  }
  return std::make_unique<ClassicFile>(path, std::move(*header));
}

} // namespace vfm
