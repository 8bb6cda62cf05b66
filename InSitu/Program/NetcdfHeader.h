/**
 * NetcdfHeader: whether a netCDF file of the classic kind, as most Exodus files are, is whole.
 *
 * The netCDF library reads what is cut off as zeros and says nothing. The header tells how long the file must be ("NetCDF
 * Classic Format Specification", versions CDF-1, CDF-2 and CDF-5).
 */
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vfm
{

struct NetcdfHeader
{
  std::int64_t
    Size; ///< bytes that the file must have at least; std::numeric_limits<std::int64_t>::max() where the
          ///< header itself is cut off or damaged
  std::int64_t Records; ///< in Exodus files: times
};

/// Nothing for files of another kind (netCDF-4, which the HDF5 library checks itself).
std::optional<NetcdfHeader> ReadNetcdfHeader(const std::string& path);

} // namespace vfm
