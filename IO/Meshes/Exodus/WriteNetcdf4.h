/**
 * WriteNetcdf4: writes a file in the format netCDF-4 by the netCDF library.
 */
#pragma once

#include "Meshes/Exodus/NetcdfLayout.h"
#include "Meshes/Files/OutputSet.h"

namespace vfm
{

/// Writes a file of a set.
/// @return false in builds without the library, where no file is written
/// @throws InputError  if the file cannot be written; the message holds the reason, not the path.
///   The earlier file then remains
bool TryWriteNetcdf4(const NetcdfLayout& layout, const std::string& path, OutputSet& files);

} // namespace vfm
