/**
 * NetcdfHeader: reads the header of a netCDF file in a classic format, as most Exodus files are.
 *
 * The netCDF library reads missing parts of a truncated file as zeros, without an error. The header
 * gives the required length of the file ("NetCDF Classic Format Specification", versions CDF-1,
 * CDF-2 and CDF-5).
 */
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

enum class NetcdfType
{
  Char = 2,
  Int = 4,
  Double = 6
};

/// Header of a netCDF file.
struct NetcdfHeader
{
  struct Dimension
  {
    std::string Name;
    std::int64_t Length; ///< length; 0 for the dimension of records
  };
  struct Attribute
  {
    std::string Name;
    int Type; ///< type code of the format, 1 to 11; see NetcdfType
  };
  struct Variable
  {
    std::string Name;
    int Type;
    std::int64_t Begin, Size; ///< place and size of the values, or of one record, bytes
    bool HasRecords;
  };

  /// Minimum length of the file, bytes; std::numeric_limits<std::int64_t>::max() if the header
  /// itself is truncated or damaged.
  std::int64_t Size;
  std::int64_t Records; ///< number of records, in Exodus files of times; 0 if unknown
  std::vector<Dimension> Dimensions;
  std::vector<Attribute> Attributes; ///< attributes of the file
  std::vector<Variable> Variables;
};

/// Reads the header of a file.
/// @return nothing for files of another format (the HDF5 library itself checks netCDF-4 files)
std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path);

/// Reads the numbers of an int variable without records. The file must not be truncated.
std::vector<std::int32_t> ReadNetcdfInts(
  const std::string& path, const NetcdfHeader::Variable& variable);

} // namespace vfm
