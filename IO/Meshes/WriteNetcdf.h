/**
 * WriteNetcdf: a netCDF file from its description.
 */
#pragma once

#include "Meshes/NetcdfLayout.h"

namespace vfm
{

enum class NetcdfFormat
{
  Classic, ///< with 64-bit offsets: for variables of at most 4 GiB - 4 bytes without WideInt
  Wide     ///< netCDF-4; in builds without the netCDF library the classic format with 64-bit data
};

/// Writes the file. At any time the values of one variable are in memory. Throws InputError, with the reason but without the path, when
/// the file cannot be written; then it is removed.
void WriteNetcdf(const NetcdfLayout& layout, const std::string& path, NetcdfFormat format);

} // namespace vfm
