/**
 * WriteNetcdf4: writes a file in the format netCDF-4 by the netCDF library.
 */
#pragma once

#include "Meshes/Exodus/NetcdfLayout.h"

namespace vfm
{

/// Writes a file.
/// @return false in builds without the library, where no file is written
/// @throws InputError  if the file cannot be written; the message holds the reason, not the path.
///   An incomplete file is removed
bool TryWriteNetcdf4(const NetcdfLayout& layout, const std::string& path);

} // namespace vfm
