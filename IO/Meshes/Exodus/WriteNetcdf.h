/**
 * WriteNetcdf: writes a netCDF file from its description.
 */
#pragma once

#include "Meshes/Exodus/NetcdfLayout.h"
#include "Meshes/Files/OutputSet.h"

namespace vfm
{

enum class NetcdfFormat
{
  Classic, ///< classic with 64-bit offsets; variables up to 4 GiB - 4 bytes, without WideInt
  Wide     ///< netCDF-4; in builds without the netCDF library, classic with 64-bit data
};

/// Writes a file of a set. Only the values of one variable are in memory at a time.
/// @throws InputError  if the file cannot be written; the message holds the reason, not the path.
///   The earlier file then remains
void WriteNetcdf(
  const NetcdfLayout& layout, const std::string& path, NetcdfFormat format, OutputSet& files);

} // namespace vfm
