/**
 * NetcdfHeader: reads the header of a netCDF file in a classic format, as most Exodus files are.
 *
 * The netCDF library reads missing parts of a truncated file as zeros, without an error. The header
 * gives the required length of the file ("NetCDF Classic Format Specification", versions CDF-1,
 * CDF-2 and CDF-5).
 */
#pragma once

#include "Base/IndexBox.h"

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Type codes of the format.
enum class NetcdfType
{
  None,
  Byte,
  Char,
  Short,
  Int,
  Float,
  Double,
  UnsignedByte,
  UnsignedShort,
  UnsignedInt,
  Int64,
  UnsignedInt64
};

/// Returns the size of a value, bytes.
Index WidthOf(NetcdfType type);

/// Variable of a netCDF file.
struct StoredVariable
{
  std::string Name;
  NetcdfType Type = NetcdfType::None;
  std::vector<Index> Shape; ///< lengths of the dimensions, without that of records
  bool HasRecords = false;
  Index Count = 1;      ///< number of values, of one record
  Index Begin = 0;      ///< place of the values in the file, bytes; the first record
  std::string ElemType; ///< attribute elem_type of Exodus
};

/// Header of a netCDF file.
struct NetcdfHeader
{
  struct Dimension
  {
    std::string Name;
    Index Length; ///< length; 0 for the dimension of records
  };

  /// Minimum length of the file, bytes; the largest number if the header itself is truncated or
  /// damaged.
  Index Size = 0;
  Index Records = 0;    ///< number of records, in Exodus files of times; 0 if unknown
  Index RecordSize = 0; ///< distance of records, bytes
  std::vector<Dimension> Dimensions;
  std::vector<StoredVariable> Variables;
};

/// Reads the header of a file.
/// @return nothing for files of another format
std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path);

} // namespace vfm
