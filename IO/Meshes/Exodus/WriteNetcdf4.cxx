#include "Meshes/Exodus/WriteNetcdf4.h"

#ifdef VFM_HAS_NETCDF

#include "Meshes/Files/OutputSet.h"
#include "Ranks/Errors.h"

#include <netcdf.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace vfm
{
namespace
{

constexpr nc_type TypeOf[] = { NC_CHAR, NC_INT, NC_INT64, NC_DOUBLE };

/// Throws InputError if a function of the library has failed.
/// @param status  result of the function
void Check(int status)
{
  if (status != NC_NOERR)
  {
    const bool isOfSystem = status > 0 || (status == NC_EHDFERR && errno != 0);
    const char* reason =
      isOfSystem ? std::strerror(status > 0 ? status : errno) : nc_strerror(status);
    throw InputError(reason + std::string("."));
  }
}

/// Open file, which the destructor closes.
struct OpenNetcdf
{
  explicit OpenNetcdf(const std::string& path)
  {
    const auto held = HoldUnfinishedPaths(); // the file is not created again when it was removed
    errno = 0;
    Check(nc_create(path.c_str(), NC_CLOBBER | NC_NETCDF4, &this->Id));
  }
  ~OpenNetcdf()
  {
    if (this->Id >= 0)
    {
      nc_close(this->Id);
    }
  }
  OpenNetcdf(const OpenNetcdf&) = delete;
  OpenNetcdf& operator=(const OpenNetcdf&) = delete;
  void Close() { Check(nc_close(std::exchange(this->Id, -1))); }

  int Id = -1;
};

void PutAttribute(int file, int variable, const std::string& name, const std::string& text)
{
  Check(nc_put_att_text(file, variable, name.c_str(), text.size(), text.data()));
}

void Define(int file, const NetcdfLayout& layout, std::vector<int>& variables)
{
  std::vector<int> dimensions;
  for (const NetcdfDimension& dimension : layout.Dimensions)
  {
    Check(nc_def_dim(file, dimension.Name.c_str(), static_cast<std::size_t>(dimension.Length),
      &dimensions.emplace_back()));
  }
  for (const auto& attribute : layout.Attributes)
  {
    const char* name = attribute.first.c_str();
    if (const auto* text = std::get_if<std::string>(&attribute.second))
    {
      PutAttribute(file, NC_GLOBAL, name, *text);
    }
    else if (const auto* integer = std::get_if<int>(&attribute.second))
    {
      Check(nc_put_att_int(file, NC_GLOBAL, name, NC_INT, 1, integer));
    }
    else
    {
      const float real = std::get<float>(attribute.second);
      Check(nc_put_att_float(file, NC_GLOBAL, name, NC_FLOAT, 1, &real));
    }
  }
  for (const NetcdfVariable& variable : layout.Variables)
  {
    std::vector<int> ids;
    for (std::size_t dimension : variable.Dimensions)
    {
      ids.push_back(dimensions[dimension]);
    }
    Check(nc_def_var(file, variable.Name.c_str(), TypeOf[static_cast<int>(variable.Kind)],
      static_cast<int>(ids.size()), ids.data(), &variables.emplace_back()));
    for (const NetcdfText& attribute : variable.Attributes)
    {
      PutAttribute(file, variables.back(), attribute.Name, attribute.Value);
    }
  }
  int oldMode = 0;
  Check(nc_set_fill(file, NC_NOFILL, &oldMode));
  Check(nc_enddef(file));
}

/// Consecutive values of a variable.
struct Slab
{
  std::vector<std::size_t> Starts, Counts; ///< along each dimension

  /// @param first,count  place and number of the values
  Slab(const NetcdfLayout& layout, const NetcdfVariable& variable, std::size_t first,
    std::size_t count) :
    Starts(variable.Dimensions.size(), 0)
  {
    for (std::size_t dimension : variable.Dimensions)
    {
      const Index length = layout.Dimensions[dimension].Length;
      this->Counts.push_back(static_cast<std::size_t>(std::max<Index>(length, 1)));
    }
    std::size_t cut = 0, stride = 1; // only dimensions of length 1 are before the cut one
    while (cut + 1 < this->Counts.size() && this->Counts[cut] == 1)
    {
      ++cut;
    }
    for (std::size_t d = cut + 1; d < this->Counts.size(); ++d)
    {
      stride *= this->Counts[d];
    }
    if (cut < this->Counts.size())
    {
      this->Starts[cut] = first / stride;
      this->Counts[cut] = count / stride;
    }
  }
};

void PutSlab(int file, int id, const Slab& slab, const NetcdfValues& values)
{
  const std::vector<std::size_t>&starts = slab.Starts, &counts = slab.Counts;
  if (const auto* text = std::get_if<std::string>(&values))
  {
    Check(nc_put_vara_text(file, id, starts.data(), counts.data(), text->data()));
  }
  else if (const auto* integers = std::get_if<std::vector<Index>>(&values))
  {
    const std::vector<long long> numbers(integers->begin(), integers->end());
    Check(nc_put_vara_longlong(file, id, starts.data(), counts.data(), numbers.data()));
  }
  else
  {
    Check(nc_put_vara_double(
      file, id, starts.data(), counts.data(), std::get<std::vector<double>>(values).data()));
  }
}

void PutVariable(int file, int id, const NetcdfLayout& layout, const NetcdfVariable& variable)
{
  std::size_t first = 0;
  variable.Put(
    [&](const NetcdfValues& values)
    {
      const std::size_t count = std::visit([](const auto& list) { return list.size(); }, values);
      PutSlab(file, id, Slab(layout, variable, first, count), values);
      first += count;
    });
}

} // namespace

bool TryWriteNetcdf4(const NetcdfLayout& layout, const std::string& path, OutputSet& files)
{
  const std::string begun = files.Create(path, Naming::AtOnce);
  OpenNetcdf file(begun);
  std::vector<int> variables;
  Define(file.Id, layout, variables);
  for (std::size_t v = 0; v < variables.size(); ++v)
  {
    PutVariable(file.Id, variables[v], layout, layout.Variables[v]);
  }
  file.Close();
  SyncFile(begun);
  return true;
}

} // namespace vfm

#else

namespace vfm
{

bool TryWriteNetcdf4(const NetcdfLayout&, const std::string&, OutputSet&)
{
  return false;
}

} // namespace vfm

#endif
