/**
 * WriteNetcdf4: a file of netCDF-4, written by the netCDF library.
 */
#pragma once

#include "Meshes/NetcdfLayout.h"

namespace vfm
{

/// @return false in builds without the library. Throws InputError, with the reason but without the path, when the file cannot be
/// written; then it is removed.
bool TryWriteNetcdf4(const NetcdfLayout& layout, const std::string& path);

} // namespace vfm
