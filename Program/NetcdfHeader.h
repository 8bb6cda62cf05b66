/**
 * NetcdfHeader: whether a netCDF file of the classic kind, as most Exodus files are, is whole, and some of what it holds.
 *
 * The netCDF library reads what is cut off as zeros and says nothing. The header tells how long the file must be ("NetCDF
 * Classic Format Specification", versions CDF-1, CDF-2 and CDF-5).
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

struct NetcdfHeader
{
  struct Dimension
  {
    std::string Name;
    std::int64_t Length; ///< 0: that of the records
  };
  struct Attribute
  {
    std::string Name;
    int Type; ///< NetcdfType, or another of the format's 1..11
  };
  struct Variable
  {
    std::string Name;
    int Type;
    std::int64_t Begin, Size; ///< in bytes, of a record where it has records
    bool HasRecords;
  };

  std::int64_t
    Size; ///< bytes that the file must have at least; std::numeric_limits<std::int64_t>::max() where the
          ///< header itself is cut off or damaged
  std::int64_t Records; ///< in Exodus files: times
  std::vector<Dimension> Dimensions;
  std::vector<Attribute> Attributes; ///< of the whole file
  std::vector<Variable> Variables;
};

/// Nothing for files of another kind (netCDF-4, which the HDF5 library checks itself).
std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path);

/// The numbers of an int variable without records of a whole file.
std::vector<std::int32_t> ReadNetcdfInts(
  const std::string& path, const NetcdfHeader::Variable& variable);

} // namespace vfm
