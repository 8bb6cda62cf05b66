#include "Blocks/NetcdfFile.h"
#include "Ranks/Errors.h"

#ifdef VFM_HAS_NETCDF

#include "Hdf5Check.h"
#include "InputTrust.h"
#include "OpenFile.h"

#include <netcdf.h>

#include <algorithm>
#include <utility>

namespace vfm
{
namespace
{

constexpr Index LargestRatio = 5000; // compression ratio of HDF5 files

void Check(int status)
{
  if (status != NC_NOERR)
  {
    throw InputError(std::string("the file is truncated or damaged: ") + nc_strerror(status) + ".");
  }
}

/// Open file, which the destructor closes.
class Handle
{
public:
  explicit Handle(const std::string& path)
  {
    CheckHdf5(path);
    Check(nc_open(path.c_str(), NC_NOWRITE, &this->Id));
  }
  ~Handle()
  {
    if (this->Id >= 0)
    {
      nc_close(this->Id);
    }
  }
  Handle(Handle&& other) noexcept : Id(std::exchange(other.Id, -1)) {}
  Handle& operator=(Handle&&) = delete;
  int Get() const { return this->Id; }

private:
  int Id = -1;
};

/// Reads the attribute elem_type of a variable; returns an empty text if it has none.
std::string ReadElemType(int file, int variable)
{
  nc_type type;
  std::size_t length;
  if (nc_inq_att(file, variable, "elem_type", &type, &length) != NC_NOERR || type != NC_CHAR ||
    length > NC_MAX_NAME)
  {
    return "";
  }
  std::string text(length, '\0');
  Check(nc_get_att_text(file, variable, "elem_type", text.data()));
  return text.c_str();
}

/// Reads the description of a variable.
/// @param records  number of the dimension of records, or -1
/// @param most  largest number of bytes of a variable
StoredVariable ReadVariable(int file, int number, int records, Index most)
{
  char name[NC_MAX_NAME + 1];
  nc_type type;
  int rank, dimensions[NC_MAX_VAR_DIMS];
  Check(nc_inq_var(file, number, name, &type, &rank, dimensions, nullptr));
  StoredVariable variable;
  variable.Name = name;
  variable.Type =
    type >= NC_BYTE && type <= NC_UINT64 ? static_cast<NetcdfType>(type) : NetcdfType::None;
  for (int d = 0; d < rank; ++d)
  {
    if (d == 0 && dimensions[d] == records)
    {
      variable.HasRecords = true;
      continue;
    }
    std::size_t length;
    Check(nc_inq_dimlen(file, dimensions[d], &length));
    if (length > 0 && variable.Count > most / static_cast<Index>(length))
    {
      throw InputError("the variable '" + variable.Name +
        "' is too large for the length of the file. " + InputTrust::Advice);
    }
    variable.Shape.push_back(static_cast<Index>(length));
    variable.Count *= static_cast<Index>(length);
  }
  variable.ElemType = ReadElemType(file, number);
  return variable;
}

NetcdfHeader ReadHeader(int file, Index length)
{
  int dimensions, variables, records;
  Check(nc_inq(file, &dimensions, &variables, nullptr, &records));
  NetcdfHeader header;
  for (int d = 0; d < dimensions; ++d)
  {
    char name[NC_MAX_NAME + 1];
    std::size_t count;
    Check(nc_inq_dim(file, d, name, &count));
    header.Dimensions.push_back({ name, d == records ? 0 : static_cast<Index>(count) });
    header.Records = d == records ? static_cast<Index>(count) : header.Records;
  }
  constexpr Index largest = Index(1) << 50;
  const Index most = InputTrust::IsGiven() ? largest : std::min(largest, length * LargestRatio);
  for (int v = 0; v < variables; ++v)
  {
    header.Variables.push_back(ReadVariable(file, v, records, most));
  }
  return header;
}

class Netcdf4File : public NetcdfFile
{
public:
  Netcdf4File(Handle file, NetcdfHeader header) :
    NetcdfFile(std::move(header)), File(std::move(file))
  {
  }

protected:
  void Read(const StoredVariable& variable, Index record, std::span<double> values) override
  {
    this->Get(nc_get_vara_double, variable, record, values.data());
  }
  void Read(const StoredVariable& variable, Index record, std::span<Index> values) override
  {
    static_assert(sizeof(Index) == sizeof(long));
    this->Get(nc_get_vara_long, variable, record, values.data());
  }
  void Read(const StoredVariable& variable, Index record, std::span<char> text) override
  {
    this->Get(nc_get_vara_text, variable, record, text.data());
  }

private:
  /// Reads a variable, or one of its records, by a function of the library.
  template <class Function, class Value>
  void Get(Function get, const StoredVariable& variable, Index record, Value* values)
  {
    int number;
    Check(nc_inq_varid(this->File.Get(), variable.Name.c_str(), &number));
    std::vector<std::size_t> start(variable.Shape.size(), 0),
      count(variable.Shape.begin(), variable.Shape.end());
    if (variable.HasRecords)
    {
      start.insert(start.begin(), record);
      count.insert(count.begin(), 1);
    }
    Check(get(this->File.Get(), number, start.data(), count.data(), values));
  }

  Handle File;
};

} // namespace

std::unique_ptr<NetcdfFile> OpenNetcdf4(const std::string& path)
{
  Handle file(path);
  NetcdfHeader header = ReadHeader(file.Get(), GetFileLength(path));
  return std::make_unique<Netcdf4File>(std::move(file), std::move(header));
}

} // namespace vfm

#else

namespace vfm
{

std::unique_ptr<NetcdfFile> OpenNetcdf4(const std::string&)
{
  throw InputError("its format is netCDF-4 (HDF5), which needs the netCDF library, and this build "
                   "has none. Convert the file: nccopy -k cdf5 OLD NEW.");
}

} // namespace vfm

#endif
