/**
 * ExodusFileCheck: checks what VTK's reader of Exodus files does not check.
 */
#pragma once

#include <string>

namespace vfm
{

/// Checks a file of an Exodus input if it is in a classic format of netCDF.
/// @param first  first file of the input
/// @throws InputError  (UnreadableInput) if VTK would read zeros because the file is truncated or
///   damaged, would skip the file because its number of times differs from the first file, or would
///   end the program by an assertion
void CheckExodusFile(const std::string& path, const std::string& first);

} // namespace vfm
